// Replaces urdf_chain.cpp if urdfdom is not found.
#include "urdf_arm/urdf_chain.hpp"

namespace rme::examples {

UrdfChain parse_urdf(const std::string&, const std::string& file, const std::string&, const std::string&) {
  throw UrdfError(file +
                  ": reading a URDF needs urdfdom, without which these programs were built; install it (Debian, "
                  "Ubuntu: liburdfdom-dev), configure and build again");
}

UrdfChain read_urdf(const std::string& file, const std::string& base, const std::string& tip) {
  return parse_urdf({}, file, base, tip);
}

}  // namespace rme::examples
