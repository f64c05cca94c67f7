// What the C++ library makes of a log, for test_equality.py: every number that goes in and that comes out, to the last bit.
//
//     python_reference LOG JOINTS plain|everything OUT
//
// OUT: a line with the settings as JSON, a line with the names of the columns, and then a row of doubles for each sample.
// With 7 joints, the log is that of a Panda. With other numbers of joints, the arm has some of its joints, or one twice.
#include <array>
#include <cstdio>
#include <fstream>
#include <limits>
#include <optional>
#include <rme/core/compensation.hpp>
#include <rme/estimator.hpp>
#include <rme/estimator_json.hpp>
#include <rme/sensing/momentum_observer.hpp>
#include <stdexcept>
#include <string>
#include <synthetic_arm/panda.hpp>
#include <vector>

#include "io/log_reader.hpp"
#include "support/any_joints.hpp"

namespace {

using namespace rme;

class Table {
 public:
  void add(const std::string& name, double value) {
    if (first_) names_ += (names_.empty() ? "" : ",") + name;
    numbers_.push_back(value);
  }
  template <typename Derived>
  void add(const std::string& name, const Eigen::MatrixBase<Derived>& matrix) {  // column by column
    for (Eigen::Index j = 0; j < matrix.cols(); ++j)
      for (Eigen::Index i = 0; i < matrix.rows(); ++i) add(name, matrix(i, j));
  }
  template <typename Matrix>
  void add(const std::string& name, const std::optional<Matrix>& matrix) {  // not there: NaN
    add(name, matrix ? *matrix : Matrix(Matrix::Constant(std::numeric_limits<double>::quiet_NaN())));
  }
  template <std::size_t Size>
  void add(const std::string& name, const std::array<double, Size>& numbers) {
    for (const double value : numbers) add(name, value);
  }
  void end_row() { first_ = false; }
  void write(const std::string& path, const std::string& settings) const {
    std::ofstream file(path, std::ios::binary);
    file << settings << "\n" << names_ << "\n";
    file.write(reinterpret_cast<const char*>(numbers_.data()),
               static_cast<std::streamsize>(numbers_.size() * sizeof(double)));
    if (!file) throw std::runtime_error("cannot write " + path);
  }

