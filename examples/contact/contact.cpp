// contact: how small a contact does the estimator notice while the arm carries a payload in motion, and how soon?
//
// A Panda (carrying_arm.hpp) carries 2 kg along a sine path at 0.5 Hz. After a minute it is pushed for 0.3 s, again and again, in random directions: at the tip, and at
// the elbow. Prints the threshold with the payload and with an empty hand, how many pushes were noticed and after what
// time, how many were found at the right place, and how many contacts were noticed that were none.
#include <algorithm>
#include <array>
#include <cstdio>
#include <random>
#include <rme/estimator.hpp>
#include <stdexcept>
#include <string>
#include <synthetic_arm/runge_kutta.hpp>
#include <vector>

#include "carrying_arm.hpp"
#include "io/program.hpp"

namespace {

using namespace rme::examples;
using Eigen::Vector3d;
using Joints = rme::JointVector<double, 7>;

constexpr double kPeriod = 1e-3, kFirstPush = 60;  // [s]
constexpr double kPush = 0.3, kJudged = 1.3;       // duration of a push, and when it is judged after its onset [s]
constexpr double kForever = 30;                    // a contact lasts that long only if it never ends [s]
constexpr double kAttach = CarryingArm::kAttach, kMove = CarryingArm::kMove;

constexpr const char* kUsage = R"(usage: rme_contact [options]

Prints how many pushes are noticed while an arm moves 2 kg, and after what time.

  --pushes N   how many, over all rows (default 200)
  --friction   the torque contains joint friction
  --noise N    standard deviation of the noise of dq [rad/s] (default 0)
  --seed N     of everything random (default 1)
  --help       this text

Exit codes: 0 done; 1 a push of 5 N or more was not noticed, or one in ten had another cause; 2 unusable arguments.
)";

struct Options {
  std::size_t pushes = 200;
  CarryingArm arm;
};

/// A torque that something at the elbow makes, in all steps of the physics: the arm has no place for it in its Load.
Joints& torque_at_elbow() {
  static Joints torque = Joints::Zero();
  return torque;
}

class PushedPhysics final : public Physics<7> {
 public:
  PushedPhysics(const ArmModel<7>& model, const JointFriction<7>& friction) : physics_(model, friction) {}
  static std::unique_ptr<Physics<7>> make(const ArmModel<7>& model, const JointFriction<7>& friction) {
    return std::make_unique<PushedPhysics>(model, friction);
  }
  Joints step(double h, const Load<7>& load, JointState<7>& state) override {
    Load<7> pushed = load;
    pushed.torque += torque_at_elbow();
    return physics_.step(h, pushed, state);
  }

 private:
  RungeKutta<7> physics_;
};

/// Joint torque of a force at the origin of link 4, which is the elbow.
Joints elbow_torque(const Joints& q, const Vector3d& force) {
  Vector3d origin = Vector3d::Zero();
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  std::array<Vector3d, 4> origins, axes;
  for (std::size_t i = 0; i < 4; ++i) {
    const Link& link = panda().links[i];
    origin += rotation * link.offset;
    rotation =
        rotation * link.rotation * Eigen::AngleAxisd(q[static_cast<int>(i)], Vector3d::UnitZ()).toRotationMatrix();
    origins[i] = origin;
    axes[i] = rotation.col(2);
  }
  Joints torque = Joints::Zero();
  for (std::size_t i = 0; i < 3; ++i) torque[static_cast<int>(i)] = axes[i].cross(origins[3] - origins[i]).dot(force);
  return torque;
}

/// The pushes of one row of the table.
struct Row {
  double force;  ///< [N]
  bool elbow;
  int count = 0, noticed = 0, in_time = 0, placed = 0, contact = 0;
  std::vector<double> delay = {};  ///< of those that were noticed [ms]

  double quantile(double share) {
    if (delay.empty()) return 0;
    std::sort(delay.begin(), delay.end());
    return delay[std::min(delay.size() - 1, static_cast<std::size_t>(share * static_cast<double>(delay.size())))];
  }
};

struct Result {
  double threshold = 0;  ///< of the joint with the largest one, mean from 30 s on [N m]
  int others = 0;        ///< contacts that no push made, from the first second of motion on
  double minutes = 0;    ///< in which they could have been noticed
  std::array<Row, 4> rows = {Row{2, false}, Row{5, false}, Row{10, false}, Row{10, true}};
};

