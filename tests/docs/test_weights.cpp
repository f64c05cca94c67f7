// The code of weights.md, run on the shipped model.
#include <Eigen/Core>
#include <fstream>
#include <nlohmann/json.hpp>
#include <rme/network/json.hpp>
#include <rme/network/mismatch_network.hpp>

#include "support/catch.hpp"

namespace {

TEST_CASE("weights.md: its four lines read the shipped model, which answers as in double precision", "[docs]") {
  const nlohmann::json file = nlohmann::json::parse(std::ifstream(RME_MODEL));
  rme::MismatchNetwork<float>::Window window;
  for (Eigen::Index t = 0; t < window.rows(); ++t) window.row(t) << 1, 2, -10, 0.5F, -0.3F, 0.1F;
#include "weights_snippet.hpp"
  REQUIRE(status == rme::Status::Ok);

  const rme::MismatchNetwork<double> exact(rme::model_from_json<double>(file).weights);
  Eigen::Vector4d expected;
  REQUIRE(exact.forward(window.cast<double>(), expected) == rme::Status::Ok);
  CHECK(expected[0] > 0.3);  // 10 N
  CHECK((theta.cast<double>() - expected).norm() < 1e-4);
}

}  // namespace
