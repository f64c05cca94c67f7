#include "make_logs/plan.hpp"

#include <cmath>
#include <stdexcept>
#include <synthetic_arm/random_pose.hpp>

namespace rme::examples {

namespace {

constexpr double kPi = 3.14159265358979323846;

class Dice {
 public:
  explicit Dice(std::mt19937_64& random) : random_(random) {}

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  double normal(double deviation) { return std::normal_distribution<double>(0, deviation)(random_); }
  double tick(double low, double high) { return std::round(1e3 * uniform(low, high)) / 1e3; }
  Eigen::Vector3d normals(double deviation) {
    const double x = normal(deviation), y = normal(deviation), z = normal(deviation);
    return {x, y, z};
  }
  Eigen::Vector3d uniforms(double low, double high) {
    const double x = uniform(low, high), y = uniform(low, high), z = uniform(low, high);
    return {x, y, z};
  }
  Eigen::Vector3d direction() { return normals(1).normalized(); }

 private:
  std::mt19937_64& random_;
};

RigidBody draw_payload(Dice& dice, double least, double most) {
  const double mass = dice.uniform(least, most);
  const double x = dice.uniform(-0.08, 0.08), y = dice.uniform(-0.08, 0.08), z = dice.uniform(0, 0.2);
  const Eigen::Vector3d size = dice.uniforms(0.04, 0.1);
  RigidBody body = box(mass, {x, y, z}, {size[0], size[1], 1.4 * size[2]});
  const Eigen::Vector3d axis = dice.direction();
  const Eigen::Matrix3d R = Eigen::AngleAxisd(dice.uniform(0, kPi), axis).toRotationMatrix();
  body.inertia = R * body.inertia * R.transpose();
  return body;
}

// Near the ready pose.
JointVector<double, 7> draw_ready(Dice& dice) {
  JointVector<double, 7> q = panda().ready;
  for (double& x : q) x += dice.normal(0.1);
  return q;
}

// Stiff enough to follow a path.
PoseImpedanceConfig path_gains() {
  PoseImpedanceConfig gains;
  gains.lambda1 = gains.lambda2 = 150;
  gains.rotation_stiffness = 60;
  gains.rotation_damping = 6;
  return gains;
}

Motion draw_motion(Dice& dice, double start, double rate, double most) {
  Motion motion;
  motion.start = start;
  motion.amplitude = dice.uniforms(0.5 * most, most);
  motion.rate = rate * dice.uniforms(0.75, 1.25);
  motion.phase = dice.uniforms(-kPi, kPi);
  const Eigen::Vector3d first = dice.direction();
  motion.axes << first, first.cross(dice.direction()).normalized();
  for (int i = 0; i < 2; ++i) {
    motion.turn[i] = dice.uniform(30, 45) * kPi / 180;
    motion.turn_rate[i] = rate * dice.uniform(0.75, 1.25);
    motion.turn_phase[i] = dice.uniform(-kPi, kPi);
  }
  return motion;
}

void attach_at_rest(Plan& plan, Dice& dice) {
  plan.offset = dice.normals(0.006);
  plan.events = {{1, true, 'A', draw_payload(dice, 0.2, 2)}};
}

// A is attached, B is added, B is removed, A is removed; a push after each of these, and sometimes one before.
void hand_over(Plan& plan, Dice& dice) {
  plan.offset = dice.normals(0.006);
  const RigidBody a = draw_payload(dice, 0.2, 1.5), b = draw_payload(dice, 0.2, 0.5);
  double t = dice.tick(1.4, 1.7);
  const auto push = [&](double from, double to) {
    const double begin = dice.tick(from, to), duration = dice.tick(0.3, 1);
    const Eigen::Vector3d direction = dice.direction();
    plan.pushes.push_back({begin, duration, dice.uniform(5, 15) * direction});
  };
  if (dice.uniform(0, 1) < 0.5) push(0.2, 0.3);
  for (int k = 0; k < 4; ++k) {
    plan.events.push_back({t, k < 2, k == 0 || k == 3 ? 'A' : 'B', k == 0 || k == 3 ? a : b});
    push(t + 0.9, t + 1.25);
    t += dice.tick(2.8, 3.4);
  }
  plan.duration = t;
}

void carry(Plan& plan, Dice& dice) {
  plan.gains = path_gains();
  plan.duration = 11;
  plan.feed_forward = true;
  plan.events = {{1, true, 'A', draw_payload(dice, 0.2, 2)}};
  plan.motion = draw_motion(dice, 3, dice.uniform(0.9, 1.2), 0.1);
}

// Handed over: somebody lets go of it within 0.3 to 3 s, on an arm that has not moved yet.
void take_over(Plan& plan, Dice& dice) {
  plan.gains = path_gains();
  plan.feed_forward = true;
  const double seconds = dice.tick(0.3, 3);
  plan.events = {{1, true, 'A', draw_payload(dice, 0.2, 2), seconds}};
  plan.motion = draw_motion(dice, 3 + seconds, dice.uniform(0.9, 1.2), 0.1);
  plan.duration = 11 + seconds;
}

// The cup has 30 % of the final mass; the rest is poured in.
void fill(Plan& plan, Dice& dice) {
  plan.offset = dice.normals(0.006);
  const RigidBody full = draw_payload(dice, 0.5, 2), cup = 0.3 * full;
  const double seconds = dice.tick(4, 15);
  plan.events = {{1, true, 'A', cup}, {3, true, 'A', full, seconds}};
  plan.duration = 3 + seconds + 3;
}

void always_moving(Plan& plan, Dice& dice) {
  plan.gains = path_gains();
  plan.duration = 15;
  plan.feed_forward = true;
  const RigidBody body = draw_payload(dice, 0.2, 2);
  plan.events = {{5, true, 'A', body}, {12, false, 'A', body}};
  plan.motion = draw_motion(dice, 0.5, dice.uniform(0.8, 2.5), 0.08);
}

}  // namespace

const std::string kScenarios = "ABDEFHM";

PoseTarget Motion::pose(double t, const PoseTarget& home) const {
  const double s = t - start, x = std::clamp(s / rise, 0.0, 1.0);
  const double share = x * x * x * (10 + x * (6 * x - 15));
  PoseTarget target = home;
  for (int i = 0; i < 3; ++i)
    target.position[i] += share * amplitude[i] * (std::sin(rate[i] * s + phase[i]) - std::sin(phase[i]));
  Eigen::Vector3d turned = Eigen::Vector3d::Zero();
  for (int i = 0; i < 2; ++i) turned += share * turn[i] * std::sin(turn_rate[i] * s + turn_phase[i]) * axes.col(i);
  target.rotation *= Eigen::AngleAxisd(turned.norm(), turned.stableNormalized()).toRotationMatrix();
  return target;
}

PoseTarget Motion::at(double t, const PoseTarget& home) const {
  constexpr double h = 1e-4;
  PoseTarget target = pose(t, home);
  const PoseTarget before = pose(t - h, home), after = pose(t + h, home);
  target.velocity = (after.position - before.position) / (2 * h);
  const Eigen::AngleAxisd turned(after.rotation * before.rotation.transpose());
  target.angular_velocity = turned.angle() / (2 * h) * turned.axis();
  return target;
}

Plan draw_plan(char scenario, std::mt19937_64& random) {
  Dice dice(random);
  const auto uniform = [&](double low, double high) { return dice.uniform(low, high); };
  Plan plan;
  plan.scenario = scenario;
  plan.q0 = scenario == 'B' ? random_panda_pose(uniform) : draw_ready(dice);
  switch (scenario) {
    case 'A':
      attach_at_rest(plan, dice);
      break;
    case 'B':
      plan.singular = 0.05;
      attach_at_rest(plan, dice);
      break;
    case 'D':
      hand_over(plan, dice);
      break;
    case 'E':
      carry(plan, dice);
      break;
    case 'F':
      fill(plan, dice);
      break;
    case 'H':
      take_over(plan, dice);
      break;
    case 'M':
      always_moving(plan, dice);
      break;
    default:
      throw std::invalid_argument(std::string("no scenario ") + scenario);
  }
  return plan;
}

}  // namespace rme::examples
