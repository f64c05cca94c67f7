// rme_solver_precision: is the controller's quadratic program solved in float wherever double solves it, and does Ok
// mean that the rows hold?
//
// Random problems of 2, 6 and 7 variables with P of condition up to 1e6, soft, repeated and nearly parallel rows (1e-4
// apart); a simulated Panda's random walk with joint limits, with and without seven random rows; and random arms, near
// singular poses too, at the corners of the settings that Cpic accepts. Float is given the problem rounded to float,
// double that same rounded problem. Exit code 0 if float solved all that double did and no Ok came with a missed row.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <synthetic_arm/panda.hpp>

#include "io/program.hpp"
#include "random_arm.hpp"
#include "solvers.hpp"

namespace {

using rme::Status;
using rme::examples::panda;

constexpr const char* kUsage =
    R"(usage: rme_solver_precision [options]

Solves random problems in float and in double and prints what float did with those that double solves.

  --count N         random problems of each size (default 340000: a million in all)
  --seed N          (default 1)
  --help            this text

Exit codes: 0 nothing that double solves was refused or missed; 1 something was; 2 unusable arguments.
)";

template <int Size>
using VectorD = Eigen::Matrix<double, Size, 1>;
template <int Size>
using MatrixD = Eigen::Matrix<double, Size, Size>;

/// What came of many problems.
struct Tally {
  long solved = 0;         // by double
  long infeasible = 0;     // of those, called Infeasible in float
  long not_converged = 0;  // of those, in float
  long missed = 0;         // said Ok with a row missed by more than `allowed`
  double worst = 0;        // of what Ok came with, relative
  int iterations = 0;      // most

  void enter(Status reference, Status status, double miss, double allowed, int steps) {
    if (status == Status::Ok) {
      worst = std::max(worst, miss);
      missed += miss > allowed ? 1 : 0;
    }
    iterations = std::max(iterations, steps);
    if (reference != Status::Ok) return;
    ++solved;
    infeasible += status == Status::Infeasible ? 1 : 0;
    not_converged += status == Status::Ok || status == Status::Infeasible ? 0 : 1;
  }
  bool print(const char* what) const {
    std::printf("| %-58s | %8ld | %10ld | %9ld | %6ld | %9.1e | %10d |\n", what, solved, infeasible, not_converged,
                missed, worst, iterations);
    std::fflush(stdout);
    return infeasible == 0 && not_converged == 0 && missed == 0;
  }
};

/// By how much x misses lower <= a x <= upper, less the slack, relative to the terms of the row.
double relative_miss(double value, double lower, double upper, double slack, double terms) {
  const double miss = std::max(lower - value, value - upper) - slack;
  return miss / (terms + std::abs(lower > value ? lower : upper));
}

template <int Size>
VectorD<Size> gaussian(std::mt19937& random) {
  std::normal_distribution<double> normal;
  VectorD<Size> v;
  for (int i = 0; i < Size; ++i) v[i] = normal(random);
  return v;
}

/// A problem as float is given it; the copy for double is exact.
template <int Size>
struct Problem {
  Eigen::Matrix<float, Size, Size> P;
  Eigen::Matrix<float, Size, 1> x_u, x_min, x_max;
  rme::ConstraintRows<float, Size, 28> rows;
  rme::ConstraintRows<double, Size, 28> rows_in_double;

