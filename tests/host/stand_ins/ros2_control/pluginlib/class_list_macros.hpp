#pragma once
// pluginlib's registration, here a list in the program.
#include <functional>
#include <map>
#include <memory>
#include <string>

namespace pluginlib::stand_in {

template <typename Base>
std::map<std::string, std::function<std::unique_ptr<Base>()>>& classes() {
  static std::map<std::string, std::function<std::unique_ptr<Base>()>> all;
  return all;
}

template <typename Class, typename Base>
bool add(const char* name) {
  return classes<Base>().emplace(name, [] { return std::make_unique<Class>(); }).second;
}

}  // namespace pluginlib::stand_in

#define RME_STAND_IN_JOIN(a, b) a##b
#define RME_STAND_IN_NAME(line) RME_STAND_IN_JOIN(registered_in_line_, line)
#define PLUGINLIB_EXPORT_CLASS(class_type, base_class_type)        \
  [[maybe_unused]] static const bool RME_STAND_IN_NAME(__LINE__) = \
      pluginlib::stand_in::add<class_type, base_class_type>(#class_type);
