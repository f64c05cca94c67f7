#include <Eigen/LU>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <rme/inference/linear_program.hpp>
#include <vector>

#include "support/catch.hpp"

namespace {

using rme::Status;
using Vector2 = Eigen::Vector2d;
using Vector3 = Eigen::Vector3d;

template <typename Scalar>
using Plane = rme::LinearProgram<Scalar, 2, 12>;
using Space = rme::LinearProgram<double, 3, 24>;

/// max c.x over all vertices: each three rows meet in a point, which counts if it keeps the others.
double best_vertex(const std::vector<Eigen::Vector4d>& rows, const Vector3& c) {
  double best = -std::numeric_limits<double>::infinity();
  const auto keeps = [&](const Vector3& x) {
    for (const auto& row : rows)
      if (row.head<3>().dot(x) > row[3] + 1e-9) return false;
    return true;
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = i + 1; j < rows.size(); ++j) {
      for (std::size_t k = j + 1; k < rows.size(); ++k) {
        Eigen::Matrix3d A;
        A << rows[i].head<3>().transpose(), rows[j].head<3>().transpose(), rows[k].head<3>().transpose();
        if (std::abs(A.determinant()) < 1e-7) continue;
        const Vector3 x = A.inverse() * Vector3(rows[i][3], rows[j][3], rows[k][3]);
        if (keeps(x)) best = std::max(best, c.dot(x));
      }
    }
  }
  return best;
}

TEST_CASE("LinearProgram: a plan for two products, as a textbook solves it", "[linear_program]") {
  // x1 + x2 <= 6, x1 + 3 x2 <= 12, 2 x1 + x2 <= 10, both >= 0: of the corners (0, 0), (5, 0), (4, 2), (3, 3) and
  // (0, 4), 3 x1 + 2 x2 is largest at (4, 2), and x1 + 2 x2 at (3, 3).
  Plane<double> program;
  const double rows[5][3] = {{1, 1, 6}, {1, 3, 12}, {2, 1, 10}, {-1, 0, 0}, {0, -1, 0}};
  for (const auto& row : rows) REQUIRE(program.add(Vector2(row[0], row[1]), row[2]) == Status::Ok);
  CHECK(program.size() == 5);
  REQUIRE(program.start(Vector2(1, 1)) == Status::Ok);
  Plane<double>::Result result;
  REQUIRE(program.maximise(Vector2(3, 2), result) == Status::Ok);
  CHECK((result.x - Vector2(4, 2)).norm() < 1e-14);
  CHECK(std::abs(result.value - 16) < 1e-13);
  CHECK(result.upper >= 16);
  CHECK(result.upper < 16 + 1e-12);
  CHECK(result.pivots >= 2);  // from within to a vertex
  REQUIRE(program.maximise(Vector2(1, 2), result) == Status::Ok);
  CHECK((result.x - Vector2(3, 3)).norm() < 1e-14);
  CHECK(result.pivots == 1);  // from one vertex to its neighbour
  REQUIRE(program.maximise(Vector2(1, 2), result) == Status::Ok);
  CHECK(result.pivots == 0);
}

TEST_CASE("LinearProgram: of 2000 random polytopes the best vertex is found, and never missed by rounding",
          "[linear_program]") {
  const unsigned seed = 7;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> u(-1, 1);
  const auto draw = [&] { return Vector3{u(random), u(random), u(random)}; };
  for (int trial = 0; trial < 2000; ++trial) {
    CAPTURE(trial);
    std::vector<Eigen::Vector4d> rows;
    const Vector3 inside = draw();
    for (int i = 0; i < 3; ++i) {  // a box, so that there is a vertex
      for (const double side : {-1.0, 1.0})
        rows.emplace_back((Eigen::Vector4d() << side * Vector3::Unit(i), 3).finished());
    }
    for (int i = 0; i < 8; ++i) {
      const Vector3 a = draw();
      rows.emplace_back((Eigen::Vector4d() << a, a.dot(inside) + (i < 4 ? 0.0 : 0.5 * (1 + u(random)))).finished());
    }
    Space program;
    for (const auto& row : rows) REQUIRE(program.add(row.head<3>(), row[3]) == Status::Ok);
    REQUIRE(program.start(inside) == Status::Ok);  // where four of the rows are active
    for (int k = 0; k < 4; ++k) {
      const Vector3 c = draw();
      Space::Result result;
      REQUIRE(program.maximise(c, result) == Status::Ok);
      const double best = best_vertex(rows, c);
      CHECK(std::abs(result.value - best) < 1e-9);
      CHECK(result.upper >= c.dot(inside));
      CHECK(result.upper < best + 1e-9);
      for (const auto& row : rows) CHECK(row.head<3>().dot(result.x) <= row[3] + 1e-12);
    }
  }
}