  explicit Problem(std::mt19937& random) {
    std::uniform_real_distribution<double> uniform;
    const oracle::Matrix V = oracle::random_rotation(random, Size);
    VectorD<Size> eigenvalues;  // of P
    const double decades = 6 * uniform(random);
    for (int i = 0; i < Size; ++i) eigenvalues[i] = std::pow(10.0, 3 - decades * uniform(random));
    eigenvalues[0] = 1000;
    eigenvalues[1] = std::pow(10.0, 3 - decades);
    P = oracle::composed(V, eigenvalues, V).template cast<float>();
    P = ((P + P.transpose()) / 2).eval();
    const VectorD<Size> feasible = 5 * gaussian<Size>(random);
    x_u = (feasible + std::pow(10.0, 1.5 * uniform(random)) * gaussian<Size>(random)).template cast<float>();
    x_min = (feasible.array() - 10 * uniform(random)).matrix().template cast<float>();
    x_max = (feasible.array() + 10 * uniform(random)).matrix().template cast<float>();
    const int count = static_cast<int>(random() % 29);
    const bool soft = random() % 3 == 0;
    VectorD<Size> last = VectorD<Size>::Zero();
    for (int i = 0; i < count; ++i) {
      VectorD<Size> a = gaussian<Size>(random);
      if (i > 0 && uniform(random) < 0.1) a = last + 1e-4 * a;
      if (i > 0 && uniform(random) < 0.05) a = last;
      a *= std::pow(10.0, 2 * uniform(random) - 1) / a.norm();
      last = a;
      const double room = uniform(random) < 0.1 ? 0.0 : uniform(random) * a.norm(), side = uniform(random);
      const double lower = a.dot(feasible) - room, upper = lower + 2 * room + uniform(random) * a.norm();
      const auto l = static_cast<float>(side < 0.6 ? lower : -rows.kFree);
      const auto u = static_cast<float>(side > 0.4 ? upper : rows.kFree);
      const auto w =
          static_cast<float>(soft && uniform(random) < 0.5 ? std::pow(10.0, 4 * uniform(random) - 1) : rows.kHard);
      const Eigen::Matrix<float, Size, 1> rounded = a.template cast<float>();
      if (rows.add(rounded, l, u, w) == Status::Ok) (void)rows_in_double.add(rounded.template cast<double>(), l, u, w);
    }
  }
};

template <int Size>
bool random_problems(unsigned seed, long count) {
  std::mt19937 random(seed);
  rme::ActiveSetSolver<double, Size, 28> reference;
  rme::ActiveSetSolver<float, Size, 28> warm, cold;
  Tally warm_tally, cold_tally;
  for (long i = 0; i < count; ++i) {
    const Problem<Size> p(random);
    const Status expected =
        reference.solve(p.P.template cast<double>(), p.x_u.template cast<double>(), p.rows_in_double,
                        p.x_min.template cast<double>(), p.x_max.template cast<double>());
    cold.reset();  // warm starts from the active set of an unrelated problem
    for (auto* solver : {&warm, &cold}) {
      const Status status = solver->solve(p.P, p.x_u, p.rows, p.x_min, p.x_max);
      const VectorD<Size> x = solver->solution().template cast<double>();
      const double reach = x.norm() + p.x_u.template cast<double>().norm();
      double miss = 0;
      for (int k = 0; k < p.rows.size(); ++k) {
        const auto& row = p.rows_in_double[k];
        miss = std::max(miss, relative_miss(row.a.dot(x), row.lower, row.upper, static_cast<double>(solver->slack(k)),
                                            row.a.norm() * reach));
      }
      (solver == &warm ? warm_tally : cold_tally).enter(expected, status, miss, 1e-3, solver->iterations());
    }
  }
  char what[64];
  std::snprintf(what, sizeof what, "float, random, %d variables, warm", Size);
  bool good = warm_tally.print(what);
  std::snprintf(what, sizeof what, "float, random, %d variables, cold", Size);
  return cold_tally.print(what) && good;
}

/// The largest relative miss of the rows that a controller was given, M^-1 formed in double.
template <typename Scalar>
double largest_miss(const rme::Cpic<Scalar, 7>& cpic, const rme::CpicInput<Scalar, 7>& input,
                    const typename rme::Cpic<Scalar, 7>::Rows& rows) {
  const oracle::Matrix inverse_mass = oracle::inverse(input.mass_matrix.template cast<double>());
  const VectorD<7> tau = cpic.torque().template cast<double>();
  const double reach = tau.norm() + cpic.unconstrained_torque().template cast<double>().norm();
  double miss = 0;
  for (int k = 0; k < rows.size(); ++k) {
    const VectorD<7> a = inverse_mass * rows[k].a.template cast<double>();
    const double shift = a.dot(input.bias.template cast<double>());
    miss = std::max(miss, relative_miss(a.dot(tau), static_cast<double>(rows[k].lower) + shift,
                                        static_cast<double>(rows[k].upper) + shift, 0, a.norm() * reach));
  }
  return miss;
}

template <typename Scalar>
rme::CpicInput<Scalar, 7> rounded(const rme::CpicInput<double, 7>& input) {
  return {input.jacobian.cast<Scalar>(),
          input.mass_matrix.cast<Scalar>(),
          input.bias.cast<Scalar>(),
          rme::Wrench<Scalar>::from_vector(rme::Vector6<Scalar>(input.wrench.vector().cast<Scalar>())),
          input.null_torque.cast<Scalar>(),
          input.other_torque.cast<Scalar>()};
}
template <typename Scalar, typename From>
typename rme::Cpic<Scalar, 7>::Rows rounded_rows(const From& rows) {
  typename rme::Cpic<Scalar, 7>::Rows out;
  for (int k = 0; k < rows.size(); ++k) {
    const auto& row = rows[k];
    if (row.axis >= 0) {
      (void)out.add_axis(row.axis, static_cast<Scalar>(row.lower), static_cast<Scalar>(row.upper));
    } else {
      (void)out.add(row.a.template cast<Scalar>(), static_cast<Scalar>(row.lower), static_cast<Scalar>(row.upper));
    }
  }
  return out;
}

