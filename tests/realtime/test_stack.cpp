#include <pthread.h>

#include <functional>
#include <memory>
#include <rme/estimator.hpp>
#include <rme/host/payload_compensation.hpp>
#include <vector>

#include "support/catch.hpp"
#include "support/held_arm.hpp"

namespace {

using namespace rme;
using testing::HeldArm;

/// Runs `work` in a thread with a stack of so many bytes; beyond it, the program ends with a segmentation fault.
void run_on_stack(std::size_t bytes, std::function<void()> work) {
  pthread_attr_t attributes;
  REQUIRE(pthread_attr_init(&attributes) == 0);
  REQUIRE(pthread_attr_setstacksize(&attributes, bytes) == 0);
  pthread_t thread;
  const auto call = [](void* f) -> void* {
    (*static_cast<std::function<void()>*>(f))();
    return nullptr;
  };
  REQUIRE(pthread_create(&thread, &attributes, call, &work) == 0);
  REQUIRE(pthread_join(thread, nullptr) == 0);
  pthread_attr_destroy(&attributes);
}

TEST_CASE("Estimator: every call of the loop, reset() included, runs on a stack of 64 KiB", "[realtime]") {
  HeldArm arm(86);
  std::vector<Proprioception<double, 7>> samples;
  for (int tick = 0; tick < 3000; ++tick) {
    if (tick == 1000) arm.hold({1, {0, 0, 0.1}});
    if (tick == 1500) arm.move(arm.pose() + 0.3 * HeldArm::Vector::Ones(), 1);
    samples.push_back(arm.tick());
  }
  const auto estimator = std::make_unique<Estimator<double, 7>>(HeldArm::kPeriod);
  HeldArm::Vector torque = HeldArm::Vector::Zero();
  double held = 0;
  run_on_stack(64 * 1024, [&] {
    for (int life = 0; life < 2; ++life) {
      for (const auto& sample : samples) {
        if (estimator->update(sample) == Status::Ok) torque = estimator->compensation(sample.jacobian, sample.rotation);
      }
      held = estimator->state().payload.mean[0];
      estimator->declare_empty();
      estimator->expect_change();
      (void)estimator->set_payload({{1, 0, 0, 0.1}, Matrix4<double>::Identity() * 1e-4});
      estimator->in_contact(true);
      estimator->in_contact(false);
      estimator->reset();
    }
  });
  CHECK(std::abs(held - 1) < 0.02);
  CHECK(torque.norm() > 1);
  CHECK(estimator->state().time == 0);
}

TEST_CASE("PayloadCompensation: may be constructed and used on a control thread's stack of 64 KiB", "[realtime]") {
  HeldArm arm(87);
  std::vector<Proprioception<double, 7>> samples;
  for (int tick = 0; tick < 2000; ++tick) {
    if (tick == 1000) arm.hold({1, {0, 0, 0.1}});
    samples.push_back(arm.tick());
  }
  double held = 0;
  run_on_stack(64 * 1024, [&] {
    PayloadCompensation<double, 7> payload(HeldArm::kPeriod);
    for (const auto& sample : samples) (void)payload.update(sample);
    held = payload.state().payload.mean[0];
    payload.handed_over(payload.hand_over().body);
    payload.reset();
  });
  CHECK(std::abs(held - 1) < 0.02);
}

}  // namespace
