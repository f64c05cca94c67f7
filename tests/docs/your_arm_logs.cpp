// Writes the recordings that docs/your_arm.md speaks of, of the arm in six_joints_5kg.urdf: empty.csv, half a minute of
// it swinging with an empty hand, and lifted.csv, in which it holds 2 kg from 4 s to 10 s. Joint torque at 500 Hz, with
// noise, offsets and friction.
#include <cstdio>
#include <fstream>
#include <random>
#include <string>
#include <urdf_arm/urdf_chain.hpp>

using namespace rme::examples;
using Vector = rme::JointVector<double, 6>;

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: your_arm_logs ARM.urdf FOLDER\n");
    return 2;
  }
  const ArmModel<6> arm = arm_model<6>(read_urdf(argv[1], "base_link", "tool0"));
  const RigidBody payload = box(2, {0.04, -0.03, 0.09}, {0.1, 0.1, 0.1});
  const Vector coulomb(0.6, 0.7, 0.5, 0.2, 0.2, 0.15), offset(0.1, -0.2, 0.15, 0.05, -0.03, 0.02);
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  const auto record = [&](const std::string& name, double seconds, double from, double to) {
    std::ofstream file(std::string(argv[2]) + "/" + name);
    file.precision(9);
    file << "t,q1,q2,q3,q4,q5,q6,dq1,dq2,dq3,dq4,dq5,dq6,tau1,tau2,tau3,tau4,tau5,tau6";
    for (int k = 0; k < static_cast<int>(500 * seconds); ++k) {
      const double t = 0.002 * k;
      Vector q, dq, ddq;
      for (int j = 0; j < 6; ++j) {
        const double w = 1.2 + 0.17 * j, start = j == 1 ? -1.1 : j == 2 ? 1.3 : 0.6;
        q[j] = start + 0.35 * (1 - std::cos(w * t));
        dq[j] = 0.35 * w * std::sin(w * t);
        ddq[j] = 0.35 * w * w * std::cos(w * t);
      }
      const auto terms = arm.dynamics(q, dq, t >= from && t < to ? payload : RigidBody{});
      Vector tau = terms.mass_matrix * ddq + terms.coriolis + terms.gravity + offset;
      for (int j = 0; j < 6; ++j) {
        tau[j] += (dq[j] > 0 ? 1 : -1) * coulomb[j] + 0.3 * dq[j] + 0.1 * normal(random);
        dq[j] += 1e-4 * normal(random);
      }
      file << '\n' << t;
      for (const Vector& v : {q, dq, tau})
        for (int j = 0; j < 6; ++j) file << ',' << v[j];
    }
    file << '\n';
    return static_cast<bool>(file.flush());
  };
  return record("empty.csv", 30, 1e9, 1e9) && record("lifted.csv", 12, 4, 10) ? 0 : 3;
}
