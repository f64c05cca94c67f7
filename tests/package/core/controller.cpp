// A kilogram at the end-effector origin weighs 9.81 N: the package compiles, links and runs.
#include <rme/rme.hpp>

int main() {
  const rme::Wrench<double> w = rme::payload_wrench<double>({1.0, {0.0, 0.0, 0.0}}, rme::Matrix3<double>::Identity());
  return w.force.z() == -9.81 ? 0 : 1;
}