TEST_CASE("LinearProgram: what nothing bounds is Unbounded, and what a strip bounds is found", "[linear_program]") {
  Plane<double> program;
  REQUIRE(program.start(Vector2(5, 7)) == Status::Ok);
  Plane<double>::Result result;
  CHECK(program.maximise(Vector2(1, 0), result) == Status::Unbounded);  // no row at all
  CHECK(result.x == Vector2(0, 0));                                     // as it was
  REQUIRE(program.maximise(Vector2(0, 0), result) == Status::Ok);
  CHECK(result.x == Vector2(5, 7));
  // -1 <= x + y <= 2: a strip, without a vertex.
  REQUIRE(program.add(Vector2(1, 1), 2) == Status::Ok);
  REQUIRE(program.add(Vector2(-1, -1), 1) == Status::Ok);
  REQUIRE(program.start(Vector2(0, 0)) == Status::Ok);
  CHECK(program.maximise(Vector2(1, 0.9), result) == Status::Unbounded);
  REQUIRE(program.maximise(Vector2(3, 3), result) == Status::Ok);
  CHECK(std::abs(result.value - 6) < 1e-14);
  REQUIRE(program.maximise(Vector2(-1, -1), result) == Status::Ok);
  CHECK(std::abs(result.value - 1) < 1e-14);
  CHECK(program.maximise(Vector2(-1, 0), result) == Status::Unbounded);
}

TEST_CASE("LinearProgram: the maximum is found where many rows meet", "[linear_program]") {
  // Beale's program, on which the rule of the steepest gradient cycles: the largest 3/4 x1 - 150 x2 + 1/50 x3 - 6 x4 is
  // 1/20, at (1/25, 0, 1, 0).
  rme::LinearProgram<double, 4, 8> beale;
  using Vector4 = Eigen::Vector4d;
  REQUIRE(beale.add(Vector4(0.25, -60, -0.04, 9), 0) == Status::Ok);
  REQUIRE(beale.add(Vector4(0.5, -90, -0.02, 3), 0) == Status::Ok);
  REQUIRE(beale.add(Vector4(0, 0, 1, 0), 1) == Status::Ok);
  for (int i = 0; i < 4; ++i) REQUIRE(beale.add(-Vector4::Unit(i), 0) == Status::Ok);
  REQUIRE(beale.start(Vector4::Zero()) == Status::Ok);
  rme::LinearProgramResult<double, 4> best;
  REQUIRE(beale.maximise(Vector4(0.75, -150, 0.02, -6), best) == Status::Ok);
  CHECK(std::abs(best.value - 0.05) < 1e-14);
  CHECK((best.x - Vector4(0.04, 0, 1, 0)).norm() < 1e-13);

  // Cones: every row holds at the start, some of them twice. max c.x is 0, at the tip, if -c is in the cone's dual.
  const unsigned seed = 8;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int trial = 0; trial < 2000; ++trial) {
    CAPTURE(trial);
    Space program;
    Vector3 c = Vector3::Zero();
    for (int i = 0; i < 12; ++i) {
      // Small whole numbers, so that many rows are parallel, or meet in the same edges.
      const Vector3 a{std::round(2 * u(random)), std::round(2 * u(random)), 1 + std::round(u(random) + 1)};
      REQUIRE(program.add(a, 0) == Status::Ok);
      if (i % 3 == 0) REQUIRE(program.add(a, 0) == Status::Ok);
      const double weight = 1 + u(random);
      c += weight * a;
    }
    REQUIRE(program.start(Vector3::Zero()) == Status::Ok);
    Space::Result result;
    REQUIRE(program.maximise(c, result) == Status::Ok);
    CHECK(std::abs(result.value) < 1e-12);
    CHECK(result.pivots < 12);
  }
}

