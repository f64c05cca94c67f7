// The controller's quadratic program against the peers that Debian ships, on the same random problems with 14 rows and
// a box, from the same numbers, all cold. The answers are compared in the same run: the program fails if a peer ever
// finds a better point, or agrees on less than half of the problems.
//
//   quadprog   Goldfarb's and Idnani's dual method in Fortran, from R's package (r-cran-quadprog); the box as 14 more
//              rows, since it knows none
//   NLopt      its SLSQP (sequential least squares, Kraft 1988), from the middle of the box
//
// Of the solvers made for such programs (qpOASES, OSQP, eiquadprog, QuadProg++, DAQP, ProxQP) Debian 12 has no package
// (apt-cache policy). It has Ipopt, which is for problems a thousand times as large, and CVXOPT, Octave's qp and CGAL's
// exact solver, which are not for a loop.
#include <nlopt.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <rme/control/active_set_solver.hpp>
#include <vector>

#include "benchmarks/stopwatch.hpp"

namespace {

constexpr int kSize = 7, kRows = 14;
using Solver = rme::ActiveSetSolver<double, kSize, kRows>;
using Vector = Solver::Vector;
using Matrix = Solver::Matrix;

struct Problem {
  Matrix Q, P;
  Vector x_u, x_min, x_max;
  Solver::Rows rows;
};

Vector gaussian(std::mt19937& random) {
  std::normal_distribution<double> normal;
  Vector v;
  for (int i = 0; i < kSize; ++i) v[i] = normal(random);
  return v;
}

/// Q with a condition up to 1000; a feasible point exists, x_u is 0.1 to 10 away from it.
Problem draw(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform;
  Problem p;
  Matrix A;
  for (int j = 0; j < kSize; ++j) A.col(j) = gaussian(random);
  const Matrix V = Eigen::HouseholderQR<Matrix>(A).householderQ();
  Vector eigenvalues;
  for (int j = 0; j < kSize; ++j) eigenvalues[j] = std::pow(10.0, 3 * uniform(random) - 1);
  p.Q = V * eigenvalues.asDiagonal() * V.transpose();
  p.P = V * eigenvalues.cwiseInverse().asDiagonal() * V.transpose();
  const Vector feasible = gaussian(random);
  p.x_u = feasible + std::pow(10.0, 2 * uniform(random) - 1) * gaussian(random);
  p.x_min = feasible.array() - 5;
  p.x_max = feasible.array() + 5;
  for (int i = 0; i < kRows; ++i) {
    const Vector a = gaussian(random).normalized();
    (void)p.rows.add(a, a.dot(feasible) - uniform(random));
  }
  return p;
}

#ifdef RME_WITH_QUADPROG
extern "C" void qpgen2_(double* Q, double* Qx_u, const int* rows_of_Q, const int* size, double* x, double* multipliers,
                        double* value, const double* normals, const double* bounds, const int* rows_of_normals,
                        const int* count, const int* equalities, int* active, int* active_count, int* iterations,
                        double* work, int* error);

/// The problem as quadprog is given it. It writes over Q and Q x_u.
struct Quadprog {
  static constexpr int kCount = kRows + 2 * kSize;
  Matrix Q;
  Vector Qx_u, x = Vector::Zero();
  Eigen::Matrix<double, kSize, kCount> normals;
  Eigen::Matrix<double, kCount, 1> bounds, multipliers;
  std::array<int, kCount> active{};
  std::array<double, 2 * kSize + kSize*(kSize + 5) / 2 + 2 * kCount + 1> work{};
  int error = 0;  // in: Q is not factorised