 private:
  bool first_ = true;
  std::string names_;
  std::vector<double> numbers_;
};

void add_state(Table& table, const EstimatorState<double>& state) {
  // Every field by its name: with one more, this no longer compiles.
  const auto& [time, updated, payload, inertial, probability, held, swinging, swing_frequency, undecided, confidence,
               health, sensing, tool, changing, change_onset, change_noticed, event] = state;
  const auto& [mean, covariance] = payload;
  const auto& [phi, phi_covariance] = inertial;
  const auto& [number, kind, onset, noticed, over] = event;
  table.add("state.time", time);
  table.add("state.updated", updated);
  table.add("state.payload.mean", mean);
  table.add("state.payload.covariance", covariance);
  table.add("state.payload.standard_deviation()", payload.standard_deviation());
  table.add("state.inertial.mean", phi);
  table.add("state.inertial.covariance", phi_covariance);
  table.add("state.probability", probability.values);
  table.add("state.held", held);
  table.add("state.swinging", swinging);
  table.add("state.swing_frequency", swing_frequency);
  table.add("state.undecided", undecided);
  table.add("state.confidence", confidence);
  table.add("state.health", health);
  table.add("state.sensing", sensing);
  table.add("state.tool", tool);
  table.add("state.heavier_than(0.5)", state.heavier_than(0.5));
  table.add("state.changing", changing ? 1 : 0);
  table.add("state.change_onset", change_onset);
  table.add("state.change_noticed", change_noticed);
  table.add("state.event.number", number);
  table.add("state.event.kind", static_cast<int>(kind));
  table.add("state.event.onset", onset);
  table.add("state.event.noticed", noticed);
  table.add("state.event.over", over);
  table.add("state.empty()", state.empty() ? 1 : 0);
  table.add("state.friction_shows()", state.friction_shows());
}

template <int Dofs, typename From>
JointVector<double, Dofs> joints_of(const From& panda) {
  JointVector<double, Dofs> out;
  for (int j = 0; j < Dofs; ++j) out[j] = j < 7 ? panda[j] : 0.5 * panda[3];
  return out;
}

template <int Dofs>
EstimatorConfig<double, Dofs> settings(bool everything) {
  EstimatorConfig<double, Dofs> config;
  if (!everything) return config;
  config.gravity << 0.1, -0.2, -9.8;
  config.rated_payload = 5;
  config.observer_bandwidth = 45;
  config.sensing = Sensing::JointFriction;
  config.arm = ArmPrior<double, Dofs>::of(4);
  config.payload = PayloadPrior<double>::of(4);
  return config;
}

template <int Dofs>
void run(const examples::Log<7>& log, bool everything, const std::string& out) {
  const double dt = 0.001;
  const EstimatorConfig<double, Dofs> config = settings<Dofs>(everything);
  Estimator<double, Dofs> estimator(dt, config);
  CompensationRamp<double, Dofs> ramp(dt, {JointVector<double, Dofs>::Constant(300)});
  MomentumObserver<double, Dofs> observer(dt, {JointVector<double, Dofs>::Constant(40)});
  JointVector<double, Dofs> compensation = JointVector<double, Dofs>::Zero();
  Table table;
  for (std::size_t i = 0; i < log.size(); ++i) {
    const auto pose = examples::panda().kinematics(log.q[i]);
    Proprioception<double, Dofs> sample;
    sample.tau_ext = joints_of<Dofs>(log.tau_ext[i]);
    for (int row = 0; row < 6; ++row)
      sample.jacobian.row(row) = joints_of<Dofs>(JointVector<double, 7>(pose.jacobian.row(row))).transpose();
    sample.rotation = pose.rotation;
    sample.dq = joints_of<Dofs>(log.dq[i]);
    std::optional<JointVector<double, 9>> motion;
    if (everything) {
      const double x = static_cast<double>(i);
      if (i % 3 == 0) sample.period = 0.00125;
      if (i % 200 < 100) sample.compensation = 0.9 * compensation;
      if (i % 300 < 150) sample.gravity_torque = 0.5 * sample.jacobian.template topRows<3>().transpose();
      if (i % 400 > 300) {
        sample.motion = FlangeMotion<double>{{0.01 * x, 0.02, 0.03}, {0.1, 0.001 * x, -0.2}, {0.2, -0.1, 0.0005 * x}};
      }
      // Samples that are refused: they show as well that an argument arrives which changes little here.
      const double nan = std::numeric_limits<double>::quiet_NaN();
      if (i == 90) sample.dq[1] = nan;
      if (i == 95) sample.rotation *= 1.1;
      if (i == 96) (*sample.compensation)[2] = nan;
      if (i == 97) (*sample.gravity_torque)(1, 2) = nan;
      if (i == 310) sample.motion->angular_acceleration[1] = nan;
      if (sample.motion)
        motion.emplace() << sample.motion->angular_velocity, sample.motion->linear_acceleration,
            sample.motion->angular_acceleration;
    }
    int call = 0;
    if (everything) {
      if (i == 50) call = 1;
      if (i == 120) call = 2;
      if (i == 200 || i == 800) call = 3;
      if (i == 230 || i == 810) call = 4;
      if (i == 270) call = 5;
      if (i == 290 || i == 1100) call = 6;
    }
    if (call == 1) estimator.declare_empty();
    if (call == 2) estimator.expect_change();
    if (call == 3) estimator.in_contact(true);
    if (call == 4) estimator.in_contact(false);
    if (call == 5)
      (void)estimator.set_payload(PayloadGaussian<double>::independent({0.7, 0.06, 0, 0.13}, {0.05, 0.01, 0.01, 0.02}));
    if (call == 6) estimator.reset();

    table.add("call", call);
    table.add("tau_ext", sample.tau_ext);
    table.add("jacobian", sample.jacobian);
    table.add("rotation", sample.rotation);
    table.add("dq", sample.dq);
    table.add("period", sample.period);
    table.add("motion", motion);
    table.add("compensation", sample.compensation);
    table.add("gravity_torque", sample.gravity_torque);
    table.add("status", static_cast<int>(estimator.update(sample)));
    add_state(table, estimator.state());
    compensation = estimator.compensation(sample.jacobian, sample.rotation);
    table.add("torque", compensation);
    table.add("ramp.status", static_cast<int>(ramp.update(compensation)));
    table.add("ramp.torque", ramp.torque());
    if constexpr (Dofs == 7) {
      if (!log.tau.empty()) {
        const auto terms = examples::panda().dynamics(log.q[i], log.dq[i]);
        const Status status = observer.update(log.tau[i], log.dq[i], terms.mass_matrix, terms.coriolis_transpose,
                                              terms.gravity, sample.period);
        table.add("observer.status", static_cast<int>(status));
        table.add("observer.tau_ext", observer.tau_ext());
      }
    }
    table.end_row();
  }
  table.write(out, estimator_config_to_json(config).dump());
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 5) throw std::invalid_argument("usage: python_reference LOG JOINTS plain|everything OUT");
    const auto log = examples::read_log<7>(argv[1]);
    const std::string joints = argv[2], out = argv[4];
    const bool everything = std::string(argv[3]) == "everything";
    if (joints == "4") run<4>(log, everything, out);
    if (joints == "5") run<5>(log, everything, out);
    if (joints == "6") run<6>(log, everything, out);
    if (joints == "7") run<7>(log, everything, out);
    if (joints == "8") run<8>(log, everything, out);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "python_reference: %s\n", error.what());
    return 3;
  }
}
