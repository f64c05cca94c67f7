#include <Eigen/Geometry>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <synthetic_arm/panda.hpp>
#include <synthetic_arm/six_joint_arm.hpp>

#include "support/catch.hpp"

namespace {

using rme::examples::ArmModel;
using rme::examples::RigidBody;

template <int Dofs>
using Vector = rme::JointVector<double, Dofs>;

struct Panda {
  static constexpr int dofs = 7;
  static const ArmModel<7>& model() { return rme::examples::panda(); }
};
struct SixJointArm {
  static constexpr int dofs = 6;
  static const ArmModel<6>& model() { return rme::examples::six_joint_arm(); }
};

// Any state, also outside the limits: the laws below know no limits.
template <int Dofs>
Vector<Dofs> random_vector(std::mt19937& random, double bound) {
  std::uniform_real_distribution<double> uniform(-bound, bound);
  return Vector<Dofs>::NullaryExpr([&] { return uniform(random); });
}

// d f(x + s direction) / ds at s = 0 by five-point differences; the error is about 1e-11 for functions of unit size.
template <typename Function, typename X>
auto derivative(const Function& f, const X& x, const X& direction) {
  const double h = 1e-3;
  using Value = decltype(f(x));
  const Value far = f(x + 2 * h * direction) - f(x - 2 * h * direction);
  const Value near = f(x + h * direction) - f(x - h * direction);
  return Value((8 * near - far) / (12 * h));
}

const RigidBody payload{1.3, {0.04, -0.03, 0.12}, Eigen::Vector3d(0.004, 0.003, 0.002).asDiagonal()};

TEST_CASE("ArmModel: the Panda's kinematics and dynamics are those that MuJoCo computes", "[arm_model]") {
  std::ifstream file(RME_TEST_DATA "/mujoco/kinematics.json");
  const nlohmann::json states = nlohmann::json::parse(file).at("states");
  REQUIRE(states.size() == 25);
  const auto vector = [](const nlohmann::json& numbers) {
    const auto values = numbers.get<std::vector<double>>();
    return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size())));
  };
  const auto matrix = [&vector](const nlohmann::json& rows) {
    Eigen::MatrixXd m(rows.size(), rows.at(0).size());
    for (std::size_t i = 0; i < rows.size(); ++i) m.row(static_cast<Eigen::Index>(i)) = vector(rows[i]);
    return m;
  };
  const auto difference = [](const auto& a, const auto& b) { return (a - b).cwiseAbs().maxCoeff(); };
  for (std::size_t i = 0; i < states.size(); ++i) {
    CAPTURE(i);
    const nlohmann::json& state = states[i];
    const Vector<7> q = vector(state.at("q")), dq = vector(state.at("dq"));
    const auto at = rme::examples::panda().kinematics(q);
    const auto terms = rme::examples::panda().dynamics(q, dq);
    CHECK(difference(at.position, vector(state.at("p"))) < 1e-9);
    CHECK(difference(at.rotation, matrix(state.at("R"))) < 1e-9);
    CHECK(difference(at.jacobian, matrix(state.at("J"))) < 1e-9);
    CHECK(difference(terms.gravity, vector(state.at("G"))) < 1e-8);      // the file's digits
    CHECK(difference(terms.mass_matrix, matrix(state.at("M"))) < 1e-7);  // MuJoCo diagonalises inertias
    CHECK(difference(terms.coriolis, vector(state.at("Cdq"))) < 1e-7);
  }
}

TEMPLATE_TEST_CASE("ArmModel: the Jacobian is the derivative of the flange pose", "[arm_model]", Panda, SixJointArm) {
  const unsigned seed = 3;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const auto& model = TestType::model();
  for (int k = 0; k < 20; ++k) {
    const auto q = random_vector<TestType::dofs>(random, 3), dq = random_vector<TestType::dofs>(random, 1);
    const auto at = model.kinematics(q);
    const rme::Vector6<double> twist = at.jacobian * dq;
    const Eigen::Vector3d v = derivative([&](const auto& x) { return model.kinematics(x).position; }, q, dq);
    const Eigen::Matrix3d dR = derivative([&](const auto& x) { return model.kinematics(x).rotation; }, q, dq);
    CHECK((v - twist.template head<3>()).norm() < 1e-9);
    CHECK((dR * at.rotation.transpose() - rme::skew(twist.template tail<3>())).norm() < 1e-9);  // dR/dt = [omega]x R
  }
}

