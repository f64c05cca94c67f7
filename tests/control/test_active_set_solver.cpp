#include <cstdio>

#include "qp_oracle.hpp"
#include "solvers.hpp"
#include "support/catch.hpp"

namespace {

using Vector2 = Eigen::Vector2d;
using Solver2 = rme::ActiveSetSolver<double, 2, 8>;
const Vector2 kFar = Vector2::Constant(1e6);
const Eigen::Matrix2d kIdentity = Eigen::Matrix2d::Identity();

TEST_CASE("ActiveSetSolver: without a violated row the unconstrained point comes back untouched", "[qp]") {
  Solver2 solver;
  Solver2::Rows rows;
  REQUIRE(rows.add(Vector2(1, 1), -10) == rme::Status::Ok);
  const Vector2 x_u(0.1, 0.7);
  CHECK(solver.solve(kIdentity, x_u, rows, -kFar, kFar) == rme::Status::Ok);
  CHECK(solver.solution() == x_u);
  CHECK(solver.active_count() == 0);
  CHECK(solver.iterations() == 0);
}

TEMPLATE_TEST_CASE("ActiveSetSolver: one row projects in the metric of Q", "[qp]", float, double) {
  using Scalar = TestType;
  using Vector = Eigen::Matrix<Scalar, 2, 1>;
  // min 1/2 (x^2 + 4 y^2) s.t. x + 2 y >= 4. Lagrange: x = l, 4 y = 2 l, so l + l = 4: l = 2, x = 2, y = 1.
  const Eigen::Matrix<Scalar, 2, 2> P = Vector(1, Scalar(0.25)).asDiagonal();
  rme::ActiveSetSolver<Scalar, 2, 3> solver;
  rme::ConstraintRows<Scalar, 2, 3> rows;
  REQUIRE(rows.add(Vector(1, 2), 4) == rme::Status::Ok);
  const Vector far = Vector::Constant(100);
  CHECK(solver.solve(P, Vector::Zero(), rows, -far, far) == rme::Status::Ok);
  CHECK((solver.solution() - Vector(2, 1)).norm() < 8 * Eigen::NumTraits<Scalar>::epsilon());
  CHECK(solver.multiplier(0) == Approx(2));
  // The same half-plane from its other side: -x - 2 y <= -4 has the multiplier -2.
  rows.clear();
  REQUIRE(rows.add(Vector(-1, -2), -rows.kFree, -4) == rme::Status::Ok);
  CHECK(solver.solve(P, Vector::Zero(), rows, -far, far) == rme::Status::Ok);
  CHECK((solver.solution() - Vector(2, 1)).norm() < 8 * Eigen::NumTraits<Scalar>::epsilon());
  CHECK(solver.multiplier(0) == Approx(-2));
}

TEST_CASE("ActiveSetSolver: a row that the first step made active leaves again when the optimum does without it",
          "[qp]") {
  // From the origin: y >= 1 is furthest and enters first; x + 0.1 y >= 0.9 next. Then y >= 1 stays: optimum (0.8, 1).
  // With 3 y + x >= 6 instead (2 away, but 6 / sqrt(10) = 1.897 first), the optimum (0.6, 1.8) makes y >= 1 idle.
  Solver2 solver;
  Solver2::Rows rows;
  REQUIRE(rows.add(Vector2(0, 1), 1) == rme::Status::Ok);
  REQUIRE(rows.add(Vector2(1, 0.1), 0.9) == rme::Status::Ok);
  CHECK(solver.solve(kIdentity, Vector2::Zero(), rows, -kFar, kFar) == rme::Status::Ok);
  CHECK((solver.solution() - Vector2(0.8, 1)).norm() < 1e-15);
  rows.clear();
  REQUIRE(rows.add(Vector2(0, 1), 1) == rme::Status::Ok);
  REQUIRE(rows.add(Vector2(1, 3), 6) == rme::Status::Ok);
  // Warm: both are active from before, and both equalities would be (3, 1).
  CHECK(solver.solve(kIdentity, Vector2::Zero(), rows, -kFar, kFar) == rme::Status::Ok);
  CHECK((solver.solution() - Vector2(0.6, 1.8)).norm() < 1e-15);
  CHECK(solver.multiplier(0) == 0);
  CHECK(solver.active_count() == 1);
}

TEMPLATE_TEST_CASE("ActiveSetSolver: two rows that the metric makes nearly parallel are told apart", "[qp]", float,
                   double) {
  // In the metric of P the rows x + y >= 1 and -x + y >= 2 are 1e-6 apart; both hold at (-1/2, 3/2) only, and there
  // lambda = P^-1 x = (-1e-3, 3000) = l_1 (1, 1) + l_2 (-1, 1) has l_1, l_2 > 0: it is the optimum.
  using Vector = Eigen::Matrix<TestType, 2, 1>;
  rme::ActiveSetSolver<TestType, 2, 2> solver;
  rme::ConstraintRows<TestType, 2, 2> rows;
  REQUIRE(rows.add(Vector(1, 1), 1) == rme::Status::Ok);
  REQUIRE(rows.add(Vector(-1, 1), 2) == rme::Status::Ok);
  const Eigen::Matrix<TestType, 2, 2> P = Vector(500, TestType(5e-4)).asDiagonal();
  const Vector far = Vector::Constant(100);
  REQUIRE(solver.solve(P, Vector::Zero(), rows, -far, far) == rme::Status::Ok);
  CHECK((solver.solution() - Vector(TestType(-0.5), TestType(1.5))).norm() <
        10 * Eigen::NumTraits<TestType>::epsilon());
  typename decltype(solver)::Root root = decltype(solver)::Root::Zero();
  root(0, 0) = std::sqrt(P(0, 0));
  root(1, 1) = std::sqrt(P(1, 1));
  REQUIRE(solver.solve_from_root(root, Vector::Zero(), rows, -far, far) == rme::Status::Ok);
  CHECK((solver.solution() - Vector(TestType(-0.5), TestType(1.5))).norm() <
        10 * Eigen::NumTraits<TestType>::epsilon());
}

TEMPLATE_TEST_CASE("ActiveSetSolver: rows that only a metric's rounding makes contradictory are kept", "[qp]", float,
                   double) {
  // The same rows, but P = diag(p, 1 / p^2) with p so large that what tells B (1, 1) and B (-1, 1) apart is rounding.
  using Vector = Eigen::Matrix<TestType, 2, 1>;
  rme::ActiveSetSolver<TestType, 2, 2> solver;
  rme::ConstraintRows<TestType, 2, 2> rows;
  REQUIRE(rows.add(Vector(1, 1), 1) == rme::Status::Ok);
  REQUIRE(rows.add(Vector(-1, 1), 2) == rme::Status::Ok);
  const TestType p = sizeof(TestType) == 4 ? TestType(1e5) : TestType(1e12);
  const Eigen::Matrix<TestType, 2, 2> P = Vector(p, 1 / (p * p)).asDiagonal();
  typename decltype(solver)::Root root = decltype(solver)::Root::Zero();
  root(0, 0) = std::sqrt(P(0, 0));
  root(1, 1) = std::sqrt(P(1, 1));
  const Vector far = Vector::Constant(100), kept(TestType(-0.5), TestType(1.5));
  const TestType tolerance = 10 * Eigen::NumTraits<TestType>::epsilon();
  for (int tick = 0; tick < 2; ++tick) {  // cold and warm
    REQUIRE(solver.solve_from_root(root, Vector::Zero(), rows, -far, far) == rme::Status::Ok);
    CHECK((solver.solution() - kept).norm() < tolerance);
  }
  solver.reset();
  REQUIRE(solver.solve(P, Vector::Zero(), rows, -far, far) == rme::Status::Ok);
  CHECK((solver.solution() - kept).norm() < tolerance);
  // What does contradict is still said to: x + y >= 1 and <= -1, missed by one each. The given metric says where.
  rows.clear();
  REQUIRE(rows.add(Vector(1, 1), 1) == rme::Status::Ok);
  REQUIRE(rows.add(Vector(-1, -1), 1) == rme::Status::Ok);
  for (int tick = 0; tick < 2; ++tick) {
    REQUIRE(solver.solve_from_root(root, Vector(0, 1), rows, -far, far) == rme::Status::Infeasible);
    CHECK((solver.solution() - Vector(-1, 1)).norm() < TestType(1e-2));
  }
}

TEST_CASE("ActiveSetSolver: the box is a constraint like any other", "[qp]") {
  // x + y >= 3 with x <= 1 and y <= 5: (1, 2). Lagrange: y = l = 2, x = l + m = 1, so m = -1 on the upper side of x.
  Solver2 solver;
  Solver2::Rows rows;
  REQUIRE(rows.add(Vector2(1, 1), 3) == rme::Status::Ok);
  CHECK(solver.solve(kIdentity, Vector2::Zero(), rows, Vector2(-1, -1), Vector2(1, 5)) == rme::Status::Ok);
  CHECK((solver.solution() - Vector2(1, 2)).norm() < 1e-15);
  CHECK(solver.multiplier(0) == Approx(2));
  CHECK(solver.box_multiplier(0) == Approx(-1));
  CHECK(solver.box_multiplier(1) == 0);
}

TEST_CASE("ActiveSetSolver: a soft row yields by its slack", "[qp]") {
  // min 1/2 x^2 + w s^2, x + s >= 1: x = l, s = l / (2 w), so l = 1 / (1 + 1 / (2 w)). With w = 1.5: x = 0.75, s =
  // 0.25.
  Solver2 solver;
  Solver2::Rows rows;
  REQUIRE(rows.add(Vector2(1, 0), 1, rows.kFree, 1.5) == rme::Status::Ok);
  CHECK(solver.solve(kIdentity, Vector2::Zero(), rows, -kFar, kFar) == rme::Status::Ok);
  CHECK(solver.solution()[0] == Approx(0.75).epsilon(1e-15));
  CHECK(solver.slack(0) == Approx(0.25).epsilon(1e-15));
  // A hard row against it wins outright: x <= 0.5.
  REQUIRE(rows.add(Vector2(1, 0), -rows.kFree, 0.5) == rme::Status::Ok);
  CHECK(solver.solve(kIdentity, Vector2::Zero(), rows, -kFar, kFar) == rme::Status::Ok);
  CHECK(solver.solution()[0] == Approx(0.5).epsilon(1e-15));
  CHECK(solver.slack(0) == Approx(0.5).epsilon(1e-15));
  CHECK(solver.slack(1) == 0);
}

TEST_CASE("ActiveSetSolver: contradictory hard rows are missed by the same amount, and the status says so", "[qp]") {
  Solver2 solver;
  Solver2::Rows rows;
  REQUIRE(rows.add(Vector2(1, 0), 3) == rme::Status::Ok);                   // x >= 3
  REQUIRE(rows.add(Vector2(1, 0), -rows.kFree, 1) == rme::Status::Ok);      // x <= 1
  REQUIRE(rows.add(Vector2(0, 1), 7, rows.kFree, 0.5) == rme::Status::Ok);  // y >= 7, soft: l = 7 / 2
  REQUIRE(solver.solve(kIdentity, Vector2::Zero(), rows, -kFar, kFar) == rme::Status::Infeasible);
  // Least squares: x = 2, missed by 1 on both sides, up to the square root of the machine precision.
  CHECK((solver.solution() - Vector2(2, 3.5)).norm() < 1e-7);
  CHECK(solver.slack(0) == Approx(1).epsilon(1e-7));
  CHECK(solver.slack(1) == Approx(1).epsilon(1e-7));
  // The box is not up for negotiation.
  REQUIRE(solver.solve(kIdentity, Vector2::Zero(), rows, -kFar, Vector2(1.25, 10)) == rme::Status::Infeasible);
  CHECK(solver.solution()[0] == Approx(1.25).epsilon(1e-7));
  CHECK(solver.solution()[0] <= 1.25);
  CHECK(solver.slack(0) == Approx(1.75).epsilon(1e-7));
  CHECK(solver.slack(1) == Approx(0.25).epsilon(1e-7));
  // And the next problem is none the worse for it.
  rows.clear();
  REQUIRE(rows.add(Vector2(1, 0), 3) == rme::Status::Ok);
  REQUIRE(solver.solve(kIdentity, Vector2::Zero(), rows, -kFar, kFar) == rme::Status::Ok);
  CHECK((solver.solution() - Vector2(3, 0)).norm() < 1e-15);
}

TEST_CASE("ActiveSetSolver: rows that repeat each other at any scale are one row", "[qp]") {
  Solver2 solver;
  Solver2::Rows rows;
  for (const double scale : {1.0, 1e-6, 1e6, 1.0 / 3.0, 7.0}) {
    REQUIRE(rows.add(scale * Vector2(3, 1), scale * 0.7) == rme::Status::Ok);
  }
  REQUIRE(rows.add(Vector2(3, 1), 0.7 * (1 - 1e-9)) == rme::Status::Ok);
  REQUIRE(rows.add(Vector2(3, 1), -rows.kFree, 0.7) == rme::Status::Ok);  // together an equality
  REQUIRE(rows.add(Vector2::Zero(), -5) == rme::Status::Ok);              // constrains nothing
  CHECK(solver.solve(kIdentity, Vector2::Zero(), rows, -kFar, kFar) == rme::Status::Ok);
  CHECK((solver.solution() - Vector2(0.21, 0.07)).norm() < 1e-15);  // 0.7 (3, 1) / 10
}

TEST_CASE("ConstraintRows: what cannot be a row is not added", "[qp]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  rme::ConstraintRows<double, 2, 2> rows;
  CHECK(rows.add(Vector2(nan, 0), 0) == rme::Status::NonFiniteInput);
  CHECK(rows.add(Vector2(rows.kFree, 0), 0) == rme::Status::NonFiniteInput);
  CHECK(rows.add(Vector2(1, 0), nan) == rme::Status::NonFiniteInput);
  CHECK(rows.add(Vector2(1, 0), 0, nan) == rme::Status::NonFiniteInput);
  CHECK(rows.add(Vector2(1, 0), 0, 1, nan) == rme::Status::NonFiniteInput);
  CHECK(rows.add(Vector2(1, 0), 0, 1, 0) == rme::Status::NonFiniteInput);
  CHECK(rows.add(Vector2(1, 0), 1, 0) == rme::Status::Infeasible);
  CHECK(rows.add(Vector2::Zero(), 5) == rme::Status::Infeasible);
  CHECK(rows.add(Vector2::Zero(), -rows.kFree, -5) == rme::Status::Infeasible);
  CHECK(rows.add(Vector2(1e-200, 0), 5) == rme::Status::Infeasible);  // zero for all that can be done about it
  CHECK(rows.size() == 0);
  CHECK(rows.add_axis(1, 0, 1) == rme::Status::Ok);
  CHECK(rows.add(Vector2(1, 0), 0) == rme::Status::Ok);
  CHECK(rows.add(Vector2(1, 0), 0) == rme::Status::CapacityExceeded);
  CHECK(rows.size() == 2);
  CHECK(rows[0].a == Vector2(0, 1));
}

/// Random problems of one size, with their one-sided constraints for the oracles.
template <int Size, int MaxRows>
struct RandomProblem {
  Eigen::Matrix<double, Size, Size> Q, P;
  Eigen::Matrix<double, Size, 1> x_u, x_min, x_max;
  rme::ConstraintRows<double, Size, MaxRows> rows;