/// 200 walks of 200 ticks: the arm moves in a straight line, the task force drifts, a torque that keeps the rows
/// exists.
/// @param cold  float forgets the active set between two ticks
bool panda_walk(unsigned seed, int general, bool cold, const char* what) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform;
  const auto& model = panda();
  rme::CpicConfig<double, 7> config;
  config.torque_limit = model.tau_max;
  rme::CpicConfig<float, 7> small;
  small.torque_limit = model.tau_max.cast<float>();
  Tally tally;
  for (int path = 0; path < 200; ++path) {
    rme::Cpic<double, 7> reference(config);
    rme::Cpic<float, 7> cpic(small);
    VectorD<7> q, feasible;
    const VectorD<7> dq = 0.5 * gaussian<7>(random);
    for (int j = 0; j < 7; ++j) {
      q[j] = model.q_min[j] + (0.15 + 0.7 * uniform(random)) * (model.q_max[j] - model.q_min[j]);
      feasible[j] = (uniform(random) - 0.5) * model.tau_max[j];
    }
    const double tightness = std::pow(10.0, 4 * uniform(random) - 2);
    const VectorD<7> null_error = tightness * gaussian<7>(random), drift = 20 * gaussian<7>(random);
    const VectorD<6> error = tightness * gaussian<6>(random), rate = 5 * tightness * gaussian<6>(random);
    const VectorD<7> room = 20 * gaussian<7>(random).cwiseAbs();
    MatrixD<7> gradients;
    for (int k = 0; k < 7; ++k) gradients.col(k) = gaussian<7>(random).normalized();
    for (int k = 0; k < 200; ++k) {
      const double t = 1e-3 * k;
      const auto kinematics = model.kinematics(q + t * dq);
      const auto dynamics = model.dynamics(q + t * dq, dq);
      const VectorD<7> torque = (feasible + t * drift).cwiseMax(-0.9 * model.tau_max).cwiseMin(0.9 * model.tau_max);
      rme::CpicInput<double, 7> input;
      input.jacobian = kinematics.jacobian;
      input.mass_matrix = dynamics.mass_matrix;
      input.bias = dynamics.coriolis;
      const rme::Matrix6<double> JJ = kinematics.jacobian * kinematics.jacobian.transpose();
      input.wrench = rme::Wrench<double>::from_vector(
          rme::Vector6<double>(oracle::solve(JJ, kinematics.jacobian * torque) + error + t * rate));
      input.null_torque = torque + null_error;
      const VectorD<7> ddq = oracle::solve(input.mass_matrix, torque - input.bias);
      rme::Cpic<double, 7>::Rows rows;
      for (int j = 0; j < 7; ++j) (void)rows.add_axis(j, ddq[j] - room[j], ddq[j] + room[6 - j]);
      for (int j = 0; j < general; ++j) (void)rows.add(gradients.col(j), gradients.col(j).dot(ddq) - room[(j + 3) % 7]);
      const auto small_input = rounded<float>(input);
      const auto small_rows = rounded_rows<float>(rows);
      const Status expected = reference.update(rounded<double>(input), rows);
      if (cold) cpic.reset();
      const Status status = cpic.update(small_input, small_rows);
      tally.enter(expected, status, largest_miss(cpic, small_input, small_rows), 1e-3, cpic.iterations());
    }
  }
  return tally.print(what);
}