TEST_CASE("LinearProgram: the last unknowns can be held", "[linear_program]") {
  // x + y <= 4, x <= 3: with y held at 2 the largest x is 2, with y = 0 it is 3.
  Plane<double> program;
  REQUIRE(program.add(Vector2(1, 1), 4) == Status::Ok);
  REQUIRE(program.add(Vector2(1, 0), 3) == Status::Ok);
  Plane<double>::Result result;
  for (const auto& [y, x] : {std::array<double, 2>{2, 2}, std::array<double, 2>{0, 3}}) {
    REQUIRE(program.start(Vector2(0, y), 1) == Status::Ok);
    REQUIRE(program.maximise(Vector2(1, 5), result) == Status::Ok);
    CHECK((result.x - Vector2(x, y)).norm() < 1e-14);
    CHECK(std::abs(result.value - (x + 5 * y)) < 1e-13);
    CHECK(result.upper >= x + 5 * y);
  }
}

TEST_CASE("LinearProgram: rows of any scale, and in float", "[linear_program]") {
  Plane<float> program;
  using Vector2f = Eigen::Vector2f;
  REQUIRE(program.add(Vector2f(1e-12f, 1e-12f), 6e-12f) == Status::Ok);
  REQUIRE(program.add(Vector2f(2e15f, 1e15f), 10e15f) == Status::Ok);
  REQUIRE(program.add(Vector2f(0, 1e-30f), 5e-30f) == Status::Ok);
  REQUIRE(program.start(Vector2f(0, 0)) == Status::Ok);
  Plane<float>::Result result;
  REQUIRE(program.maximise(Vector2f(3, 2), result) == Status::Ok);
  CHECK((result.x - Vector2f(4, 2)).norm() < 1e-5f);
  CHECK(result.upper >= 16.0f);
  CHECK(result.upper < 16.01f);
}

TEST_CASE("LinearProgram: bad input is refused, and changes nothing", "[linear_program]") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  Plane<double> program;
  Plane<double>::Result result;
  CHECK(program.maximise(Vector2(1, 0), result) == Status::NotReady);
  CHECK(program.add(Vector2(1, nan), 1) == Status::NonFiniteInput);
  CHECK(program.add(Vector2(1, infinity), 1) == Status::NonFiniteInput);
  CHECK(program.add(Vector2(1, 1), infinity) == Status::NonFiniteInput);
  CHECK(program.add(Vector2(1, 1), nan) == Status::NonFiniteInput);
  CHECK(program.add(Vector2(1e-200, 0), 1e200) == Status::NonFiniteInput);
  CHECK(program.add(Vector2(1.7e308, 1.7e308), 0) == Status::NonFiniteInput);
  CHECK(program.add(Vector2(0, 0), -1) == Status::Infeasible);
  CHECK(program.size() == 0);
  CHECK(program.add(Vector2(0, 0), 0) == Status::Ok);  // says nothing
  CHECK(program.size() == 0);
  for (int i = 0; i < 12; ++i) REQUIRE(program.add(Vector2(1, i), 1) == Status::Ok);
  CHECK(program.add(Vector2(1, 0), 1) == Status::CapacityExceeded);
  CHECK(program.start(Vector2(nan, 0)) == Status::NonFiniteInput);
  CHECK(program.maximise(Vector2(1, 0), result) == Status::NotReady);
  REQUIRE(program.start(Vector2(0, 0)) == Status::Ok);
  CHECK(program.maximise(Vector2(1, nan), result) == Status::NonFiniteInput);
  CHECK(program.maximise(Vector2(1, 0), result) == Status::Ok);
  program.clear();
  CHECK(program.size() == 0);
  REQUIRE(program.add(Vector2(1, 0), 1) == Status::Ok);
  CHECK(program.maximise(Vector2(1, 0), result) == Status::NotReady);  // a row since the start
}

}  // namespace
