#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <random>
#include <rme/tracking/histories.hpp>
#include <utility>
#include <vector>

#include "enumerated_stories.hpp"
#include "support/catch.hpp"
#include "support/linear_algebra.hpp"

namespace {

using rme::Disturbing;
using rme::Mode;
using rme::Sensing;
using rme::testing::EnumeratedStories;
constexpr double kRated = 3;
const Eigen::Vector3d kGravity(0, 0, -9.81);

template <int Dofs, int Capacity>
rme::Histories<double, Dofs, Capacity> fresh(const rme::SensingKind& kind) {
  return {kind, rme::ArmPrior<double, Dofs>::of(kRated), rme::PayloadPrior<double>::of(kRated), kRated, kGravity};
}

/// What may happen to the hand of an arm that rests in a random pose.
enum class Happens { Nothing, Attach, Push, Removal };

/// Blocks drawn from the model: offsets and noise as the prior has them, and from block `when` on what happens.
template <int Dofs>
class RandomBlocks {
 public:
  RandomBlocks(unsigned seed, Happens happens, int when) : random_(seed), happens_(happens), when_(when) {
    for (int j = 0; j < Dofs; ++j) {
      const Eigen::Vector3d axis = gaussian().normalized(), lever = 0.4 * gaussian();
      jacobian_.col(j) << axis.cross(lever), axis;
      offset_[j] = arm_.offset[j] * normal_(random_);
    }
    rotation_ = Eigen::Quaterniond(normal_(random_), normal_(random_), normal_(random_), normal_(random_))
                    .normalized()
                    .toRotationMatrix();
    mass_ = std::uniform_real_distribution<double>(0.2, 2)(random_);
    com_ = prior_.com_mean + prior_.com_std.cwiseProduct(gaussian());
    wrench_ << 4 * kRated * gaussian(), 0.5 * kRated * gaussian();
  }

  rme::TorqueBlock<double, Dofs> next() {
    auto block = rme::testing::block_at_rest<double, Dofs>(jacobian_, rotation_, offset_);
    for (int j = 0; j < Dofs; ++j) block.tau[j] += arm_.noise[j] * normal_(random_);
    const bool now = k_++ >= when_;
    if (happens_ == (now ? Happens::Attach : Happens::Removal)) {
      rme::Vector4<double> phi;
      phi << mass_, mass_ * com_;
      block.tau += block.regressor.template leftCols<4>() * phi;
    }
    if (now && happens_ == Happens::Push) {
      block.tau += jacobian_.transpose() * wrench_;
      wrench_.head<3>() += 0.4 * kRated * gaussian();
      wrench_.tail<3>() += 0.05 * kRated * gaussian();
    }
    return block;
  }

