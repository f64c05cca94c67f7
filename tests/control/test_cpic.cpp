#include <cstdio>

#include "one_active_row.hpp"
#include "random_arm.hpp"
#include "solvers.hpp"
#include "support/catch.hpp"

namespace {

using oracle::RandomArm;
using Vector7 = rme::JointVector<double, 7>;

template <int Dofs>
rme::CpicConfig<double, Dofs> config_of(const rme::JointVector<double, Dofs>& torque_limit) {
  rme::CpicConfig<double, Dofs> config;
  config.torque_limit = torque_limit;
  return config;
}

TEMPLATE_TEST_CASE_SIG("Cpic: far from all constraints the torque is J^T F_c + N tau_0", "[cpic]", ((int Dofs), Dofs),
                       6, 7) {
  const unsigned seed = 4201;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int i = 0; i < 500; ++i) {
    const RandomArm<Dofs, 28> arm(random, 0, 0, 20);
    rme::Cpic<double, Dofs> cpic(config_of<Dofs>(rme::JointVector<double, Dofs>::Constant(1e4)));
    REQUIRE(cpic.update(arm.input, arm.rows) == rme::Status::Ok);
    REQUIRE((cpic.torque() - arm.unconstrained()).norm() < 1e-13 * arm.unconstrained().norm());
    REQUIRE(cpic.torque() == cpic.unconstrained_torque());
    // Its wrench is F_c: the null-space torque makes none.
    REQUIRE((arm.pseudo_inverse.transpose() * cpic.torque() - arm.input.wrench.vector()).norm() <
            1e-12 * arm.pseudo_inverse.norm() * cpic.torque().norm());
  }
}

TEMPLATE_TEST_CASE_SIG("Cpic: one active row gives the paper's closed form with its signs put right", "[cpic]",
                       ((int Dofs), Dofs), 6, 7) {
  const unsigned seed = 4202;
  CAPTURE(seed);
  std::mt19937 random(seed);
  int active = 0;
  double worst = 0;
  for (int i = 0; i < 2000; ++i) {
    CAPTURE(i);
    const RandomArm<Dofs, 28> arm(random, 0, 1, 20);
    auto config = config_of<Dofs>(rme::JointVector<double, Dofs>::Constant(1e6));
    rme::Cpic<double, Dofs> cpic(config);
    REQUIRE(cpic.update(arm.input, arm.rows) == rme::Status::Ok);
    if (cpic.active_count() == 0) continue;
    ++active;
    const oracle::OneRow expected =
        oracle::one_active_row(arm.input.jacobian, arm.input.mass_matrix, arm.input.bias, arm.input.wrench.vector(),
                               arm.input.null_torque, config.null_space_weight, arm.rows[0].a, arm.rows[0].lower);
    REQUIRE(expected.multiplier > 0);
    const double error = expected.relative_error(cpic.torque());
    const auto multiplier_error = static_cast<double>(std::abs(cpic.multiplier(0) / expected.multiplier - 1));
    // lambda is a difference of two terms; it is as good as the larger of them allows.
    const double cancellation = expected.cancellation;
    worst = std::max(worst, error);
    REQUIRE(error < 1e-12);
    REQUIRE(multiplier_error < 1e-12 * (1 + cancellation));
  }
  CHECK(active > 500);
  std::printf("%d joints, one active row against (26), (27): worst relative error of tau %.1e in %d problems\n", Dofs,
              worst, active);
}

template <int Dofs>
void check_kkt(unsigned seed, int problems, double moment_arm = 1) {
  CAPTURE(seed);
  std::mt19937 random(seed);
  double worst = 0;
  std::array<int, 24> active{};
  rme::CpicConfig<double, Dofs> config = config_of<Dofs>(RandomArm<Dofs, 28>(random, 0, 0, 0).torque_limit);
  config.moment_arm = moment_arm;
  rme::Cpic<double, Dofs> cpic(config);
  for (int i = 0; i < problems; ++i) {
    CAPTURE(i);
    const int general = static_cast<int>(random() % 15);
    const RandomArm<Dofs, 28> arm(random, i % 2 == 0 ? Dofs : 0, general, i % 5 == 0 ? 2 : 40);
    REQUIRE(cpic.update(arm.input, arm.rows) == rme::Status::Ok);
    const auto r = oracle::kkt_residuals(arm.hessian(config.null_space_weight, moment_arm), arm.unconstrained(),
                                         cpic.torque(), arm.constraints(cpic));
    CAPTURE(r.stationarity, r.primal, r.dual, r.complementarity);
    REQUIRE(r.worst() < 1e-9);
    worst = std::max(worst, r.worst());
    ++active[static_cast<std::size_t>(cpic.active_count())];
  }
  std::printf("%d arms of %d joints: worst KKT residual %.1e; by active constraints", problems, Dofs, worst);
  for (int k = 0; k <= Dofs; ++k) std::printf(" %d", active[static_cast<std::size_t>(k)]);
  std::printf("\n");
}

