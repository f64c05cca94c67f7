#pragma once
/// Damages a good log in the ways in which recordings of arms are wrong, to see whether the diagnosis finds them.
#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "log_diagnosis/recorded_log.hpp"

namespace rme::examples {

/// A log with its arm, as options describe them.
template <int Dofs>
struct Recording {
  FormattedLog<Dofs> read;
  RecordedArm<Dofs> arm;
  EstimatorConfig<double, Dofs> config;
};

/// A way to damage a log of measured torque, and how it has to be named.
template <int Dofs>
struct Damage {
  std::string name;
  std::set<Fault> faults;  ///< any of them is right
  std::string option;      ///< the advice has to contain
  std::function<void(Recording<Dofs>&)> apply;
};

/// The joints of largest gravity torque in the log, largest first.
template <int Dofs>
std::vector<int> heaviest_joints(const Recording<Dofs>& recording) {
  JointVector<double, Dofs> sum = JointVector<double, Dofs>::Zero(), square = sum;
  const auto& q = recording.read.log.q;
  const std::size_t stride = std::max<std::size_t>(1, q.size() / 500);
  double count = 0;
  for (std::size_t i = 0; i < q.size(); i += stride, ++count) {
    const JointVector<double, Dofs> g = recording.arm.model.dynamics(q[i], JointVector<double, Dofs>::Zero()).gravity;
    sum += g;
    square += g.cwiseAbs2();
  }
  const JointVector<double, Dofs> variance = square / count - (sum / count).cwiseAbs2();
  std::vector<int> joints(Dofs);
  for (int j = 0; j < Dofs; ++j) joints[static_cast<std::size_t>(j)] = j;
  std::sort(joints.begin(), joints.end(), [&](int a, int b) { return variance[a] > variance[b]; });
  return joints;
}

/// Forty ways to damage the recording, whose torque is measured torque.
template <int Dofs>
std::vector<Damage<Dofs>> damages(const Recording<Dofs>& good) {
  using Vector = JointVector<double, Dofs>;
  using R = Recording<Dofs>;
  constexpr double kPi = 3.141592653589793;
  std::vector<Damage<Dofs>> out;
  const auto add = [&](const std::string& name, std::set<Fault> faults, const std::string& option,
                       std::function<void(R&)> apply) {
    out.push_back({name, std::move(faults), option, apply});
  };
  const std::vector<int> joints = heaviest_joints(good);
  const int first = joints[0], second = joints[1], third = joints[2];
  const auto joint = [](int j) { return " of joint " + std::to_string(j + 1); };
  const auto each = [](std::vector<Vector>& values, auto&& change) {
    for (Vector& v : values) change(v);
  };
  const auto scaled = [each](double q, double dq, double tau) {
    return [=](R& r) {
      each(r.read.log.q, [&](Vector& v) { v *= q; });
      each(r.read.log.dq, [&](Vector& v) { v *= dq; });
      each(r.read.log.tau, [&](Vector& v) { v *= tau; });
    };
  };
  const auto gained = [each](int j, double gain) {
    return [=](R& r) { each(r.read.log.tau, [&](Vector& v) { v[j] *= gain; }); };
  };
  const auto swapped = [each](int a, int b, bool q, bool tau) {
    return [=](R& r) {
      const auto swap = [&](Vector& v) { std::swap(v[a], v[b]); };
      if (q) {
        each(r.read.log.q, swap);
        each(r.read.log.dq, swap);
      }
      if (tau) each(r.read.log.tau, swap);
    };
  };
  // The arm as it stands has gravity along `down`; the model says -z. The torque changes by the difference.
  const auto turned = [](const Eigen::Vector3d& down) {
    return [=](R& r) {
      ArmModel<Dofs> truth = r.arm.model;
      truth.gravity_vector = 9.81 * down.normalized();
      for (std::size_t i = 0; i < r.read.log.size(); ++i) {
        const Vector& q = r.read.log.q[i];
        const Vector rest = Vector::Zero();
        const Vector change = truth.dynamics(q, rest).gravity - r.arm.model.dynamics(q, rest).gravity;
        r.read.log.tau[i] += change.cwiseQuotient(r.arm.gains);
      }
    };
  };
  const auto loaded = [](double share, const Eigen::Vector3d& centre) {
    return [=](R& r) {
      const RigidBody body{share * r.config.rated_payload, centre, Eigen::Matrix3d::Zero()};
      for (std::size_t i = 0; i < r.read.log.size(); ++i) {
        const Vector &q = r.read.log.q[i], rest = Vector::Zero();
        const Vector change = r.arm.model.dynamics(q, rest, body).gravity - r.arm.model.dynamics(q, rest).gravity;
        r.read.log.tau[i] += change.cwiseQuotient(r.arm.gains);
      }
    };
  };
  const auto late = [](double delay) { return [=](R& r) { detail::advance_torque(r.read.log, -delay); }; };

  add("q and dq in degrees", {Fault::Degrees}, "--degrees", scaled(180 / kPi, 180 / kPi, 1));
  add("q in degrees", {Fault::Degrees}, "--columns", scaled(180 / kPi, 1, 1));
  add("dq in degrees per second", {Fault::Velocity}, "--columns", scaled(1, 180 / kPi, 1));
  add("dq in rpm", {Fault::Velocity}, "--columns", scaled(1, 30 / kPi, 1));
  add("dq opposite", {Fault::Velocity}, "--columns", scaled(1, -1, 1));
  add("dq zero", {Fault::Velocity}, "--columns", scaled(1, 0, 1));
  add("dq opposite" + joint(second), {Fault::Velocity}, "--columns",
      [=](R& r) { each(r.read.log.dq, [&](Vector& v) { v[second] *= -1; }); });
  add("dq in another order", {Fault::Velocity}, "--columns",
      [=](R& r) { each(r.read.log.dq, [&](Vector& v) { v.reverseInPlace(); }); });
  add("t in ms", {Fault::TimeUnit}, "--columns", [](R& r) {
    for (double& t : r.read.log.t) t *= 1e3;
  });
  add("tau in mN m", {Fault::TorqueUnit}, "--gains", scaled(1, 1, 1000));
  add("tau in thousandths of the rated torque", {Fault::TorqueUnit, Fault::Gain}, "--gains", [=](R& r) {
    for (int j = 0; j < Dofs; ++j)
      if (!(r.arm.model.tau_max[j] > 0 && std::isfinite(r.arm.model.tau_max[j]))) r.arm.model.tau_max[j] = 50;
    each(r.read.log.tau, [&](Vector& v) { v = 1000 * v.cwiseQuotient(r.arm.model.tau_max); });
  });
  add("tau opposite", {Fault::TorqueSign}, "--torque-sign reaction", scaled(1, 1, -1));
  for (const int j : {first, second, third}) add("tau opposite" + joint(j), {Fault::Gain}, "--gains", gained(j, -1));
  for (const double gain : {0.5, 0.7, 1.5, 2.0}) {
    char text[20];
    std::snprintf(text, sizeof text, "tau times %.1f", gain);
    add(text, {Fault::TorqueUnit, Fault::Gain}, "--gains", scaled(1, 1, gain));
    add(text + joint(first), {Fault::Gain}, "--gains", gained(first, gain));
    add(text + joint(second), {Fault::Gain}, "--gains", gained(second, gain));
  }
  for (const int j : {first, second})
    add("q opposite" + joint(j), {Fault::PositionSign}, "--columns", [=](R& r) {
      each(r.read.log.q, [&](Vector& v) { v[j] *= -1; });
      each(r.read.log.dq, [&](Vector& v) { v[j] *= -1; });
    });
  add("zero of q off by 90 degrees" + joint(first), {Fault::PositionOffset}, "--columns",
      [=](R& r) { each(r.read.log.q, [&](Vector& v) { v[first] += kPi / 2; }); });
  add("joints 1 and 3 exchanged", {Fault::JointOrder}, "--columns", swapped(0, 2, true, true));
  add("joints reversed", {Fault::JointOrder}, "--columns", [=](R& r) {
    for (auto* values : {&r.read.log.q, &r.read.log.dq, &r.read.log.tau})
      each(*values, [](Vector& v) { v.reverseInPlace(); });
  });
  add("joints 2 and 3 of tau exchanged", {Fault::TorqueOrder, Fault::JointOrder}, "--columns",
      swapped(1, 2, false, true));
  add("joints 2 and 4 of q exchanged", {Fault::JointOrder}, "--columns", swapped(1, 3, true, false));
  add("gravity along +z", {Fault::Gravity}, "--gravity", turned({0, 0, 1}));
  add("gravity along x", {Fault::Gravity}, "--gravity", turned({1, 0, 0}));
  add("gravity along -y", {Fault::Gravity}, "--gravity", turned({0, -1, 0}));
  add("gravity turned by 30 degrees", {Fault::Gravity}, "--gravity", turned({0.5, 0, -std::sqrt(0.75)}));
  add("tau without gravity", {Fault::LacksGravity}, "--tau-lacks-gravity", [](R& r) {
    for (std::size_t i = 0; i < r.read.log.size(); ++i) {
      const Vector rest = Vector::Zero();
      r.read.log.tau[i] -= r.arm.model.dynamics(r.read.log.q[i], rest).gravity.cwiseQuotient(r.arm.gains);
    }
  });
  add("0.3 of the rated payload in the hand", {Fault::Load}, "--tool", loaded(0.3, {0, 0, 0.05}));
  add("0.6 of the rated payload in the hand", {Fault::Load}, "--tool", loaded(0.6, {0.03, -0.02, 0.1}));
  add("tau late by 20 ms", {Fault::Delay}, "--torque-delay", late(0.02));
  add("tau late by 50 ms", {Fault::Delay}, "--torque-delay", late(0.05));
  add("limits of q too narrow", {Fault::PositionLimits}, "--urdf", [=](R& r) {
    double low = r.read.log.q[0][first], high = low;
    for (const Vector& v : r.read.log.q) {
      low = std::min(low, v[first]);
      high = std::max(high, v[first]);
    }
    r.arm.model.q_min[first] = low - 0.1;
    r.arm.model.q_max[first] = low + 0.5 * (high - low);
  });
  add("limits of tau too low", {Fault::TorqueLimits}, "--urdf", [=](R& r) {
    double most = 0;
    for (const Vector& v : r.read.log.tau) most = std::max(most, std::abs(v[first] * r.arm.gains[first]));
    r.arm.model.tau_max[first] = 0.4 * most;
  });
  return out;
}

}  // namespace rme::examples