 private:
  Eigen::Vector3d gaussian() { return {normal_(random_), normal_(random_), normal_(random_)}; }

  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  Happens happens_;
  int when_, k_ = 0;
  rme::ArmPrior<double, Dofs> arm_ = rme::ArmPrior<double, Dofs>::of(kRated);
  rme::PayloadPrior<double> prior_ = rme::PayloadPrior<double>::of(kRated);
  Eigen::Matrix<double, 6, Dofs> jacobian_;
  Eigen::Matrix3d rotation_;
  rme::JointVector<double, Dofs> offset_;
  double mass_;
  Eigen::Vector3d com_;
  rme::Vector6<double> wrench_;
};

/// Runs `blocks` of both, `alone` as in EnumeratedStories; `see(histories, enumerated)` after each block.
template <int Dofs, int Capacity, typename See>
void run_both(const rme::SensingKind& kind, RandomBlocks<Dofs> random, int blocks, bool alone, const See& see) {
  const auto histories = std::make_unique<rme::Histories<double, Dofs, Capacity>>(fresh<Dofs, Capacity>(kind));
  const auto children = std::make_unique<rme::StoryChildren<double, Dofs, Capacity>>();
  EnumeratedStories<Dofs> enumerated(fresh<Dofs, 7>(kind), rme::PayloadPrior<double>::of(kRated), kRated, alone);
  rme::FrictionRegime<double, Dofs> regime;
  for (int k = 0; k < blocks; ++k) {
    const auto block = random.next();
    regime.update(block);
    histories->begin(block, regime, {}, *children);
    enumerated.advance(histories->model());
    while (!histories->advance(*children)) {
    }
    see(*histories, enumerated);
  }
}

using Key = std::array<int, 3>;  // mode, payload, kind of disturbance, pour or hold
using Weights = std::map<Key, double>;
template <int Dofs>
Key key(const rme::Story<double, Dofs>& s, bool how) {
  const int kind = s.mode == Mode::Disturbed                                 ? static_cast<int>(s.how)
                   : (s.mode == Mode::Pouring && s.quick) || s.star.swings() ? 1
                                                                             : 0;
  return {static_cast<int>(s.mode), s.payload, how ? kind + 10 * s.tilted + 20 * s.star.gains_off() : 0};
}
template <typename Histories, typename Enumerated>
std::pair<Weights, Weights> weights(const Histories& histories, const Enumerated& enumerated, bool how) {
  std::pair<Weights, Weights> out;
  for (int i = 0; i < histories.count(); ++i) {
    const auto& s = histories.story(i);
    out.first[key(s, how)] += histories.weight(i);
  }
  for (const auto& s : enumerated.stories) out.second[key(s, how)] += std::exp(s.log_weight);
  return out;
}

TEST_CASE("Histories: where nothing is pruned, the weights are those of all stories, enumerated by brute force",
          "[histories]") {
  for (const Sensing sensing : {Sensing::LinkSide, Sensing::JointFriction, Sensing::RoughModel}) {
    rme::SensingKind kind = rme::kind_of(sensing);
    kind.depth = 1e9;  // no story is given up
    kind.quiet = 0;    // no block is explained so well that children are left out
    kind.jolt = 0;     // no jolt is taken to shake all stories alike
    for (const Happens happens : {Happens::Nothing, Happens::Attach, Happens::Push, Happens::Removal}) {
      for (unsigned seed = 580; seed < 583; ++seed) {
        CAPTURE(static_cast<int>(sensing), static_cast<int>(happens), seed);
        int blocks = 0;
        run_both<2, 120>(kind, RandomBlocks<2>(seed, happens, 3), 8, true,
                         [&](const auto& histories, const auto& enumerated) {
                           CAPTURE(++blocks);
                           CHECK(histories.count() == static_cast<int>(enumerated.stories.size()));
                           const auto [ours, theirs] = weights(histories, enumerated, true);
                           CHECK(ours.size() == theirs.size());
                           for (const auto& [what, weight] : theirs)
                             CHECK(std::abs(ours.count(what) ? ours.at(what) - weight : 1) < 1e-9);
                           double worst = 0;  // the filters of the heaviest stories, too
                           for (const auto& s : enumerated.stories)
                             for (int i = 0; i < histories.count(); ++i) {
                               const auto& other = histories.story(i);
                               if (histories.weight(i) < 1e-6 || !other.same(s)) continue;
                               worst = std::max(worst, (other.star.mean() - s.star.mean()).norm());
                             }
                           CHECK(worst < 1e-9);
                         });
        REQUIRE(blocks == 8);
      }
    }
  }
}

/// Total variation between the weights over (mode, payload) of pruned and of enumerated stories: the largest of a run,
/// and that after its last block.
struct Variation {
  double largest = 0, last = 0;
};
template <int Capacity>
Variation variation(const rme::SensingKind& kind, unsigned seed, Happens happens, int when, int blocks) {
  Variation out;
  run_both<7, Capacity>(kind, RandomBlocks<7>(seed, happens, when), blocks, false,
                        [&](const auto& histories, const auto& enumerated) {
                          auto [ours, theirs] = weights(histories, enumerated, false);
                          double sum = 0;
                          for (const auto& [what, weight] : theirs) sum += std::abs(ours[what] - weight);
                          for (const auto& [what, weight] : ours) sum += theirs.count(what) > 0 ? 0 : weight;
                          out.last = 0.5 * sum;
                          out.largest = std::max(out.largest, out.last);
                        });
  return out;
}

/// As numbers of runs above a thousandth: at worst, and after the last block.
template <typename Report>
void vary(Sensing sensing, Happens happens, int runs, const Report& report) {
  std::vector<double> largest, last;
  for (int k = 1; k <= runs; ++k) {
    const Variation v = variation<7>(rme::kind_of(sensing), static_cast<unsigned>(k), happens, 5, 12);
    largest.push_back(v.largest);
    last.push_back(v.last);
  }
  std::sort(largest.begin(), largest.end());
  std::sort(last.begin(), last.end());
  report(largest, last);
}

TEST_CASE("Histories: stories that are given up or not computed hardly change the weights", "[histories]") {
  // Seeds 1 to 36 of each. A payload is found one block later where the change would have to begin before it showed.
  for (const Sensing sensing : {Sensing::LinkSide, Sensing::JointFriction, Sensing::RoughModel})
    for (const Happens happens : {Happens::Nothing, Happens::Attach, Happens::Push, Happens::Removal})
      vary(sensing, happens, 36, [&](const auto& largest, const auto& last) {
        CAPTURE(static_cast<int>(sensing), static_cast<int>(happens), largest, last);
        if (happens != Happens::Attach) {
          // Where friction hides a slow take-up, the pours that are given up while nothing happens weigh more.
          const double most = sensing == Sensing::JointFriction ? 1e-2 : 1e-3;
          CHECK(largest.back() < most);
        } else if (sensing != Sensing::RoughModel) {
          CHECK(last[18] < 1e-3);
          CHECK(last[28] < 0.01);
        }
      });
}

TEST_CASE("Histories: total variation to all stories, in numbers", "[.][measure]") {
  for (const Sensing sensing : {Sensing::LinkSide, Sensing::JointFriction, Sensing::RoughModel})
    for (const Happens happens : {Happens::Nothing, Happens::Attach, Happens::Push, Happens::Removal})
      vary(sensing, happens, 250, [&](const auto& largest, const auto& last) {
        std::printf("sensing %d, happens %d:", static_cast<int>(sensing), static_cast<int>(happens));
        for (const auto* v : {&largest, &last})
          std::printf("  median %.2g, 90 %% %.2g, 99 %% %.2g, largest %.2g, above 0.001 %.1f %%;", (*v)[125], (*v)[225],
                      (*v)[247], (*v)[249],
                      0.4 * static_cast<double>(v->end() - std::upper_bound(v->begin(), v->end(), 1e-3)));
        std::printf("\n");
      });
}

}  // namespace
