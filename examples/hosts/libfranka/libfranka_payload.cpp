// libfranka_payload: a Franka arm holds its pose and carries what it is handed, whatever it weighs.
//
//     libfranka_payload ADDRESS [SETTINGS.json]
//
// Prints the estimate twice a second. These lines on standard input are requests:
//     load    hand the payload over to the robot's own load, if the estimate is certain enough
//     empty   the hand is empty now: clear the robot's load
//     quit    end the control loop and the program
// Keep the stop button within reach, and everybody away from the arm: it is compliant, and moves when it is pushed.
#include <franka/exception.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <exception>
#include <iostream>
#include <mutex>
#include <string>
#include <thread>

#include "hosts/libfranka/franka_control.hpp"

namespace {

using Vector = rme::JointVector<double, 7>;

enum class Request { None, Load, Empty, Quit };

/// Data that the two threads share.
struct Shared {
  std::atomic<Request> request{Request::None};
  std::atomic<bool> running{true};
  std::mutex mutex;
  rme::EstimatorState<double> state;  // under the mutex
};

/// Springs and dampers at the joints, from the pose in which the loop begins. libfranka adds gravity.
class JointHold {
 public:
  JointHold(const franka::Model& model, const std::array<double, 7>& q)
      : model_(model), held_(Eigen::Map<const Vector>(q.data())) {}

  franka::Torques operator()(const franka::RobotState& state) {
    const Vector stiffness = (Vector() << 600, 600, 600, 600, 100, 100, 50).finished();  // [N m/rad]
    const Vector damping = (Vector() << 40, 40, 40, 40, 4, 4, 1).finished();             // [N m s/rad]
    const std::array<double, 7> coriolis = model_.coriolis(state);
    const Vector wanted = stiffness.cwiseProduct(held_ - Eigen::Map<const Vector>(state.q.data())) -
                          damping.cwiseProduct(Eigen::Map<const Vector>(state.dq.data())) +
                          Eigen::Map<const Vector>(coriolis.data());
    // Half of the robot's torque rate; the other half is for the compensation. The step is counted from this
    // controller's own last torque: tau_J_d includes the compensation.
    last_ += (wanted - last_).cwiseMax(-0.5).cwiseMin(0.5);  // [N m] in a millisecond
    franka::Torques torques(std::array<double, 7>{});
    Eigen::Map<Vector>(torques.tau_J.data()) = last_;
    return torques;
  }

 private:
  const franka::Model& model_;
  Vector held_, last_ = Vector::Zero();
};

/// Carries out a request, between two control loops.
void answer(franka::Robot& robot, hosts::PayloadCompensation<7>& payload, Request request) {
  try {
    if (request == Request::Load) {
      if (hosts::hand_over(robot, robot.readOnce(), payload))
        std::printf("load: the robot carries %.3f kg\n", robot.readOnce().m_load);
      else
        std::printf("load: not sure yet\n");
    } else {
      robot.setLoad(0, {0, 0, 0}, {0, 0, 0, 0, 0, 0, 0, 0, 0});
      payload.reset();
      std::printf("empty: the robot carries nothing\n");
    }
  } catch (const franka::CommandException& error) {  // nothing has changed
    std::printf("%s\n", error.what());
  }
}

/// The robot's thread: one control loop after another. Requests are carried out between them, since setLoad works only
/// there.
void carry(franka::Robot& robot, const franka::Model& model, hosts::PayloadCompensation<7>& payload, Shared& shared) {
  for (;;) {
    JointHold hold(model, robot.readOnce().q);
    const rme::Status status = hosts::control(robot, model, payload, [&](const franka::RobotState& state) {
      // The control loop must not wait: if the other thread is reading, this state is left out.
      if (const std::unique_lock<std::mutex> lock(shared.mutex, std::try_to_lock); lock)
        shared.state = payload.estimator().state();
      const franka::Torques torques = hold(state);
      const bool at_rest = Eigen::Map<const Vector>(state.dq.data()).norm() < 0.1;  // [rad/s]
      return shared.request != Request::None && at_rest ? franka::MotionFinished(torques) : torques;
    });
    if (status != rme::Status::Ok) {
      std::printf("a sample was refused: %s\n", rme::to_string(status));
      return;
    }
    if (shared.request == Request::Quit) return;
    answer(robot, payload, shared.request);
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
  hosts::PayloadChanges changes;
  while (shared.running) {
    pollfd input = {STDIN_FILENO, POLLIN, 0};
    if (shared.request != Request::None) {  // wait until it has been carried out
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      continue;
    }
    if (std::cin.rdbuf()->in_avail() > 0 || poll(&input, 1, 500) > 0) {
      std::string line;
      const bool end = !std::getline(std::cin, line);
      if (end || line == "quit")
        shared.request = Request::Quit;
      else if (line == "load")
        shared.request = Request::Load;
      else if (line == "empty")
        shared.request = Request::Empty;
      else
        std::printf("load, empty or quit\n");
    }
    rme::EstimatorState<double> state;
    {
      const std::lock_guard<std::mutex> lock(shared.mutex);
      state = shared.state;
    }
    print(state, changes.since_last(state));
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 && argc != 3) {
    std::fprintf(stderr, "usage: libfranka_payload ADDRESS [SETTINGS.json]\n");
    return 2;
  }
  std::ios::sync_with_stdio(false);  // otherwise in_avail() would not count lines that have been read ahead
  try {
    const rme::EstimatorConfig<double, 7> config =
        argc == 3 ? hosts::read_settings<7>(argv[2]) : hosts::franka_config();
    hosts::PayloadCompensation<7> payload(0.001, config);
    franka::Robot robot(argv[1]);
    // To the robot, an unknown payload is a contact: the thresholds are above the torque of the payloads to come.
    robot.setCollisionBehavior({{60, 60, 55, 55, 40, 35, 30}}, {{80, 80, 75, 75, 55, 45, 40}},
                               {{60, 60, 60, 40, 40, 40}}, {{80, 80, 80, 55, 55, 55}});
    const franka::Model model = robot.loadModel();
    std::printf("The arm will hold its pose, and can be pushed. Enter to begin.\n");
    std::cin.ignore(1000, '\n');

    Shared shared;
    std::exception_ptr error;
    std::thread robots_thread([&] {
      try {
        carry(robot, model, payload, shared);
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
  } catch (const std::exception& error) {
    std::fprintf(stderr, "libfranka_payload: %s\n", error.what());
    return 3;
  }
  return 0;
}
