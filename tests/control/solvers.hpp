#pragma once
// The sizes of problem that these tests solve, compiled once, in solvers.cpp.
#include <rme/control/cpic.hpp>

namespace rme {

extern template class ActiveSetSolver<double, 1, 1>;
extern template class ActiveSetSolver<float, 2, 2>;
extern template class ActiveSetSolver<double, 2, 2>;
extern template class ActiveSetSolver<double, 2, 8>;
extern template class ActiveSetSolver<float, 2, 28>;
extern template class ActiveSetSolver<double, 2, 28>;
extern template class ActiveSetSolver<float, 3, 6>;
extern template class ActiveSetSolver<double, 3, 6>;
extern template class ActiveSetSolver<float, 4, 10>;
extern template class ActiveSetSolver<double, 4, 10>;
extern template class ActiveSetSolver<float, 6, 28>;
extern template class ActiveSetSolver<double, 6, 28>;
extern template class ActiveSetSolver<float, 7, 28>;
extern template class ActiveSetSolver<double, 7, 28>;
extern template class Cpic<float, 7>;

}  // namespace rme