TEST_CASE("Cpic: random arms meet the KKT conditions of (22)", "[cpic]") {
  check_kkt<6>(4203, 5000);
  check_kkt<7>(4204, 5000);
  check_kkt<7>(4211, 5000, 0.1);
}

TEST_CASE("Cpic: a million random arms meet the KKT conditions of (22)", "[.long]") {
  check_kkt<6>(4205, 500000);
  check_kkt<7>(4206, 500000);
}

TEST_CASE("Cpic: the null space is used up before the task is disturbed", "[cpic]") {
  const unsigned seed = 4207;
  CAPTURE(seed);
  std::mt19937 random(seed);
  int active = 0;
  for (int i = 0; i < 200; ++i) {
    const RandomArm<7, 28> arm(random, 0, 1, 20);
    auto config = config_of<7>(Vector7::Constant(1e6));
    config.null_space_weight = 1e-9;
    rme::Cpic<double, 7> cpic(config);
    REQUIRE(cpic.update(arm.input, arm.rows) == rme::Status::Ok);
    if (cpic.active_count() == 0) continue;
    ++active;
    const rme::Vector6<double> miss = arm.pseudo_inverse.transpose() * cpic.torque() - arm.input.wrench.vector();
    // One row and one null-space direction z: the row is met by z alone, as eps goes to zero. What remains of the task
    // error is eps |J a| / (z a)^2 times the violation.
    const Vector7 a = oracle::inverse(arm.input.mass_matrix) * arm.rows[0].a;
    const double violation = arm.rows[0].lower + a.dot(arm.input.bias) - a.dot(Vector7(arm.unconstrained()));
    const double free = a.dot(arm.null_projector * a);
    REQUIRE(miss.norm() <= 1e-9 * (arm.input.jacobian * a).norm() / free * violation * 1.001 + 1e-9);
  }
  CHECK(active > 50);
}

TEST_CASE("Cpic: torque that the host adds afterwards counts against the limits", "[cpic]") {
  const unsigned seed = 4208;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int i = 0; i < 500; ++i) {
    RandomArm<7, 28> arm(random, 7, 3, 60);
    arm.input.other_torque = oracle::random_matrix(random, 7, 1).cwiseProduct(arm.torque_limit / 4);
    rme::Cpic<double, 7> cpic(config_of<7>(arm.torque_limit));
    const rme::Status status = cpic.update(arm.input, arm.rows);
    REQUIRE((status == rme::Status::Ok || status == rme::Status::Infeasible));
    const Vector7 total = cpic.torque() + arm.input.other_torque;
    REQUIRE((total.cwiseAbs() - arm.torque_limit).maxCoeff() <= 1e-13);
    if (status == rme::Status::Infeasible) continue;
    const auto r = oracle::kkt_residuals(arm.hessian(1e-3), arm.unconstrained(), cpic.torque(), arm.constraints(cpic));
    REQUIRE(r.worst() < 1e-9);
  }
}

TEST_CASE("Cpic: a singular pose leaves the torque bounded and continuous", "[cpic]") {
  const unsigned seed = 4209;
  CAPTURE(seed);
  std::mt19937 random(seed);
  RandomArm<7, 28> arm(random, 7, 3, 30);
  const oracle::Matrix U = oracle::random_rotation(random, 6), V = oracle::random_rotation(random, 7);
  Eigen::Matrix<double, 6, 1> sigma;
  sigma << 1.5, 1.2, 0.9, 0.7, 0.5, 0;
  double changes[2];
  int active = 0;
  for (const int halved : {0, 1}) {
    rme::Cpic<double, 7> cpic(config_of<7>(arm.torque_limit));
    const double step = halved ? 1e-5 : 2e-5;
    Vector7 previous = Vector7::Zero();
    changes[halved] = 0;
    for (int k = 0; k * step <= 0.1; ++k) {
      sigma[5] = 0.05 - k * step;
      arm.input.jacobian = oracle::composed(U, sigma, V);
      REQUIRE(cpic.update(arm.input, arm.rows) == rme::Status::Ok);
      REQUIRE((cpic.torque().cwiseAbs() - arm.torque_limit).maxCoeff() <= 0);
      active = std::max(active, cpic.active_count());
      if (k > 0) changes[halved] = std::max(changes[halved], (cpic.torque() - previous).norm());
      previous = cpic.torque();
    }
  }
  CHECK(active > 0);
  CAPTURE(changes[0]);
  CHECK(changes[1] < 0.6 * changes[0]);  // a jump would not shrink with the step
}