  /// @param count  number of rows; `soft` of them get a weight; duplicates and near-parallel rows occur
  RandomProblem(std::mt19937& random, int count, bool soft) {
    std::uniform_real_distribution<double> uniform;
    const oracle::Matrix V = oracle::random_rotation(random, Size);
    Eigen::Matrix<double, Size, 1> eigenvalues;
    for (int i = 0; i < Size; ++i) eigenvalues[i] = std::pow(10.0, -3 + 5 * uniform(random));
    Q = oracle::composed(V, eigenvalues, V);
    P = oracle::composed(V, eigenvalues.cwiseInverse(), V);
    const Eigen::Matrix<double, Size, 1> feasible = 5 * oracle::random_matrix(random, Size, 1);
    const double distance = std::pow(10.0, 1.5 * uniform(random));
    x_u = feasible + distance * oracle::random_matrix(random, Size, 1);
    x_min = feasible.array() - 10 * uniform(random);
    x_max = feasible.array() + 10 * uniform(random);
    for (int i = 0; i < count; ++i) {
      Eigen::Matrix<double, Size, 1> a = oracle::random_matrix(random, Size, 1);
      if (i > 0 && uniform(random) < 0.1) a = rows[i - 1].a + 1e-4 * a;
      if (i > 0 && uniform(random) < 0.05) a = rows[i - 1].a;
      a *= std::pow(10.0, 2 * uniform(random) - 1) / a.norm();  // rows differ a hundredfold in norm
      const double room = uniform(random) < 0.1 ? 0.0 : uniform(random) * a.norm();
      const double lower = a.dot(feasible) - room, upper = lower + 2 * room + uniform(random) * a.norm();
      const double weight = soft && uniform(random) < 0.5 ? std::pow(10.0, 4 * uniform(random) - 1) : rows.kHard;
      const double side = uniform(random);
      REQUIRE(rows.add(a, side < 0.6 ? lower : -rows.kFree, side > 0.4 ? upper : rows.kFree, weight) ==
              rme::Status::Ok);
    }
  }