TEMPLATE_TEST_CASE("ArmModel: the dynamics are Lagrange's equations of the energy, also with a payload", "[arm_model]",
                   Panda, SixJointArm) {
  const unsigned seed = 4;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const auto& model = TestType::model();
  constexpr int dofs = TestType::dofs;
  const Vector<dofs> rest = Vector<dofs>::Zero();
  for (int k = 0; k < 20; ++k) {
    const RigidBody body = k % 2 ? payload : RigidBody{};
    const auto q = random_vector<dofs>(random, 3), dq = random_vector<dofs>(random, 2);
    const auto terms = model.dynamics(q, dq, body);
    const auto potential = [&](const auto& x) { return model.energy(x, rest, body); };
    const auto kinetic = [&](const auto& x) { return model.energy(x, dq, body) - potential(x); };
    const auto mass_matrix = [&](const auto& x) { return model.dynamics(x, rest, body).mass_matrix; };
    const rme::JointMatrix<double, dofs> mass_rate = derivative(mass_matrix, q, dq);
    for (int i = 0; i < dofs; ++i) {
      CAPTURE(k, i);
      const Vector<dofs> axis = Vector<dofs>::Unit(i);
      CHECK(std::abs(terms.gravity[i] - derivative(potential, q, axis)) < 1e-8);
      // d/dt (dT/d dq) - dT/dq = M ddq + dM/dt dq - dT/dq, so C dq = dM/dt dq - dT/dq; and C^T dq = dT/dq.
      const double slope = derivative(kinetic, q, axis);
      CHECK(std::abs(terms.coriolis[i] - (mass_rate.row(i).dot(dq) - slope)) < 1e-8);
      CHECK(std::abs(terms.coriolis_transpose[i] - slope) < 1e-8);
    }
  }
}

TEMPLATE_TEST_CASE("ArmModel: a payload at rest loads the joints with J^T of its wrench", "[arm_model]", Panda,
                   SixJointArm) {
  // Statics by hand: the wrench of the conventions, moved to the joints by the (above checked) Jacobian.
  const auto& model = TestType::model();
  const Vector<TestType::dofs> q = model.ready + 0.3 * Vector<TestType::dofs>::Ones(), rest = 0 * q;
  const auto at = model.kinematics(q);
  const Eigen::Vector3d weight(0, 0, -9.81 * payload.mass);
  rme::Vector6<double> wrench;
  wrench << weight, (at.rotation * payload.com).cross(weight);
  const Vector<TestType::dofs> load = model.dynamics(q, rest, payload).gravity - model.dynamics(q, rest).gravity;
  CHECK((load + at.jacobian.transpose() * wrench).norm() < 1e-12);
}

TEST_CASE("ArmModel: on a wall gravity pulls along the wall's axis", "[arm_model]") {
  ArmModel<7> wall = rme::examples::panda();
  wall.gravity_vector = {9.81, 0, 0};
  // The first joint turns about world z, so gravity along x loads it by the moment of the arm's mass about z:
  // g_1 = -z . (m c x g) = m c_y 9.81, with c_y from the model's own potential along y.
  ArmModel<7> along_y = wall;
  along_y.gravity_vector = {0, 1, 0};
  const Vector<7> q = wall.ready + 0.2 * Vector<7>::Ones(), rest = Vector<7>::Zero();
  const double mass_times_y = -along_y.energy(q, rest);
  CHECK(wall.dynamics(q, rest).gravity[0] == Approx(9.81 * mass_times_y).epsilon(1e-12));
  CHECK(std::abs(rme::examples::panda().dynamics(q, rest).gravity[0]) < 1e-12);
}

TEST_CASE("RigidBody: two halves of a box make the box", "[arm_model]") {
  using rme::examples::box;
  const RigidBody whole = box(2, {0.1, 0.2, 0.3}, {0.4, 0.1, 0.2});
  const RigidBody halves = box(1, {0.0, 0.2, 0.3}, {0.2, 0.1, 0.2}) + box(1, {0.2, 0.2, 0.3}, {0.2, 0.1, 0.2});
  CHECK(halves.mass == Approx(2).epsilon(1e-15));
  CHECK((halves.com - whole.com).norm() < 1e-15);
  CHECK((halves.inertia - whole.inertia).norm() < 1e-15);
  CHECK((RigidBody{} + RigidBody{}).com == Eigen::Vector3d::Zero());  // nothing twice is nothing, not a NaN
}

}  // namespace
