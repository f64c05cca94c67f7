// pinocchio_payload: estimates the payload of an arm that reports only joint torque. A controller's loop, run on a
// recording: Pinocchio's model of the URDF, rme's momentum observer, the estimator. Prints each event that may have
// changed the payload, with the estimate; at the end, the estimate and the torque that would have carried the payload.
#include <algorithm>
#include <cstdio>
#include <pinocchio/parsers/urdf.hpp>
#include <rme/host/pinocchio.hpp>
#include <rme/rme.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "hosts/settings.hpp"
#include "io/log_reader.hpp"
#include "io/program.hpp"

namespace {

using rme::examples::ArgumentError;
using rme::examples::Arguments;

constexpr const char* kUsage =
    "LOG.csv --urdf FILE --joints J1,J2,... --frame NAME [options]\n"
    "  LOG.csv             t, q1.., dq1.., tau1..: joint torque, gravity included (docs/conventions.md)\n"
    "  --urdf FILE         the robot\n"
    "  --joints J1,J2,...  the arm's joints, six or seven, from the base; all others are locked at zero\n"
    "  --frame NAME        the end effector: a link or joint of the URDF\n"
    "  --settings FILE     settings.json, as check_arm writes it\n"
    "  --rated-payload M   heaviest payload of the arm [kg]\n"
    "  --gains K1,K2,...   tau1.. are motor currents [A]; of each joint, its torque for one [N m/A]\n"
    "  --rotor-inertia I1,I2,...  of each joint, as check_arm names it [kg m^2]\n";

std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> words(1);
  for (const char c : list)
    if (c == ',')
      words.emplace_back();
    else
      words.back() += c;
  return words;
}

const char* name_of(rme::EventKind kind) {
  switch (kind) {
    case rme::EventKind::Attached:
      return "attached";
    case rme::EventKind::Exchanged:
      return "exchanged";
    case rme::EventKind::Removed:
      return "removed";
    case rme::EventKind::Filling:
      return "filling";
    case rme::EventKind::Pushed:
      return "pushed";
    case rme::EventKind::Moved:
      return "moved";
    default:
      return "nothing";
  }
}

void print(const rme::EstimatorState<double>& state) {
  const auto& mean = state.payload.mean;
  const rme::Vector4<double> std = state.payload.standard_deviation();
  std::printf("%8.3f s  %.3f +- %.3f kg at (%.3f, %.3f, %.3f) +- (%.3f, %.3f, %.3f) m, health %.1f\n", state.time,
              mean[0], std[0], mean[1], mean[2], mean[3], std[1], std[2], std[3], state.health);
}

template <int Dofs>
int carry(const pinocchio::Model& robot, const std::vector<std::string>& joints, const std::string& frame,
          const std::string& log_name, const rme::EstimatorConfig<double, Dofs>& config,
          const rme::JointVector<double, Dofs>& gains, const rme::JointVector<double, Dofs>& rotors) {
  const rme::examples::Log<Dofs> log = rme::examples::read_log<Dofs>(log_name);
  if (log.tau.empty() || log.dq.empty())
    throw rme::examples::LogError(log.name + ":1: columns tau1.. and dq1.. needed");
  if (log.size() < 2) throw rme::examples::LogError(log.name + ": one row only");
  std::vector<double> steps;
  for (std::size_t i = 1; i < log.size(); ++i) steps.push_back(log.t[i] - log.t[i - 1]);
  std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2), steps.end());
  const double period = steps[steps.size() / 2];

  rme::PinocchioSensing<Dofs> sensing(rme::pinocchio_arm(robot, joints), frame, period, config, gains, rotors);
  rme::PayloadCompensation<double, Dofs> payload(period, config);
  rme::PayloadChanges changes;
  rme::Proprioception<double, Dofs> sample;
  const rme::EstimatorState<double>& state = payload.state();
  int refused = 0;
  for (std::size_t i = 0; i < log.size(); ++i) {  // the body is that of a control loop
    const double measured = i == 0 ? 0 : log.t[i] - log.t[i - 1];
    rme::Status status = sensing.update(log.q[i], log.dq[i], log.tau[i], measured, sample);
    if (status == rme::Status::Ok) status = payload.update(sample);
    if (status != rme::Status::Ok) ++refused;
    // Here a controller commands its own torque plus payload.torque(); printing belongs in another thread.
    if (changes.since_last(state)) {
      std::printf("%s\n", name_of(state.event.kind));
      print(state);
    }
  }
  print(state);
  std::printf("torque that carries it [N m]:");
  for (const double tau : payload.torque()) std::printf(" %.3f", tau);
  std::printf("\n%zu samples, %d refused\n", log.size(), refused);
  return refused == 0 ? 0 : 1;
}

template <int Dofs>
int run(Arguments& arguments, const std::vector<std::string>& joints, const std::string& urdf) {
  const auto frame = arguments.text("--frame");
  if (!frame) throw ArgumentError("--frame: missing");
  const auto settings = arguments.text("--settings");
  auto config = settings ? hosts::read_settings<Dofs>(*settings) : rme::EstimatorConfig<double, Dofs>();
  if (const auto mass = arguments.number("--rated-payload")) config.rated_payload = *mass;
  rme::JointVector<double, Dofs> gains = rme::JointVector<double, Dofs>::Ones();
  if (const auto given = arguments.numbers("--gains", Dofs))
    gains = Eigen::Map<const rme::JointVector<double, Dofs>>(given->data());
  rme::JointVector<double, Dofs> rotors = rme::JointVector<double, Dofs>::Zero();
  if (const auto given = arguments.numbers("--rotor-inertia", Dofs))
    rotors = Eigen::Map<const rme::JointVector<double, Dofs>>(given->data());
  const std::string log = arguments.positional("LOG.csv");
  arguments.finish();
  pinocchio::Model robot;
  pinocchio::urdf::buildModel(urdf, robot);
  return carry<Dofs>(robot, joints, *frame, log, config, gains, rotors);
}

int dispatch(Arguments& arguments) {
  const auto urdf = arguments.text("--urdf"), joints = arguments.text("--joints");
  if (!urdf) throw ArgumentError("--urdf: missing");
  if (!joints) throw ArgumentError("--joints: missing");
  const std::vector<std::string> names = split(*joints);
  if (names.size() == 6) return run<6>(arguments, names, *urdf);
  if (names.size() == 7) return run<7>(arguments, names, *urdf);
  throw ArgumentError("--joints: six or seven names, got " + std::to_string(names.size()));
}

}  // namespace

int main(int argc, char** argv) {
  return rme::examples::run_program("pinocchio_payload", kUsage, argc, argv, dispatch);
}
