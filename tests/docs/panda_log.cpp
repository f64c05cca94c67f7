// panda_log FILE.csv: writes what a swinging Panda reports that has joint torque alone, 500 times a second. It holds a
// kilogram from 2 s to 6 s, of 8; rows get lost now and then.
#include <cmath>
#include <cstdio>
#include <fstream>
#include <synthetic_arm/panda.hpp>

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: panda_log FILE.csv\n");
    return 2;
  }
  using Vector = rme::JointVector<double, 7>;
  const auto& arm = rme::examples::panda();
  const auto kilogram = rme::examples::box(1, {0.03, -0.02, 0.16}, {0.08, 0.06, 0.1});
  std::ofstream file(argv[1]);
  file.precision(12);
  file << 't';
  for (const char* name : {"q", "dq", "tau"})
    for (int j = 1; j <= 7; ++j) file << ',' << name << j;
  for (int k = 0; k < 4000; ++k) {
    if (k % 50 == 7) continue;
    const double t = 0.002 * k;
    Vector q, dq, ddq;
    for (int j = 0; j < 7; ++j) {
      const double w = 1.2 + 0.17 * j;
      q[j] = arm.ready[j] + 0.3 * (1 - std::cos(w * t));
      dq[j] = 0.3 * w * std::sin(w * t);
      ddq[j] = 0.3 * w * w * std::cos(w * t);
    }
    const bool held = t >= 2 && t < 6;
    const auto terms = arm.dynamics(q, dq, held ? kilogram : rme::examples::RigidBody());
    const Vector tau = terms.mass_matrix * ddq + terms.coriolis + terms.gravity;
    file << '\n' << t;
    for (const Vector& v : {q, dq, tau})
      for (int j = 0; j < 7; ++j) file << ',' << v[j];
  }
  file << '\n';
  return static_cast<bool>(file.flush()) ? 0 : 3;
}
