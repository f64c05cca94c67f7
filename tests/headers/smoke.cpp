// The core without exceptions and run-time types, in float and double. Ends with 0 if it still computes what it should.
#include <cmath>
#include <rme/rme.hpp>

namespace {

template <typename Scalar>
bool kilogram_weighs_9_81_newton() {
  const rme::Payload<Scalar> payload{Scalar(1), {Scalar(0.1), Scalar(0), Scalar(0)}};
  const rme::Wrench<Scalar> w = rme::payload_wrench<Scalar>(payload, rme::Matrix3<Scalar>::Identity());
  return w.force.z() == Scalar(-9.81) && std::abs(w.moment.y() - Scalar(0.981)) < Scalar(1e-6);
}

template <typename Scalar>
bool ring_keeps_the_newest() {
  rme::RingBuffer<Scalar> ring(2);
  for (int k = 0; k < 3; ++k) ring.push(Scalar(k));
  return ring[0] == Scalar(1) && ring[1] == Scalar(2);
}

template <typename Scalar>
bool all() {
  return kilogram_weighs_9_81_newton<Scalar>() && ring_keeps_the_newest<Scalar>();
}

}  // namespace

int main() {
  return all<float>() && all<double>() ? 0 : 1;
}
