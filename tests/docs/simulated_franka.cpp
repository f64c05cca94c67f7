// Linked into libfranka_payload in place of libfranka: the robot at the address "simulated", and a user at the
// keyboard. It is handed a kilogram after a second, and asked after another two to take it over; then the kilogram is
// dropped. At last the compensation is switched off and on again.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "host/franka_arm.hpp"

namespace {

struct Scene : rme::testing::FrankaArm {
  Scene() {
    int ends[2];
    if (pipe(ends) != 0 || dup2(ends[0], STDIN_FILENO) < 0) std::abort();
    keyboard = ends[1];
    type("\n");
    franka::Robot::Simulation all = simulation();
    all.command = [this](const franka::Torques& torques) {
      command(torques);
      play();
    };
    franka::Robot::simulations()["simulated"] = all;
  }

  void type(const char* line) const {
    if (write(keyboard, line, std::strlen(line)) < 0) std::abort();
  }
  void play() {
    if (ticks == 1000) payload = arm.attach(rme::testing::unknown_kilogram());
    if (ticks == 3000) type("load\n");
    if (loads_set > seen) {  // another loop than the one that asked for it
      seen = loads_set;
      since = ticks;
    }
    if (seen == 1 && ticks == since + 1000) arm.detach(payload);
    if (seen == 2 && ticks == since + 500) type("off\n");
    if (seen == 2 && ticks == since + 1500) type("on\n");
    if (seen == 2 && ticks == since + 2500) type("quit\n");
  }

  int keyboard = -1, payload = 0, seen = 0, since = 0;
};

const Scene scene;

}  // namespace
