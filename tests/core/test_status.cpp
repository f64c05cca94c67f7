#include <rme/core/status.hpp>
#include <string>

#include "support/catch.hpp"

namespace {

using rme::Status;

TEST_CASE("to_string: every status has the name of its enumerator, and no other number has one", "[status]") {
  CHECK(rme::to_string(Status::Ok) == std::string("Ok"));
  CHECK(rme::to_string(Status::NonFiniteInput) == std::string("NonFiniteInput"));
  CHECK(rme::to_string(Status::NotARotation) == std::string("NotARotation"));
  CHECK(rme::to_string(Status::NotReady) == std::string("NotReady"));
  CHECK(rme::to_string(Status::NotPositiveDefinite) == std::string("NotPositiveDefinite"));
  CHECK(rme::to_string(Status::NotConverged) == std::string("NotConverged"));
  CHECK(rme::to_string(Status::Infeasible) == std::string("Infeasible"));
  CHECK(rme::to_string(Status::CapacityExceeded) == std::string("CapacityExceeded"));
  CHECK(rme::to_string(Status::NotAMeasurement) == std::string("NotAMeasurement"));
  CHECK(rme::to_string(Status::Unbounded) == std::string("Unbounded"));
  CHECK(rme::to_string(Status(200)) == std::string("unknown"));
}

}  // namespace
