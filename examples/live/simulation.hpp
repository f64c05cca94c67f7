#pragma once
/// What the live page shows: two arms with the same objects, faults and pushes, one of which is compensated by rme.
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "live/live_arm.hpp"

namespace rme::examples {

/// Numbers with names, for whoever draws or compares them.
struct Snapshot {
  struct Field {
    std::string name;
    std::size_t offset, count;  ///< in `values`
  };
  std::vector<Field> fields;
  std::vector<double> values;
};

class Simulation {
 public:
  explicit Simulation(std::uint64_t seed);

  /// Carries out a command at the present tick:
  ///
  ///     attach M X Y Z    a body of M kg, its centre at X Y Z [m, flange axes]
  ///     pour RATE         fills a cup in the hand by RATE [kg/s]; 0 ends it
  ///     hang M L          a swinging bag of M kg on a string of L m
  ///     push X Y Z        pushes at the hand [N, world axes]; 0 0 0 lets go
  ///     drop              everything; it ends pouring
  ///     pose N            moves to a pose, 0 to 3
  ///     wall 0|1          the arm that rme compensates is also constrained by CPIC, to a wall and its joint limits
  ///     friction, noise, tilt, tool, late 0|1    a fault (Faults)
  ///
  /// @return false if there is no such command, or the hand would hold more than 3 kg or two bags; nothing happens then
  bool command(const std::string& line);
  /// Advances both arms by LiveArm::kPeriod.
  void step();
  /// Carries out a session, lines of "TICK COMMAND", up to the tick `end`.
  /// @throws std::invalid_argument with the line that is none, or is refused
  void run(const std::string& session, long end);

  long ticks() const noexcept { return ticks_; }
  Snapshot snapshot() const;

 private:
  static constexpr std::array<std::pair<const char*, bool Faults::*>, 5> kFaults = {{{"friction", &Faults::friction},
                                                                                     {"noise", &Faults::noise},
                                                                                     {"tilt", &Faults::tilted},
                                                                                     {"tool", &Faults::wrong_tool},
                                                                                     {"late", &Faults::late}}};
  template <typename Act>
  void on_both(Act&& act) {
    act(without_);
    act(with_);
  }
  PoseTarget target() const;

  LiveArm without_, with_;
  Faults faults_;
  bool wall_ = false;
  Eigen::Vector3d push_ = Eigen::Vector3d::Zero();
  double pour_rate_ = 0, poured_ = 0;  // [kg/s, kg]
  PoseTarget from_, to_;
  long ticks_ = 0, moved_at_ = 0;
};

}  // namespace rme::examples
