#pragma once
/// Stands in for console_bridge: the handler to which urdf_parser.cpp says what is wrong.
#include <string>

namespace console_bridge {

enum LogLevel { CONSOLE_BRIDGE_LOG_ERROR = 3 };

class OutputHandler {
 public:
  virtual ~OutputHandler() = default;
  virtual void log(const std::string& text, LogLevel level, const char* file, int line) = 0;
};

inline OutputHandler* handler = nullptr;
inline void useOutputHandler(OutputHandler* h) {
  handler = h;
}
inline void restorePreviousOutputHandler() {
  handler = nullptr;
}

}  // namespace console_bridge
