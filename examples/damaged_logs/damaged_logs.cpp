// damaged_logs: how many ways in which a log can be wrong are found and named?
//
// Takes good logs of measured torque with an empty hand, and the options of check_arm that describe the arm. Each log is
// damaged in some forty ways: units, signs, orders, gains, gravity, loads, delays, limits. Prints what the diagnosis
// that check_arm runs says of each. Exit codes: 0; 1 if a good log is refused, a damaged one is called right, or more
// than --missed are not named with the option that mends them; 2 unusable arguments; 3 unreadable log or URDF.
#include <cstdio>
#include <string>
#include <vector>

#include "damaged_logs/damage.hpp"
#include "io/program.hpp"

namespace {

using namespace rme::examples;

constexpr const char* kUsage =
    "usage: damaged_logs LOG.csv[.gz]... [options]\n"
    "  --missed N          how many damages of a log may go without their name (2)\n";

template <int Dofs>
int run(Arguments& arguments, const ArmRequest& request) {
  const LogFormat format = parse_format(arguments);
  const std::size_t may_miss = arguments.whole("--missed", 0).value_or(2);
  std::vector<std::string> files;
  do files.push_back(arguments.positional("LOG.csv"));
  while (!arguments.empty());
  bool good = true;
  for (const std::string& file : files) {
    Recording<Dofs> recording;
    recording.arm = recorded_arm<Dofs>(request, false, recording.config);
    recording.read = read_formatted_log<Dofs>(file, format, joint_names(request));
    const auto said = [&](const Recording<Dofs>& r) { return diagnose(r.read, r.arm, r.config, format, false); };
    const Diagnosis as_it_is = said(recording);
    std::printf("%s: %s\n", file.c_str(), as_it_is.sentence().c_str());
    good = good && as_it_is.usable();
    std::size_t named = 0, called_right = 0, count = 0;
    for (const Damage<Dofs>& damage : damages(recording)) {
      Recording<Dofs> damaged = recording;
      damage.apply(damaged);
      const Diagnosis diagnosis = said(damaged);
      bool right = false;
      for (const Finding& finding : diagnosis.findings)
        right = right || (damage.faults.count(finding.fault) > 0 &&
                          (finding.sentence + finding.option).find(damage.option) != std::string::npos);
      ++count;
      named += right ? 1 : 0;
      called_right += diagnosis.usable() ? 1 : 0;
      std::printf("  %-45s %-6s %s\n", damage.name.c_str(), right ? "named" : "MISSED", diagnosis.sentence().c_str());
    }
    std::printf("  %zu of %zu named, %zu called right\n", named, count, called_right);
    good = good && called_right == 0 && count - named <= may_miss;
  }
  return good ? 0 : 1;
}

int run(Arguments& arguments) {
  const ArmRequest request = parse_arm(arguments);
  return with_joint_count(request.dofs(), [&](auto dofs) { return run<dofs()>(arguments, request); });
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("damaged_logs", std::string(kUsage) + kArmUsage + kFormatUsage, argc, argv, run);
}