  explicit Quadprog(const Problem& p) : Q(p.Q), Qx_u(p.Q * p.x_u) {
    for (int i = 0; i < kRows; ++i) {
      normals.col(i) = p.rows[i].a;
      bounds[i] = p.rows[i].lower;
    }
    normals.middleCols<kSize>(kRows).setIdentity();
    bounds.segment<kSize>(kRows) = p.x_min;
    normals.rightCols<kSize>() = -Matrix::Identity();
    bounds.tail<kSize>() = -p.x_max;
  }
  void solve() {
    const int size = kSize, count = kCount, equalities = 0;
    int active_count = 0, iterations[2] = {0, 0};
    double value = 0;
    qpgen2_(Q.data(), Qx_u.data(), &size, &size, x.data(), multipliers.data(), &value, normals.data(), bounds.data(),
            &size, &count, &equalities, active.data(), &active_count, iterations, work.data(), &error);
  }
};
#endif

double cost(unsigned, const double* x, double* gradient, void* data) {
  const auto& p = *static_cast<const Problem*>(data);
  const Vector d = Eigen::Map<const Vector>(x) - p.x_u, Qd = p.Q * d;
  if (gradient != nullptr) Eigen::Map<Vector>{gradient} = Qd;
  return d.dot(Qd) / 2;
}
void rows(unsigned, double* result, unsigned, const double* x, double* gradient, void* data) {
  const auto& p = *static_cast<const Problem*>(data);
  for (int i = 0; i < kRows; ++i) {
    result[i] = p.rows[i].lower - p.rows[i].a.dot(Eigen::Map<const Vector>(x));
    if (gradient != nullptr) Eigen::Map<Vector>{gradient + i* kSize} = -p.rows[i].a;
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int count = rme::benchmarks::quick(argc, argv) ? 50 : 5000;
  const unsigned seed = 4701;
  std::mt19937 random(seed);
  std::vector<double> ours[4], theirs[4];
  double worst = 0;
#ifdef RME_WITH_QUADPROG
  std::vector<double> quadprog[4];
  double furthest = 0;
#endif
  int agreed = 0, short_of = 0;
  for (int i = 0; i < count; ++i) {
    rme::benchmarks::rest();
    Problem p = draw(random);
    Solver solver;
    rme::Status status;
    const double time = rme::benchmarks::time_of([&] { status = solver.solve(p.P, p.x_u, p.rows, p.x_min, p.x_max); });
    nlopt_opt peer = nlopt_create(NLOPT_LD_SLSQP, kSize);
    nlopt_set_lower_bounds(peer, p.x_min.data());
    nlopt_set_upper_bounds(peer, p.x_max.data());
    nlopt_set_min_objective(peer, cost, &p);
    const std::vector<double> tolerance(kRows, 1e-10);
    nlopt_add_inequality_mconstraint(peer, kRows, rows, &p, tolerance.data());
    nlopt_set_xtol_rel(peer, 1e-12);
    nlopt_set_maxeval(peer, 1000);
    Vector x = (p.x_min + p.x_max) / 2;
    double value = 0;
    nlopt_result result = NLOPT_FAILURE;
    const double their_time = rme::benchmarks::time_of([&] { result = nlopt_optimize(peer, x.data(), &value); });
    nlopt_destroy(peer);
    const int n = solver.active_count(), bin = n < 2 ? n : n < 4 ? 2 : 3;
    ours[bin].push_back(time);
    theirs[bin].push_back(their_time);
    // SLSQP gives up, or stops short, where it cannot tell descent from rounding; its point, where it keeps the rows,
    // must never be the better one.
    const double best = cost(kSize, solver.solution().data(), nullptr, &p);
#ifdef RME_WITH_QUADPROG
    Quadprog other(p);
    quadprog[bin].push_back(rme::benchmarks::time_of([&] { other.solve(); }));
    const double apart = (other.x - solver.solution()).norm() / (1 + other.x.norm());
    furthest = std::max(furthest, apart);
    if (other.error != 0 || !(apart < 1e-9)) {
      std::printf("problem %d: quadprog's error %d, its answer is %.1e apart\n", i, other.error, apart);
      return 1;
    }
#endif
    double miss = 0;
    for (int k = 0; k < kRows; ++k) miss = std::max(miss, p.rows[k].lower - p.rows[k].a.dot(x));
    if (status != rme::Status::Ok || (miss < 1e-9 && value < best - 1e-6 * (1 + best))) {
      std::printf("problem %d: status %s, costs %.12g and %.12g\n", i, rme::to_string(status), best, value);
      return 1;
    }
    const double difference = std::abs(value - best) / (1 + best);
    if (result < 0 || difference > 1e-6) {
      ++short_of;
      continue;
    }
    ++agreed;
    worst = std::max(worst, difference);
  }
  const char* const names[] = {"no active row", "1 active row", "2 or 3 active rows", "4 or more active rows"};
  rme::benchmarks::print_head("Quadratic programs of 7 variables, 14 rows and a box, cold");
  for (int b = 0; b < 4; ++b) {
    rme::benchmarks::print_row(std::string("ActiveSetSolver::solve, ") + names[b], ours[b]);
#ifdef RME_WITH_QUADPROG
    rme::benchmarks::print_row(std::string("quadprog, ") + names[b], quadprog[b]);
#endif
    rme::benchmarks::print_row(std::string("NLopt SLSQP, ") + names[b], theirs[b]);
  }
  std::printf(
      "\n%d problems, seed %u: the same cost on %d, relative difference at most %.1e; SLSQP gave up or stopped short "
      "on "
      "%d, and was never better\n",
      count, seed, agreed, worst, short_of);
#ifdef RME_WITH_QUADPROG
  std::printf("quadprog's answers on all of them are at most %.1e apart from ours, relative\n", furthest);
#endif
  return agreed > count / 2 ? 0 : 1;
}