TEST_CASE("Cpic: a warm start changes how the answer is found, not the answer", "[cpic]") {
  const unsigned seed = 4210;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int path = 0; path < 20; ++path) {
    RandomArm<7, 28> arm(random, 7, 4, 30);
    rme::Cpic<double, 7> warm(config_of<7>(arm.torque_limit));
    int warm_iterations = 0, cold_iterations = 0;
    for (int k = 0; k < 100; ++k) {
      arm.input.bias += 0.05 * oracle::random_matrix(random, 7, 1);
      arm.input.wrench.force += 0.1 * oracle::random_matrix(random, 3, 1);
      rme::Cpic<double, 7> cold(config_of<7>(arm.torque_limit));
      const rme::Status status = warm.update(arm.input, arm.rows);
      REQUIRE(cold.update(arm.input, arm.rows) == status);
      if (status != rme::Status::Ok) continue;
      REQUIRE((warm.torque() - cold.torque()).norm() < 1e-9 * (1 + cold.torque().norm()));
      warm_iterations += warm.iterations();
      cold_iterations += cold.iterations();
    }
    CHECK(warm_iterations <= cold_iterations);
  }
}

TEMPLATE_TEST_CASE("Cpic: bad input is named and leaves the torque alone", "[cpic]", float, double) {
  using Scalar = TestType;
  rme::CpicConfig<Scalar, 7> config;
  config.torque_limit.setConstant(50);
  rme::Cpic<Scalar, 7> cpic(config);
  rme::CpicInput<Scalar, 7> good;
  good.jacobian.setZero();
  good.jacobian.template leftCols<6>().setIdentity();
  good.mass_matrix.setIdentity();
  good.bias.setZero();
  good.wrench.force << 1, 2, 3;
  rme::ConstraintRows<Scalar, 7, 28> rows;
  REQUIRE(rows.add_axis(0, -5, Scalar(0.5)) == rme::Status::Ok);
  REQUIRE(cpic.update(good, rows) == rme::Status::Ok);
  const rme::JointVector<Scalar, 7> torque = cpic.torque();
  CHECK(torque[0] == Approx(0.5));
  CHECK(torque[1] == Approx(2));

  for (const Scalar bad : {std::numeric_limits<Scalar>::quiet_NaN(), std::numeric_limits<Scalar>::infinity()}) {
    auto input = good;
    input.jacobian(3, 4) = bad;
    CHECK(cpic.update(input, rows) == rme::Status::NonFiniteInput);
    input = good;
    input.mass_matrix(1, 0) = bad;
    CHECK(cpic.update(input, rows) == rme::Status::NonFiniteInput);
    input = good;
    input.bias[6] = bad;
    CHECK(cpic.update(input, rows) == rme::Status::NonFiniteInput);
    input = good;
    input.wrench.moment[1] = bad;
    CHECK(cpic.update(input, rows) == rme::Status::NonFiniteInput);
    input = good;
    input.null_torque[2] = bad;
    CHECK(cpic.update(input, rows) == rme::Status::NonFiniteInput);
    input = good;
    input.other_torque[2] = bad;
    CHECK(cpic.update(input, rows) == rme::Status::NonFiniteInput);
  }
  auto input = good;
  input.mass_matrix(3, 3) = -1;
  CHECK(cpic.update(input, rows) == rme::Status::NotPositiveDefinite);
  input = good;  // finite, but J^T F_c is not
  input.jacobian(0, 0) = input.wrench.force[0] = std::numeric_limits<Scalar>::max();
  CHECK(cpic.update(input, rows) == rme::Status::NonFiniteInput);
  CHECK(cpic.torque() == torque);
  CHECK(cpic.update(good, rows) == rme::Status::Ok);
  CHECK(cpic.torque() == torque);
}

TEST_CASE("Cpic: settings out of range are refused by name", "[cpic]") {
  rme::CpicConfig<double, 7> config;
  CHECK_THROWS_WITH((rme::Cpic<double, 7>(config)), contains("CpicConfig::torque_limit"));
  config.torque_limit.setConstant(10);
  config.null_space_weight = 0;
  CHECK_THROWS_WITH((rme::Cpic<double, 7>(config)), contains("CpicConfig::null_space_weight"));
  config.null_space_weight = 1;
  config.moment_arm = 0;
  CHECK_THROWS_WITH((rme::Cpic<double, 7>(config)), contains("CpicConfig::moment_arm"));
  config.moment_arm = 1;
  config.null_space_weight = 1e-9;  // one at which double still keeps its promise
  CHECK_NOTHROW(rme::Cpic<double, 7>(config));
  config.null_space_weight = 1e-25;
  CHECK_THROWS_WITH((rme::Cpic<double, 7>(config)), contains("<= 2e-3 / machine epsilon"));
  rme::CpicConfig<float, 7> small;
  small.torque_limit.setConstant(10);
  small.null_space_weight = 1e-5F;
  CHECK_NOTHROW(rme::Cpic<float, 7>(small));
  small.null_space_weight = 1e-6F;
  CHECK_THROWS_WITH((rme::Cpic<float, 7>(small)), contains("<= 2e-3 / machine epsilon"));
}

static_assert(noexcept(std::declval<rme::Cpic<double, 7>&>().update(
    std::declval<const rme::CpicInput<double, 7>&>(), std::declval<const rme::ConstraintRows<double, 7, 28>&>())));

}  // namespace
