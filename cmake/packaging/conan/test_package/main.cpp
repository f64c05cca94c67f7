// A payload of 1 kg at the flange weighs 9.81 N.
#include <cmath>
#include <rme/core/payload.hpp>

int main() {
  const auto wrench = rme::payload_wrench<double>({1.0, {0, 0, 0}}, rme::Matrix3<double>::Identity());
  return std::abs(wrench.force.z() + 9.81) < 1e-12 ? 0 : 1;
}
