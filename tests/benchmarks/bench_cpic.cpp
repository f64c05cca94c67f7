// How long CPIC takes, by percentiles: the whole update from (J, M, bias, F_c) to the torque, and the quadratic program
// alone, warm, along random walks of a Panda's state.
//
// Each call is timed by itself.
#include <cmath>
#include <cstdio>
#include <random>
#include <rme/control/cpic.hpp>
#include <string>
#include <synthetic_arm/panda.hpp>
#include <vector>

#include "benchmarks/stopwatch.hpp"

namespace {

using rme::benchmarks::print_head;
using rme::benchmarks::print_row;
using Vector = rme::JointVector<double, 7>;
using Matrix = rme::JointMatrix<double, 7>;

Vector random_vector(std::mt19937& random) {
  std::normal_distribution<double> normal;
  Vector v;
  for (int i = 0; i < 7; ++i) v[i] = normal(random);
  return v;
}

/// One state of a walk, as a host would have it.
struct State {
  rme::CpicInput<double, 7> input;
  Vector feasible;  // a torque that keeps the rows
};

/// 200 ms of joint motion in a straight line from a random pose; the task force, and with it the active set, drifts.
/// @param tightness  how far task force and null-space torque are from those of a feasible torque [N], [N m]
std::vector<State> walk(std::mt19937& random, double tightness) {
  const auto& model = rme::examples::panda();
  std::uniform_real_distribution<double> uniform;
  Vector q, dq = 0.5 * random_vector(random), feasible;
  for (int j = 0; j < 7; ++j) {
    q[j] = model.q_min[j] + (0.15 + 0.7 * uniform(random)) * (model.q_max[j] - model.q_min[j]);
    feasible[j] = (uniform(random) - 0.5) * model.tau_max[j];
  }
  const Vector null_error = tightness * random_vector(random), drift = 20 * random_vector(random);
  const rme::Vector6<double> error = tightness * random_vector(random).head<6>();
  const rme::Vector6<double> error_rate = tightness * random_vector(random).head<6>();
  std::vector<State> states;
  for (int k = 0; k < 200; ++k) {
    const double t = 1e-3 * k;
    const auto kinematics = model.kinematics(q + t * dq);
    const auto dynamics = model.dynamics(q + t * dq, dq);
    State s;
    s.feasible = feasible + t * drift;
    s.feasible = s.feasible.cwiseMax(-0.9 * model.tau_max).cwiseMin(0.9 * model.tau_max);
    s.input.jacobian = kinematics.jacobian;
    s.input.mass_matrix = dynamics.mass_matrix;
    s.input.bias = dynamics.coriolis;
    const rme::Matrix6<double> JJ = kinematics.jacobian * kinematics.jacobian.transpose();
    const rme::Vector6<double> wrench = JJ.ldlt().solve(kinematics.jacobian * s.feasible) + error + 5 * t * error_rate;
    s.input.wrench = rme::Wrench<double>::from_vector(wrench);
    s.input.null_torque = s.feasible + null_error;
    states.push_back(s);
  }
  return states;
}

void print_by_active(const std::string& what, const std::vector<double> (&times)[4]) {
  const char* const names[] = {"no active row", "1 active row", "2 or 3 active rows", "4 or more active rows"};
  for (int i = 0; i < 4; ++i) print_row(what + ", " + names[i], times[i]);
}

void time_update(int paths) {
  const unsigned seed = 4401;
  std::mt19937 random(seed);
  std::vector<double> all;
  std::vector<double> by_active[4];
  rme::CpicConfig<double, 7> config;
  config.torque_limit = rme::examples::panda().tau_max;
  std::uniform_real_distribution<double> uniform;
  for (int path = 0; path < paths; ++path) {
    rme::Cpic<double, 7> cpic(config);
    rme::benchmarks::rest();
    const auto states = walk(random, std::pow(10.0, 4 * uniform(random) - 2));
    const Vector room = (20 * Vector::Ones()).cwiseProduct(random_vector(random).cwiseAbs());
    for (const State& s : states) {
      const Vector ddq = s.input.mass_matrix.llt().solve(s.feasible - s.input.bias);
      rme::Status status;
      const double time = rme::benchmarks::time_of([&] {
        rme::ConstraintRows<double, 7, 28> rows;
        for (int j = 0; j < 7; ++j) (void)rows.add_axis(j, ddq[j] - room[j], ddq[j] + room[6 - j]);
        status = cpic.update(s.input, rows);
      });
      if (status != rme::Status::Ok) std::printf("unexpected status: %s\n", rme::to_string(status));
      all.push_back(time);
      const int n = cpic.active_count();
      by_active[n < 2 ? n : n < 4 ? 2 : 3].push_back(time);
    }
  }
  print_head("Cpic::update with 14 joint limits and torque limits, rows included");
  print_row("Cpic::update, all", all);
  print_by_active("Cpic::update", by_active);
}

/// @param from_root  as CPIC calls it; or from P, which is factorised as soon as two rows are active
template <typename Scalar, int Count>
void time_solver(int paths, bool from_root) {
  using Solver = rme::ActiveSetSolver<Scalar, 7, Count>;
  using SolverVector = typename Solver::Vector;
  const unsigned seed = 4402;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform;
  std::vector<double> by_active[4];
  struct Problem {
    typename Solver::Matrix P;
    typename Solver::Root root;
    SolverVector x_u;
    typename Solver::Rows rows;
  };
  const SolverVector limit = rme::examples::panda().tau_max.template cast<Scalar>();
  for (int path = 0; path < paths; ++path) {
    rme::benchmarks::rest();
    const auto states = walk(random, std::pow(10.0, 4 * uniform(random) - 2));
    std::vector<Vector> gradients;
    std::vector<double> room;
    for (int i = 0; i < Count; ++i) {
      gradients.push_back(i < 14 ? Vector((i % 2 ? -1 : 1) * Vector::Unit(i / 2)) : random_vector(random).normalized());
      room.push_back(20 * std::abs(random_vector(random)[0]));
    }
    std::vector<Problem> problems;
    rme::NullSpace<double, 7> null_space;
    for (const State& s : states) {
      Problem p;
      (void)null_space.update(s.input.jacobian);
      const Matrix P = (s.input.jacobian.transpose() * s.input.jacobian + null_space.projector() / 1e-3) / 2;
      p.P = P.cast<Scalar>();
      p.root.setZero();
      p.root.template topRows<7>() = Matrix(P.llt().matrixU()).cast<Scalar>();
      p.x_u = (s.input.jacobian.transpose() * s.input.wrench.vector() + null_space.projector() * s.input.null_torque)
                  .template cast<Scalar>();
      const Eigen::LLT<Matrix> inertia(s.input.mass_matrix);
      for (int i = 0; i < Count; ++i) {  // one-sided and general, as any other solver would be given them
        const Vector a = inertia.solve(gradients[static_cast<std::size_t>(i)]);
        (void)p.rows.add(a.cast<Scalar>(), static_cast<Scalar>(a.dot(s.feasible) - room[static_cast<std::size_t>(i)]));
      }
      problems.push_back(p);
    }
    Solver solver;
    for (const Problem& p : problems) {
      const Problem local = p;  // in L1, as in a control loop that has just built it
      rme::Status status;
      const double time = rme::benchmarks::time_of([&] {
        status = from_root ? solver.solve_from_root(local.root, local.x_u, local.rows, -limit, limit)
                           : solver.solve(local.P, local.x_u, local.rows, -limit, limit);
      });
      if (status != rme::Status::Ok) std::printf("unexpected status: %s\n", rme::to_string(status));
      const int n = solver.active_count();
      by_active[n < 2 ? n : n < 4 ? 2 : 3].push_back(time);
    }
  }
  const std::string what = std::string("solve") + (from_root ? "_from_root" : "") + ", " + std::to_string(Count) +
                           " rows, " + (sizeof(Scalar) == 4 ? "float" : "double");
  print_head(("ActiveSetSolver::" + what + ", with torque limits, warm").c_str());
  print_by_active(what, by_active);
}

/// The same states with more and more rows that the torque keeps: barriers that are far away.
void time_rows(int paths) {
  const unsigned seed = 4403;
  std::mt19937 random(seed);
  rme::CpicConfig<double, 7> config;
  config.torque_limit = rme::examples::panda().tau_max;
  const int counts[] = {0, 1, 2, 4, 7, 14, 21, 28};
  std::vector<double> times[std::size(counts)];
  for (int path = 0; path < paths; ++path) {
    rme::benchmarks::rest();
    const auto states = walk(random, 0.01);
    Vector gradients[28];
    for (Vector& gradient : gradients) gradient = random_vector(random).normalized();
    for (std::size_t c = 0; c < std::size(counts); ++c) {
      rme::Cpic<double, 7> cpic(config);
      for (const State& s : states) {
        const double far = -100 - s.input.mass_matrix.llt().solve(s.feasible - s.input.bias).norm();
        times[c].push_back(rme::benchmarks::time_of([&] {
          rme::ConstraintRows<double, 7, 28> rows;
          for (int i = 0; i < counts[c]; ++i) (void)rows.add(gradients[i], far);
          (void)cpic.update(s.input, rows);
        }));
      }
    }
  }
  print_head("Cpic::update by number of general rows, none active");
  for (std::size_t c = 0; c < std::size(counts); ++c) print_row(std::to_string(counts[c]) + " rows", times[c]);
}

}  // namespace

int main(int argc, char** argv) {
  const int paths = rme::benchmarks::quick(argc, argv) ? 2 : 500;
  time_update(paths);
  time_solver<double, 14>(paths, true);
  time_solver<double, 14>(paths, false);
  time_solver<float, 14>(paths, true);
  time_solver<float, 14>(paths, false);
  time_solver<double, 28>(paths, true);
  time_rows(paths / 2);
  std::printf("\nseeds 4401, 4402, 4403\n");
}
