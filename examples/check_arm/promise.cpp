#include "check_arm/promise.hpp"

#include <limits>

namespace rme::examples {

Promise promise_of(const HeldOutTest& test, double rated) {
  constexpr double kNinety = 1.6448536269514722;  // half width of a Gaussian's 90 % interval
  constexpr double kFound = 0.95;
  Promise out;
  double held = 0, asked = 0;
  for (std::size_t after = 0; after < kAfter.size(); ++after) {
    std::array<double, kShares.size()> found{}, count{};
    for (const bool moving : {false, true}) {
      PromiseRow row{after, moving, 0, 0, 0, 0, 0};
      std::vector<double> errors;
      for (const Trial& trial : test.trials) {
        if (trial.answers.size() <= after) continue;
        const TrialAnswer& answer = trial.answers[after];
        if (answer.moving != moving) continue;
        ++count[trial.share];
        found[trial.share] += answer.found ? 1 : 0;
        if (trial.share < kWeighed) continue;
        const bool holds = std::abs(answer.error) <= kNinety * answer.deviation;
        ++row.answers;
        row.error += std::abs(answer.error);
        row.coverage += holds ? 1 : 0;
        row.centre += answer.centre;
        errors.push_back(std::abs(answer.error));
        if (kAfter[after] < 1) continue;
        ++asked;
        held += holds ? 1 : 0;
      }
      if (row.answers == 0) continue;
      row.error /= row.answers;
      row.coverage /= row.answers;
      row.centre /= row.answers;
      std::sort(errors.begin(), errors.end());
      row.worst = errors[errors.size() * 19 / 20];
      out.rows.push_back(row);
    }
    out.lightest[after] = std::numeric_limits<double>::infinity();
    for (std::size_t share = kShares.size(); share-- > 0 && found[share] >= kFound * std::max(1.0, count[share]);)
      out.lightest[after] = kShares[share] * rated;
  }
  if (asked > 0) out.coverage = held / asked;
  return out;
}

}  // namespace rme::examples
