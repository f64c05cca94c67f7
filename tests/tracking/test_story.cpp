#include <random>
#include <rme/tracking/story.hpp>

#include "support/catch.hpp"
#include "tracking/random_star.hpp"

namespace {

using namespace rme::testing;
using Story = rme::Story<double, kJoints>;

TEST_CASE("Story: settled, nothing pours or swings any more, and the tool is what it was", "[story]") {
  const unsigned seed = 517;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (const bool swings : {false, true}) {
    CAPTURE(swings);
    Story story;
    story.star = random_star(random);
    const double poured = story.star.poured_mass(), mass = story.star.mass();
    CHECK(poured != 0);
    if (swings) {
      rme::Pour<double, kJoints>().end(story.star);
      story.swing.begin(story.star, 5, true, rme::Vector4<double>::Ones());
      for (int k = 0; k < 9; ++k)
        story.star.observe(k % kJoints, story.star.predict(k % kJoints, random_observation(random)));
    }
    const rme::Vector4<double> tool = story.tool_mean(), in_place = story.star.mean().segment<4>(kTool);
    CHECK((tool == in_place) == !swings);  // in its place is what a hand carries
    const double before = story.star.mass();
    story.settle();
    CHECK(story.star.last() == Star::Last::Nothing);
    CHECK(story.star.poured_mass() == 0);
    CHECK(story.star.mass() == Approx(before));
    CHECK(story.tool_mean() == rme::Vector4<double>(story.star.mean().segment<4>(kTool)));
    CHECK((story.tool_mean() - tool).norm() < 1e-12);
    if (!swings) CHECK(before == mass);
  }
}

TEST_CASE("Story: an arm whose gains may be off is another arm", "[story]") {
  Story exact, off;
  CHECK(exact.same(off));
  off.star.widen_nuisance(rme::kGain, 1e-4);
  CHECK(!exact.same(off));
  exact.star.widen_nuisance(rme::kGain, 1e-6);  // known better, but not exactly
  CHECK(exact.same(off));
}

}  // namespace
