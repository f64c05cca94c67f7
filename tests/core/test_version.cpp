#include <rme/version.hpp>
#include <string>

#include "support/catch.hpp"

TEST_CASE("Version: the number for the preprocessor and the text are made of the same three parts", "[version]") {
  using namespace rme;
  STATIC_REQUIRE(RME_VERSION == 10000 * kVersionMajor + 100 * kVersionMinor + kVersionPatch);
  CHECK(kVersion ==
        std::to_string(kVersionMajor) + "." + std::to_string(kVersionMinor) + "." + std::to_string(kVersionPatch));
}
