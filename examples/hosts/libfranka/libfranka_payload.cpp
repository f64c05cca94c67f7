// libfranka_payload: a Franka arm holds its pose, or moves, and carries what it is handed, whatever it weighs. Prints the
// estimate twice a second. Keep the stop button within reach, and everybody away from the arm: it is compliant, and moves
// when it is pushed.
#include <franka/exception.h>
#include <poll.h>
#include <unistd.h>
#include <rme/host/franka.hpp>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <exception>
#include <functional>
#include <iostream>
#include <mutex>
#include <rme/rme.hpp>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "hosts/libfranka/nominal.hpp"
#include "hosts/settings.hpp"
#include "io/program.hpp"

namespace {

using Payload = rme::PayloadCompensation<double, 7>;
using rme::examples::Arguments;

constexpr const char* kUsage =
    "ADDRESS [options]\n"
    "  --settings FILE     the estimator's settings; a missing one is that of rme::franka_config()\n"
    "  --realtime R        enforce (default): only on a real-time kernel; ignore: on any, for tests without a robot\n"
    "  --soft              springs of 150 N/m at the hand, instead of stiffer ones at the joints\n"
    "  --circle R          with --soft: the hand goes round a vertical circle of this radius [m], and tilts\n"
    "  --off               begins without the compensation\n"
    "Lines on standard input are requests:\n"
    "  load      hand the payload over to the robot's own load, if mass and centre of mass are certain enough\n"
    "  empty     the hand is empty now: clear the robot's load\n"
    "  on, off   fade the compensation in or out\n"
    "  rest      end the circle\n"
    "  quit      end the control loop and the program\n";

enum class Request { None, Load, Empty, On, Off, Rest, Quit };

/// Data that the two threads share.
struct Shared {
  std::atomic<Request> request{Request::None};
  std::atomic<bool> running{true};
  std::atomic<double> radius{0};  // of the circle, from the next control loop on [m]
  std::mutex mutex;
  rme::EstimatorState<double> state;  // under the mutex
};

/// A controller's torque; the flag asks it to come to rest.
using Nominal = std::function<franka::Torques(const franka::RobotState&, franka::Duration, bool)>;
using NominalFrom = std::function<Nominal(const franka::Model&, const franka::RobotState&)>;

/// Asks the robot to carry the payload, and says what came of it.
void load(franka::Robot& robot, Payload& payload) {
  const rme::FrankaHandOver result = rme::franka_hand_over(robot, payload);
  const auto& judged = result.judged;
  if (!judged.ready())
    std::printf("load: refused: %s. In some pose the torque of joint %d may be wrong by %.2f N m; allowed: %.2f\n",
                rme::to_string(judged.verdict), judged.joint + 1, judged.torque_error, judged.torque_limit);
  else
    std::printf(
        "load: %.3f kg at (%.3f, %.3f, %.3f) m asked for; the robot carries %.3f kg at (%.3f, %.3f, %.3f) m%s\n",
        result.asked.mass, result.asked.com[0], result.asked.com[1], result.asked.com[2], result.taken.mass,
        result.taken.com[0], result.taken.com[1], result.taken.com[2], result.done ? "" : ": it did not take it");
}

/// Carries out a request, between two control loops.
void answer(franka::Robot& robot, Payload& payload, Request request) {
  try {
    if (request == Request::Load) return load(robot, payload);
    rme::franka_clear_load(robot, payload);
    std::printf("empty: the robot carries nothing\n");
  } catch (const franka::CommandException& error) {  // nothing has changed
    std::printf("%s\n", error.what());
  }
}

/// The robot's thread: one control loop after another. Requests that need setLoad are carried out between them, since
/// it works only there.
void carry(franka::Robot& robot, const franka::Model& model, Payload& payload, const NominalFrom& nominal_from,
           Shared& shared) {
  for (;;) {
    Nominal nominal = nominal_from(model, robot.readOnce());
    const rme::Status status =
        rme::franka_control(robot, model, payload, [&](const franka::RobotState& state, franka::Duration period) {
          // The control loop must not wait: if the other thread is reading, this state is left out.
          if (const std::unique_lock<std::mutex> lock(shared.mutex, std::try_to_lock); lock)
            shared.state = payload.state();
          if (shared.request == Request::On || shared.request == Request::Off) {
            payload.enable(shared.request == Request::On);
            shared.request = Request::None;
          }
          const bool wanted = shared.request != Request::None || payload.load_lost();
          const franka::Torques torques = nominal(state, period, wanted);
          const bool at_rest = Eigen::Map<const hosts::Vector7>(state.dq.data()).norm() < 0.05;  // [rad/s]
          const bool ends = shared.request == Request::Quit || (wanted && at_rest);
          // The last command is an ordinary one: a step to zero would be a fault.
          return ends ? franka::MotionFinished(torques) : torques;
        });
    if (status != rme::Status::Ok) {
      std::printf("a sample was refused: %s\n", rme::to_string(status));
      return;
    }
    const Request request = shared.request;
    if (request == Request::Quit) return;
    if (payload.load_lost()) {
      std::printf("the load was dropped\n");
      answer(robot, payload, Request::Empty);
    }
    if (request == Request::None) continue;
    if (request == Request::Rest)
      shared.radius = 0;
    else
      answer(robot, payload, request);
    shared.request = Request::None;
  }
}

void print(const rme::EstimatorState<double>& state, bool changed) {
  const auto& mean = state.payload.mean;
  const rme::Vector4<double> std = state.payload.standard_deviation();
  std::printf("%7.1f s  %.3f +- %.3f kg at (%.3f, %.3f, %.3f) +- (%.3f, %.3f, %.3f) m, health %.1f%s\n", state.time,
              mean[0], std[0], mean[1], mean[2], mean[3], std[1], std[2], std[3], state.health,
              changed                                         ? ", changed"
              : state.probability[rme::Mode::Disturbed] > 0.5 ? ", pushed"
                                                              : "");
  std::fflush(stdout);
}

/// The user's thread: prints, and waits for a line at the same time.
void talk(Shared& shared) {
  const std::vector<std::pair<std::string, Request>> requests = {{"load", Request::Load}, {"empty", Request::Empty},
                                                                 {"on", Request::On},     {"off", Request::Off},
                                                                 {"rest", Request::Rest}, {"quit", Request::Quit}};
  rme::PayloadChanges changes;
  while (shared.running) {
    pollfd input = {STDIN_FILENO, POLLIN, 0};
    if (shared.request != Request::None) {  // wait until it has been carried out
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      continue;
    }
    if (std::cin.rdbuf()->in_avail() > 0 || poll(&input, 1, 500) > 0) {
      std::string line;
      Request request = Request::None;
      if (!std::getline(std::cin, line)) request = Request::Quit;
      for (const auto& [word, meant] : requests)
        if (line == word) request = meant;
      if (request == Request::None) std::printf("load, empty, on, off, rest or quit\n");
      shared.request = request;
    }
    rme::EstimatorState<double> state;
    {
      const std::lock_guard<std::mutex> lock(shared.mutex);
      state = shared.state;
    }
    print(state, changes.since_last(state));
  }
}

int run(Arguments& arguments) {
  rme::PayloadCompensationConfig<double, 7> config;
  config.estimator = rme::franka_config();
  if (const auto file = arguments.text("--settings"))
    config.estimator = hosts::read_settings<7>(*file, config.estimator);
  const franka::RealtimeConfig realtime =
      arguments
          .choice<franka::RealtimeConfig>("--realtime", {{"enforce", franka::RealtimeConfig::kEnforce},
                                                         {"ignore", franka::RealtimeConfig::kIgnore}})
          .value_or(franka::RealtimeConfig::kEnforce);
  const bool soft = arguments.flag("--soft");
  const double radius = arguments.number("--circle").value_or(0);
  if (radius != 0 && !soft) throw rme::examples::ArgumentError("--circle: only with --soft");
  config.enabled = !arguments.flag("--off");
  const std::string address = arguments.positional("ADDRESS");
  arguments.finish();

  Payload payload(0.001, config);
  Shared shared;
  shared.radius = radius;
  const NominalFrom nominal_from = [&](const franka::Model& model, const franka::RobotState& begin) -> Nominal {
    if (soft) return hosts::SoftHand(model, begin, shared.radius);
    return hosts::JointHold(model, begin);
  };
  try {
    franka::Robot robot(address, realtime);
    // To the robot, an unknown payload is a contact: the thresholds are above the torque of the payloads to come.
    robot.setCollisionBehavior({{60, 60, 55, 55, 40, 35, 30}}, {{80, 80, 75, 75, 55, 45, 40}},
                               {{60, 60, 60, 40, 40, 40}}, {{80, 80, 80, 55, 55, 55}});
    const franka::Model model = robot.loadModel();
    std::printf("The arm will hold its pose, and can be pushed. Enter to begin.\n");
    std::cin.ignore(1000, '\n');

    std::exception_ptr error;
    std::thread robots_thread([&] {
      try {
        carry(robot, model, payload, nominal_from, shared);
      } catch (...) {
        error = std::current_exception();
      }
      shared.running = false;
    });
    talk(shared);
    robots_thread.join();
    if (error) std::rethrow_exception(error);
  } catch (const franka::Exception& error) {
    std::fprintf(stderr, "%s\n", error.what());  // the robot has stopped by itself
    return 1;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  std::ios::sync_with_stdio(false);  // otherwise in_avail() would not count lines that have been read ahead
  return rme::examples::run_program("libfranka_payload", kUsage, argc, argv, run);
}
