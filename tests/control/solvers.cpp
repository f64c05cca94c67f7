#include "solvers.hpp"

namespace rme {

template class ActiveSetSolver<double, 1, 1>;
template class ActiveSetSolver<float, 2, 2>;
template class ActiveSetSolver<double, 2, 2>;
template class ActiveSetSolver<double, 2, 8>;
template class ActiveSetSolver<float, 2, 28>;
template class ActiveSetSolver<double, 2, 28>;
template class ActiveSetSolver<float, 3, 6>;
template class ActiveSetSolver<double, 3, 6>;
template class ActiveSetSolver<float, 4, 10>;
template class ActiveSetSolver<double, 4, 10>;
template class ActiveSetSolver<float, 6, 28>;
template class ActiveSetSolver<double, 6, 28>;
template class ActiveSetSolver<float, 7, 28>;
template class ActiveSetSolver<double, 7, 28>;
template class Cpic<float, 7>;

}  // namespace rme
