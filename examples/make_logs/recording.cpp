#include "make_logs/recording.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <memory>
#include <rme/core/payload.hpp>
#include <stdexcept>
#include <synthetic_arm/random_pose.hpp>
#include <type_traits>

namespace rme::examples {

namespace {

using Vector = JointVector<double, 7>;

constexpr double kMargin = 0.05;          // least distance of a joint from its limits [rad]
constexpr double kFeedForwardFrom = 0.5;  // when the compensation begins, after the attachment [s]
constexpr double kFeedForwardRise = 1;    // until it is complete [s]

// A payload on the flange.
struct Carried {
  char slot;
  int handle;
  RigidBody body;
  double since;  // [s]
};

/// The host: it moves the target, attaches and removes payloads, pushes, and records what the arm reports.
class Recorder {
 public:
  Recorder(const Plan& plan, const SyntheticArmConfig<7>& config)
      : plan_(plan), arm_(panda(), config, plan.q0), law_(panda(), plan.q0, plan.gains) {
    const Kinematics<7>& at = arm_.kinematics();
    home_ = {at.position + plan.offset, at.rotation};
    law_.follow(home_);
  }

  Recording run() {
    Recording out;
    const long ticks = std::lround(plan_.duration / 1e-3);
    out.rows.reserve(static_cast<std::size_t>(ticks + 1));
    for (long k = 0; k <= ticks && out.refusal.empty(); ++k) {
      const Vector tau = tick();
      const RigidBody truth = arm_.payload();
      Eigen::Vector4d theta = Eigen::Vector4d::Zero();
      if (truth.mass > 0) theta << truth.mass, truth.com;
      if (!arm_.lost()) out.rows.push_back({arm_.time(), arm_.q(), arm_.dq(), tau, arm_.tau_ext(), theta, push_});
      out.refusal = refusal(tau, k);
      arm_.step(tau);
    }
    return out;
  }

 private:
  // The torque for the next period.
  Vector tick() {
    const double t = arm_.time();
    for (; next_ < plan_.events.size() && plan_.events[next_].t <= t + 1e-6; ++next_) hand_over(plan_.events[next_]);
    push_.setZero();
    for (const PushEvent& p : plan_.pushes)
      if (t > p.t - 1e-6 && t < p.t + p.duration - 1e-6) push_ += p.force;
    arm_.push({push_, Eigen::Vector3d::Zero()});
    if (plan_.motion) law_.follow(plan_.motion->at(t, home_));
    return law_.torque(arm_.q(), arm_.dq(), arm_.kinematics(), arm_.dynamics()) + feed_forward();
  }

  void hand_over(const PayloadEvent& event) {
    const auto held =
        std::find_if(carried_.begin(), carried_.end(), [&](const Carried& c) { return c.slot == event.slot; });
    if (!event.attach) {
      if (held == carried_.end()) return;
      arm_.detach(held->handle);
      carried_.erase(held);
    } else if (held == carried_.end()) {
      carried_.push_back({event.slot, arm_.attach(event.body, event.ramp), event.body, event.t + event.ramp});
    } else {  // more of the same payload
      const double more = (event.body.mass - held->body.mass) / event.body.mass;
      (void)arm_.attach(more * event.body, event.ramp);
    }
  }

  Vector feed_forward() const {
    Vector6<double> wrench = Vector6<double>::Zero();
    for (const Carried& c : carried_) {
      const double share =
          plan_.feed_forward ? std::clamp((arm_.time() - c.since - kFeedForwardFrom) / kFeedForwardRise, 0.0, 1.0) : 0;
      wrench += share * payload_wrench(Payload<double>{c.body.mass, c.body.com}, arm_.kinematics().rotation).vector();
    }
    return -arm_.kinematics().jacobian.transpose() * wrench;
  }

  std::string refusal(const Vector& tau, long k) const {
    const ArmModel<7>& model = panda();
    const Vector &q = arm_.q(), &dq = arm_.dq();
    if ((q - model.q_min).minCoeff() < kMargin || (model.q_max - q).minCoeff() < kMargin) return "joint limit";
    if ((dq.cwiseAbs() - model.dq_max).maxCoeff() > 0) return "joint speed";
    if ((tau.cwiseAbs() - model.tau_max).maxCoeff() > 0) return "joint torque";
    if (k % 20 == 0 && !is_mobile(arm_.kinematics().jacobian, plan_.singular)) return "singular pose";
    return {};
  }

  const Plan& plan_;
  SyntheticArm<7> arm_;
  PoseImpedance<7> law_;
  PoseTarget home_;
  std::vector<Carried> carried_;
  std::size_t next_ = 0;
  Eigen::Vector3d push_ = Eigen::Vector3d::Zero();
};

// Formats numbers with a fixed count of decimals, faster than a stream.
class Line {
 public:
  void number(double value, int decimals) {
    std::array<char, 64> digits;
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed, decimals).ptr;
    if (!text_.empty() && text_.back() != '\n') text_ += ',';
    text_.append(digits.data(), end);
  }
  template <typename Values>
  void numbers(const Values& values, int decimals) {
    for (const double value : values) number(value, decimals);
  }
  void end() { text_ += '\n'; }
  std::string& text() { return text_; }

