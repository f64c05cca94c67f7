#pragma once
#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "ur_client_library/types.h"

namespace urcl::rtde_interface {

/// Holds the fields that its recipe names. A wrong type throws, as there.
class DataPackage {
 public:
  explicit DataPackage(const std::vector<std::string>& recipe, const std::uint16_t& /*protocol_version*/ = 2) {
    for (const std::string& name : recipe) {
      if (name == "payload")
        data_.emplace_back(name, 0.0);
      else if (name == "payload_cog")
        data_.emplace_back(name, vector3d_t{});
      else if (name == "actual_q" || name == "actual_qd" || name == "actual_current_as_torque" ||
               name == "payload_inertia")
        data_.emplace_back(name, vector6d_t{});
      else
        throw std::invalid_argument("RTDE has no field " + name);
    }
  }
  template <typename T>
  bool getData(const std::string& name, T& val) const {
    const auto it = std::find_if(data_.begin(), data_.end(), [&](const auto& entry) { return entry.first == name; });
    if (it == data_.end()) return false;
    val = std::get<T>(it->second);
    return true;
  }
  template <typename T>
  bool setData(const std::string& name, const T& val) {
    const auto it = std::find_if(data_.begin(), data_.end(), [&](const auto& entry) { return entry.first == name; });
    if (it == data_.end() || !std::holds_alternative<T>(it->second)) return false;
    it->second = val;
    return true;
  }

 private:
  std::vector<std::pair<std::string, std::variant<double, vector3d_t, vector6d_t>>> data_;
};

}  // namespace urcl::rtde_interface
