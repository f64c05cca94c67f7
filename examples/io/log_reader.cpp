#include "io/log_reader.hpp"

namespace rme::examples {

template Log<4> parse_log(std::string_view, const std::string&, const LogColumns&);
template Log<5> parse_log(std::string_view, const std::string&, const LogColumns&);
template Log<6> parse_log(std::string_view, const std::string&, const LogColumns&);
template Log<7> parse_log(std::string_view, const std::string&, const LogColumns&);
template Log<8> parse_log(std::string_view, const std::string&, const LogColumns&);

}  // namespace rme::examples