 private:
  std::string text_;
};

std::string csv(const Recording& recording) {
  Line line;
  std::string& head = line.text();
  head = "t";
  for (const char* name : {"q", "dq", "tau_c", "tau_ext"})
    for (int i = 1; i <= 7; ++i) head += std::string(",") + name + std::to_string(i);
  head += ",m,rx,ry,rz,push_x,push_y,push_z\n";
  for (const RecordedRow& row : recording.rows) {
    line.number(row.t, 3);
    line.numbers(row.q, 8);
    line.numbers(row.dq, 7);
    line.numbers(row.tau_c, 5);
    line.numbers(row.tau_ext, 5);
    line.numbers(row.truth, 5);
    line.numbers(row.push, 4);
    line.end();
  }
  return line.text();
}

std::string number(double value) {
  std::array<char, 64> digits;
  return {digits.data(),
          std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::general, 10).ptr};
}
template <typename Values>
std::string list(const Values& values) {
  std::string out;
  for (const double value : values) out += (out.empty() ? "[" : ", ") + number(value);
  return out + "]";
}

/// Builds a JSON object, field by field.
class JsonObject {
 public:
  JsonObject& raw(const char* name, const std::string& value) {
    text_ += (text_.empty() ? "{\"" : ", \"") + std::string(name) + "\": " + value;
    return *this;
  }
  JsonObject& field(const char* name, double value) { return raw(name, number(value)); }
  JsonObject& field(const char* name, const std::string& value) { return raw(name, '"' + value + '"'); }
  template <typename Values, std::enable_if_t<!std::is_arithmetic_v<Values>, int> = 0>
  JsonObject& field(const char* name, const Values& values) {
    return raw(name, list(values));
  }
  std::string end() const { return text_ + "}"; }

 private:
  std::string text_;
};

template <typename Values, typename Print>
std::string array(const Values& values, Print print) {
  std::string out;
  for (const auto& value : values) out += (out.empty() ? "" : ", ") + print(value);
  return "[" + out + "]";
}

std::string event_json(const PayloadEvent& event) {
  JsonObject out;
  out.field("t", event.t)
      .field("action", std::string(event.attach ? "attach" : "detach"))
      .field("slot", std::string(1, event.slot));
  if (!event.attach) return out.end();
  const Eigen::Matrix3d& I = event.body.inertia;
  out.field("m", event.body.mass).field("r", event.body.com);
  out.field("inertia", std::array<double, 6>{I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)});
  if (event.ramp > 0) out.field("ramp", event.ramp);
  return out.end();
}

std::string push_json(const PushEvent& push) {
  return JsonObject().field("t0", push.t).field("dur", push.duration).field("F", push.force).end();
}

std::string gains_json(const PoseImpedanceConfig& gains) {
  return JsonObject()
      .field("k", gains.rate)
      .field("lambda1", gains.lambda1)
      .field("lambda2", gains.lambda2)
      .field("Kr", gains.rotation_stiffness)
      .field("Dr", gains.rotation_damping)
      .end();
}

std::string noise_json(const SyntheticArmConfig<7>& config) {
  return JsonObject()
      .field("tau_sigma", config.torque_noise)
      .field("tau_bias", config.torque_offset)
      .field("coulomb", config.friction.coulomb)
      .field("viscous", config.friction.viscous)
      .field("mass_error", config.mass_error)
      .field("com_error", config.com_error)
      .field("dq_sigma", config.dq_noise)
      .raw("noisy_observer", config.noisy_observer ? "true" : "false")
      .field("torque_step", config.torque_step)
      .field("torque_delay", config.torque_delay)
      .field("loss", config.loss)
      .end();
}

std::string entry_json(const ManifestEntry& entry) {
  const Plan& plan = entry.plan;
  const PayloadEvent& first = plan.events.front();
  return JsonObject()
      .field("name", entry.name)
      .field("scenario", std::string(1, plan.scenario))
      .field("file", entry.file)
      .field("seed", static_cast<double>(entry.seed))
      .field("T", plan.duration)
      .field("q0", plan.q0)
      .field("attach_time", first.t)
      .field("m", first.body.mass)
      .field("r", first.body.com)
      .raw("events", array(plan.events, event_json))
      .raw("pushes", array(plan.pushes, push_json))
      .raw("gains", gains_json(plan.gains))
      .field("xstar_offset", plan.offset)
      .raw("noise", noise_json(entry.config))
      .field("observer_gain", entry.config.observer_gain[0])
      .end();
}

}  // namespace

Recording record(const Plan& plan, const SyntheticArmConfig<7>& config) {
  return Recorder(plan, config).run();
}

void write_log(const std::string& path, const Recording& recording) {
  struct Close {
    void operator()(gzFile file) const { gzclose(file); }
  };
  const std::string text = csv(recording);
  const bool compressed = path.size() > 3 && path.substr(path.size() - 3) == ".gz";
  std::unique_ptr<gzFile_s, Close> file(gzopen(path.c_str(), compressed ? "wb3" : "wbT"));
  if (!file || gzwrite(file.get(), text.data(), static_cast<unsigned>(text.size())) != static_cast<int>(text.size()) ||
      gzclose(file.release()) != Z_OK)
    throw std::runtime_error("cannot write " + path);
}

std::string manifest(const std::string& kind, const std::string& physics, const std::vector<ManifestEntry>& entries) {
  std::string runs;
  for (const ManifestEntry& entry : entries) runs += (runs.empty() ? "\n  " : ",\n  ") + entry_json(entry);
  return JsonObject()
             .field("convention", std::string("M ddq + C dq + G = tau_c + tau_ext; static payload: tau_ext = J^T [m g; "
                                              "(R r) x m g], g=(0,0,-9.81)"))
             .field("units", std::string("SI; r in the flange frame; push in world axes at the flange point"))
             .field("kind", kind)
             .field("physics", physics)
             .field("rate_hz", 1000)
             .raw("runs", "[" + runs + "\n]")
             .end() +
         "\n";
}

}  // namespace rme::examples