/// Random arms, every third next to a singular pose, with settings that the constructor accepts; many of their rows are
/// without room.
template <typename Scalar>
bool settings(unsigned seed, long count, double weight, double moment_arm, double clearance, double damping,
              double allowed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform;
  rme::CpicConfig<Scalar, 7> config;
  config.torque_limit = oracle::RandomArm<7, 28>(random, 0, 0, 0).torque_limit.template cast<Scalar>();
  config.null_space_weight = static_cast<Scalar>(weight);
  config.moment_arm = static_cast<Scalar>(moment_arm);
  config.null_space.clearance = static_cast<Scalar>(clearance);
  config.null_space.damping = static_cast<Scalar>(damping);
  rme::CpicConfig<double, 7> plain;  // the rows are the same for any cost: what default settings in double can keep
  plain.torque_limit = config.torque_limit.template cast<double>();
  rme::Cpic<Scalar, 7> cpic(config);
  Tally tally;
  for (long i = 0; i < count; ++i) {
    oracle::RandomArm<7, 28> arm(random, i % 2 ? 7 : 0, static_cast<int>(random() % 15), i % 5 ? 40 : 2);
    if (i % 3 == 0) {
      const oracle::Matrix U = oracle::random_rotation(random, 6), V = oracle::random_rotation(random, 7);
      oracle::Vector sigma(6);
      sigma << 1.5, 1.2, 0.9, 0.7, 0.5, std::pow(10.0, -6 * uniform(random));
      arm.input.jacobian = oracle::composed(U, sigma, V);
    }
    const auto input = rounded<Scalar>(arm.input);
    const auto rows = rounded_rows<Scalar>(arm.rows);
    rme::Cpic<double, 7> reference(plain);
    const Status expected = reference.update(
        {input.jacobian.template cast<double>(), input.mass_matrix.template cast<double>(),
         input.bias.template cast<double>(),
         rme::Wrench<double>::from_vector(rme::Vector6<double>(input.wrench.vector().template cast<double>())),
         input.null_torque.template cast<double>(), input.other_torque.template cast<double>()},
        rounded_rows<double>(rows));
    const Status status = cpic.update(input, rows);
    tally.enter(expected, status, largest_miss(cpic, input, rows), allowed, cpic.iterations());
  }
  char what[80];
  std::snprintf(what, sizeof what, "%s, eps %.0e, l %.0e, clearance %.0e, damping %.0e",
                sizeof(Scalar) == 4 ? "float" : "double", weight, moment_arm, clearance, damping);
  return tally.print(what);
}

int run(rme::examples::Arguments& arguments) {
  const long count = static_cast<long>(arguments.whole("--count", 10, 100000000).value_or(340000));
  const auto seed = static_cast<unsigned>(arguments.whole("--seed", 0).value_or(1));
  arguments.finish();
  std::printf("seed %u\n\n| %-58s | solved   | infeasible | not conv. | missed | worst Ok  | iterations |\n", seed, "");
  std::printf("|%s|---------:|-----------:|----------:|-------:|----------:|-----------:|\n",
              std::string(60, '-').c_str());
  bool good = random_problems<2>(seed, count);
  good = random_problems<6>(seed + 1, count) && good;
  good = random_problems<7>(seed + 2, count) && good;
  good = panda_walk(seed + 3, 7, false, "float, Panda walk, limits and 7 random rows, warm") && good;
  good = panda_walk(seed + 3, 7, true, "float, Panda walk, limits and 7 random rows, cold") && good;
  good = panda_walk(seed + 4, 0, false, "float, Panda walk, limits alone, warm") && good;
  good = panda_walk(seed + 4, 0, true, "float, Panda walk, limits alone, cold") && good;
  // So many that float would call some infeasible if the solver did not look again in a metric that is stretched less.
  const long arms = std::max(count / 10, 4000L);
  const double corners[][4] = {{1e-3, 1, 0.02, 0.02},  {1e-3, 0.1, 0.02, 0.02}, {1e-5, 1, 0.02, 0.02},
                               {1e-3, 1, 0.002, 0.02}, {1e4, 0.01, 0.01, 1e-4}, {1e-5, 10, 0.02, 1},
                               {1, 0.1, 0.001, 0.001}, {1e-3, 200, 0.02, 1e-4}};
  for (const auto& c : corners) good = settings<float>(seed + 5, arms, c[0], c[1], c[2], c[3], 1e-3) && good;
  for (const auto& c : corners) good = settings<double>(seed + 5, arms, c[0], c[1], c[2], c[3], 1e-12) && good;
  good = settings<double>(seed + 6, arms, 1e-9, 1, 0.02, 0.02, 1e-12) && good;
  good = settings<double>(seed + 6, arms, 1e-20, 1, 0.02, 0.02, 1e-12) && good;
  good = settings<double>(seed + 6, arms, 1e-3, 1e-9, 0.02, 0.02, 1e-12) && good;
  return good ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return rme::examples::run_program("rme_solver_precision", kUsage, argc, argv, run);
}