  template <typename Solver>
  std::vector<oracle::Constraint> constraints(const Solver& solver) const {
    std::vector<oracle::Constraint> all;
    for (int i = 0; i < rows.size(); ++i) {
      const double l = solver.multiplier(i);
      if (rows[i].lower > -rows.kFree)
        all.push_back({rows[i].a, rows[i].lower, std::max(l, 0.0), l > 0 ? solver.slack(i) : 0});
      if (rows[i].upper < rows.kFree)
        all.push_back({-rows[i].a, -rows[i].upper, std::max(-l, 0.0), l < 0 ? solver.slack(i) : 0});
    }
    for (int j = 0; j < Size; ++j) {
      const double l = solver.box_multiplier(j);
      all.push_back({oracle::Vector::Unit(Size, j), x_min[j], std::max(l, 0.0)});
      all.push_back({-oracle::Vector::Unit(Size, j), -x_max[j], std::max(-l, 0.0)});
    }
    return all;
  }
};

template <int Size>
void check_kkt(unsigned seed, int problems) {
  CAPTURE(seed);
  std::mt19937 random(seed);
  rme::ActiveSetSolver<double, Size, 28> solver;  // its active set is carried over: a bad first guess each time
  double worst = 0;
  int most_iterations = 0;
  std::array<int, 40> active{};
  for (int i = 0; i < problems; ++i) {
    CAPTURE(i);
    const RandomProblem<Size, 28> p(random, static_cast<int>(random() % 29), i % 3 == 0);
    REQUIRE(solver.solve(p.P, p.x_u, p.rows, p.x_min, p.x_max) == rme::Status::Ok);
    const auto constraints = p.constraints(solver);
    const oracle::Residuals r = oracle::kkt_residuals(p.Q, p.x_u, solver.solution(), constraints);
    CAPTURE(r.stationarity, r.primal, r.dual, r.complementarity, solver.active_count(), p.rows.size());
    REQUIRE(r.worst() < 1e-9);
    // What Ok promises, as it is documented.
    const double reach = solver.solution().norm() + p.x_u.norm();
    for (const oracle::Constraint& c : constraints) {
      const double miss = c.b - c.a.dot(solver.solution()) - c.slack;
      REQUIRE(miss <= decltype(solver)::kTolerance * (c.a.norm() * reach + std::abs(c.b)));
    }
    // What is missed by a soft row is what its weight says: multiplier = 2 w s.
    for (int k = 0; k < p.rows.size(); ++k) {
      REQUIRE(std::abs(solver.multiplier(k)) ==
              Approx(solver.slack(k) > 0 ? 2 * p.rows[k].weight * solver.slack(k) : std::abs(solver.multiplier(k))));
    }
    worst = std::max(worst, r.worst());
    most_iterations = std::max(most_iterations, solver.iterations());
    ++active[static_cast<std::size_t>(solver.active_count())];
  }
  std::printf("%d problems of size %d: worst KKT residual %.1e, most iterations %d, active constraints", problems, Size,
              worst, most_iterations);
  for (int k = 0; k < 12; ++k) std::printf(" %d", active[static_cast<std::size_t>(k)]);
  std::printf("\n");
}

TEST_CASE("ActiveSetSolver: random problems with degenerate, parallel and soft rows meet the KKT conditions", "[qp]") {
  check_kkt<6>(4001, 10000);
  check_kkt<7>(4002, 10000);
}

TEST_CASE("ActiveSetSolver: a million random problems meet the KKT conditions", "[.long]") {
  check_kkt<6>(4003, 500000);
  check_kkt<7>(4004, 500000);
}

TEST_CASE("ActiveSetSolver: no point of the box violates an infeasible set less", "[qp]") {
  // The measure is sum_i violation_i^2 / (a_i P a_i). Projected gradient descent from the answer must find nothing
  // better.
  const unsigned seed = 4009;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform;
  rme::ActiveSetSolver<double, 7, 28> solver;
  int infeasible = 0;
  for (int i = 0; i < 200; ++i) {
    CAPTURE(i);
    RandomProblem<7, 28> p(random, 10, false);
    for (int k = 0; k < 6; ++k) {
      const Eigen::Matrix<double, 7, 1> a = oracle::random_matrix(random, 7, 1);
      REQUIRE(p.rows.add(a, a.dot(p.x_max) + 10 * uniform(random)) == rme::Status::Ok);
    }
    if (solver.solve(p.P, p.x_u, p.rows, p.x_min, p.x_max) == rme::Status::Ok) continue;
    ++infeasible;
    REQUIRE((solver.solution() - p.x_min).minCoeff() >= 0);
    REQUIRE((p.x_max - solver.solution()).minCoeff() >= 0);
    double lipschitz = 0;
    for (int k = 0; k < p.rows.size(); ++k) {
      lipschitz += 2 * p.rows[k].squared_norm / p.rows[k].a.dot(p.P * p.rows[k].a);
    }
    const auto measure = [&](const Eigen::Matrix<double, 7, 1>& x, Eigen::Matrix<double, 7, 1>& gradient) {
      double sum = 0;
      gradient.setZero();
      for (int k = 0; k < p.rows.size(); ++k) {
        const double value = p.rows[k].a.dot(x), scale = p.rows[k].a.dot(p.P * p.rows[k].a);
        const double miss = std::max(p.rows[k].lower - value, 0.0) - std::max(value - p.rows[k].upper, 0.0);
        sum += miss * miss / scale;
        gradient -= 2 * miss / scale * p.rows[k].a;
      }
      return sum;
    };
    Eigen::Matrix<double, 7, 1> x = solver.solution(), gradient;
    const double claimed = measure(x, gradient);
    double best = claimed;
    for (int step = 0; step < 3000; ++step) {
      x = (x - gradient / lipschitz).cwiseMax(p.x_min).cwiseMin(p.x_max);
      best = measure(x, gradient);
    }
    // The answer minimises 1/2 (x - x_u)^T Q (x - x_u) + measure / (2 sqrt(epsilon)), hence this bound for every x.
    const double root = std::sqrt(std::numeric_limits<double>::epsilon());
    REQUIRE(claimed - best <= root * (x - p.x_u).dot(p.Q * (x - p.x_u)) * (1 + 1e-6));
  }
  CHECK(infeasible > 100);
}

template <int Size>
void check_enumeration(unsigned seed, int problems) {
  CAPTURE(seed);
  std::mt19937 random(seed);
  rme::ActiveSetSolver<double, Size, 6> solver;
  for (int i = 0; i < problems; ++i) {
    CAPTURE(i);
    RandomProblem<Size, 6> p(random, static_cast<int>(random() % 7), false);
    // Of the box only two sides, so that 2^(sides) stays small.
    for (int j = 2; j < Size; ++j) {
      p.x_min[j] = -1e4;
      p.x_max[j] = 1e4;
    }
    REQUIRE(solver.solve(p.P, p.x_u, p.rows, p.x_min, p.x_max) == rme::Status::Ok);
    std::vector<oracle::Constraint> constraints;
    for (const auto& c : p.constraints(solver)) {
      if (std::abs(c.b) < 1e4) constraints.push_back(c);
    }
    oracle::Vector expected;
    REQUIRE(oracle::enumerate_active_sets(p.Q, p.x_u, constraints, expected));
    REQUIRE((solver.solution() - expected).norm() < 1e-9 * (1 + expected.norm()));
  }
}

TEST_CASE("ActiveSetSolver: agrees with the enumeration of all active sets", "[qp]") {
  check_enumeration<3>(4005, 300);
  check_enumeration<7>(4006, 100);
}

TEST_CASE("ActiveSetSolver: agrees with the enumeration of all active sets on ten thousand problems", "[.long]") {
  check_enumeration<6>(4007, 5000);
  check_enumeration<7>(4008, 5000);
}

}  // namespace
