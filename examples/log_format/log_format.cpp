#include "log_format/log_format.hpp"

namespace rme::examples {

LogFormat parse_format(Arguments& arguments) {
  LogFormat format;
  format.columns = arguments.text("--columns").value_or("");
  format.degrees = arguments.flag("--degrees");
  format.torque_delay = arguments.number("--torque-delay").value_or(0);
  if (!(std::abs(format.torque_delay) <= 1)) throw ArgumentError("--torque-delay: must be -1 to 1 s");
  return format;
}

}  // namespace rme::examples