/// @param mass    of the payload [kg]; 0 for none
/// @param pushes  how many; without any, a minute is simulated
Result run_arm(const Options& options, double mass, std::size_t pushes) {
  SyntheticArmConfig<7> faults = options.arm.faults();
  faults.physics = PushedPhysics::make;
  SyntheticArm<7> arm(panda(), faults, panda().ready);
  PoseImpedance<7> controller = CarryingArm::controller();
  const Kinematics<7> home = panda().kinematics(panda().ready);
  const auto estimator = std::make_unique<rme::Estimator<double, 7>>(kPeriod);
  std::mt19937_64 random(options.arm.seed * 77 + 5);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(0, 1);

  Result result;
  Row* row = nullptr;  // of the push that goes on
  std::size_t done = 0;
  double next = kFirstPush, began = 0;
  int number = 0;
  long averaged = 0;
  bool attached = false, noticed = false, placed = false;
  Joints threshold = Joints::Zero();
  torque_at_elbow().setZero();
  while (pushes > 0 ? done < pushes : arm.time() < kFirstPush) {
    const double t = arm.time();
    if (!attached && mass > 0 && t > kAttach) attached = arm.attach(CarryingArm::payload(mass)) > 0;
    controller.follow(CarryingArm::path(home, t));
    const auto& [position, rotation, jacobian] = arm.kinematics();
    const rme::Status status = estimator->update({arm.tau_ext(), jacobian, rotation, arm.dq()});
    if (status != rme::Status::Ok) throw std::runtime_error(to_string(status));
    const auto& contact = estimator->contact();
    if (t > kFirstPush / 2 && t < kFirstPush) {
      threshold += contact.threshold;
      ++averaged;
    }
    if (row == nullptr && contact.last.number > number) {
      result.others += t > kMove + 1 ? 1 : 0;
      number = contact.last.number;
    }
    if (row == nullptr && t > next + kForever) throw std::runtime_error("a contact does not end");
    if (row == nullptr && pushes > 0 && t > next && !contact.contact) {
      row = &result.rows[static_cast<std::size_t>(4 * uniform(random)) % 4];
      const Vector3d force = row->force * Vector3d{normal(random), normal(random), normal(random)}.normalized();
      if (row->elbow)
        torque_at_elbow() = elbow_torque(arm.q(), force);
      else
        arm.push({force, Vector3d::Zero()});
      began = t;
      noticed = placed = false;
    }
    if (row != nullptr) {
      const double since = t - began;
      if (!noticed && since < kPush && contact.last.number > number) {
        noticed = true;
        number = contact.last.number;
        row->delay.push_back(1e3 * since);
        row->noticed += 1;
        row->in_time += since < 0.0255 ? 1 : 0;
      }
      if (noticed && !placed && since > 0.1) {
        placed = true;
        const int link = contact.likeliest_link();
        // A force at the elbow is at the end of link 3 and at the beginning of link 4.
        row->placed += row->elbow ? (link == 3 || link == 4 ? 1 : 0) : (link == 7 ? 1 : 0);
      }
      if (since > kPush) {
        torque_at_elbow().setZero();
        arm.push({});
      }
      if (since > kJudged) {
        result.others += contact.last.number - number;
        number = contact.last.number;
        row->count += 1;
        row->contact += contact.last.cause == rme::ContactCause::Contact ? 1 : 0;
        row = nullptr;
        ++done;
        next = t + 0.5 + uniform(random);
      }
    }
    arm.step(controller.torque(arm.q(), arm.dq(), arm.kinematics(), arm.dynamics()) +
             estimator->compensation(jacobian, rotation));
  }
  result.threshold = threshold.maxCoeff() / static_cast<double>(averaged);
  result.minutes = (arm.time() - kMove) / 60;
  return result;
}

int run(Arguments& arguments) {
  Options options;
  options.pushes = arguments.whole("--pushes", 1, 100000).value_or(200);
  options.arm.friction = arguments.flag("--friction");
  options.arm.noise = arguments.number("--noise").value_or(0);
  options.arm.seed = arguments.whole("--seed", 0).value_or(1);
  arguments.finish();

  const Result empty = run_arm(options, 0, 0);
  Result result = run_arm(options, 2, options.pushes);
  std::printf("Threshold of the least sensitive joint: %.3f N m with 2 kg, %.3f N m with an empty hand.\n",
              result.threshold, empty.threshold);
  std::printf("Contacts that were none: %d in %.0f min.\n\n", result.others, result.minutes);
  std::printf("| push          | count | noticed | within 25 ms | median ms | 95 %% ms | right link | right cause |\n");
  std::printf("|---------------|------:|--------:|-------------:|----------:|--------:|-----------:|------------:|\n");
  bool all = true;
  for (Row& row : result.rows) {
    const double percent = 100.0 / std::max(1, row.count);
    std::printf("| %2.0f N, %-8s | %5d | %5.1f %% |      %5.1f %% | %9.0f | %7.0f |     %4.0f %% |     %5.1f %% |\n",
                row.force, row.elbow ? "elbow" : "tip", row.count, percent * row.noticed, percent * row.in_time,
                row.quantile(0.5), row.quantile(0.95), percent * row.placed, percent * row.contact);
    if (row.force > 2) all &= row.noticed == row.count && row.contact > 0.9 * row.count;
  }
  return all ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("rme_contact", kUsage, argc, argv, run);
}
