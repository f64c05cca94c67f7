// Compiled only so that the precompiled header of tests/CMakeLists.txt is made.
#include "support/catch.hpp"
