#include "log_format/column_layout.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>

#include "io/number.hpp"

namespace rme::examples {

namespace {

using Names = std::vector<std::string>;

constexpr double kMilli = 1e-3, kNano = 1e-9;

/// A quantity of which a log has one column for each joint.
struct Quantity {
  const char* key;
  std::vector<LogColumn> LogColumns::*columns;
  Names stems;  ///< what recorders call it; before or after a joint's number or name
};

const std::vector<Quantity>& quantities() {
  static const std::vector<Quantity> all = {
      {"q", &LogColumns::q, {"q", "state.q", "actual_q", "field.position", "joint_position", "position", "pos"}},
      {"dq",
       &LogColumns::dq,
       {"dq", "state.dq", "actual_qd", "field.velocity", "joint_velocity", "velocity", "vel", "qd"}},
      {"tau_ext",
       &LogColumns::tau_ext,
       {"tau_ext", "tau_ext_hat_filtered", "state.tau_ext_hat_filtered", "external_torque"}},
      {"tau",
       &LogColumns::tau,
       {"tau", "state.tau_J", "tau_J", "field.effort", "joint_torque", "joint_effort", "effort", "torque",
        "actual_current", "current"}},
  };
  return all;
}

struct TimeColumn {
  const char* name;
  double factor;  // [s]
};
constexpr TimeColumn kTimes[] = {{"t", 1},     {"time", 1},      {"timestamp", 1},          {"__time", 1},
                                 {"stamp", 1}, {"%time", kNano}, {"duration", kMilli},      {"state.time", kMilli},
                                 {"Time", 1},  {"Timestamp", 1}, {"state.duration", kMilli}};

/// The file's columns.
class Header {
 public:
  Header(const std::vector<std::string_view>& names, const std::string& file)
      : names_(names.begin(), names.end()), file_(file) {}

  bool has(const std::string& name) const { return std::find(names_.begin(), names_.end(), name) != names_.end(); }
  const Names& names() const { return names_; }

  [[noreturn]] void fail(const std::string& what) const {
    std::string all;
    for (const std::string& name : names_) all += (all.empty() ? "" : ", ") + name;
    if (all.size() > 600) all = all.substr(0, 600) + ", ...";
    throw LogError(file_ + ":1: " + what + "; the file has " + all);
  }

  /// The columns before(number)after of all joints, numbered from 1 or, if that does not fit, from 0.
  std::optional<Names> numbered(const std::string& before, const std::string& after, std::size_t joints) const {
    for (const std::size_t first : {1u, 0u}) {
      Names found;
      for (std::size_t j = 0; j < joints; ++j) found.push_back(before + std::to_string(first + j) + after);
      const bool more = has(before + std::to_string(first + joints) + after);
      if (!more && std::all_of(found.begin(), found.end(), [this](const auto& name) { return has(name); }))
        return found;
    }
    return std::nullopt;
  }

  /// The columns that have the joints' names and the stem in theirs.
  std::optional<Names> named(const Names& joints, const std::string& stem) const {
    Names found;
    for (const std::string& joint : joints) {
      for (const std::string& name : names_) {
        const std::size_t at = name.find(joint);
        if (joint.empty() || at == std::string::npos) continue;
        const std::string rest = name.substr(0, at) + "\n" + name.substr(at + joint.size());
        if (is_word_of(rest, stem) && rest.find("name") == std::string::npos) found.push_back(name);
      }
    }
    if (found.size() != joints.size()) return std::nullopt;  // none, or not one for each joint
    return found;
  }

 private:
  /// Whether the stem stands in the text with no letter beside it.
  static bool is_word_of(const std::string& text, const std::string& stem) {
    const auto letter = [&](std::size_t i) { return std::isalnum(static_cast<unsigned char>(text[i])) != 0; };
    for (std::size_t at = text.find(stem); at != std::string::npos; at = text.find(stem, at + 1)) {
      const std::size_t end = at + stem.size();
      if ((at == 0 || !letter(at - 1)) && (end == text.size() || !letter(end))) return true;
    }
    return false;
  }
  Names names_;
  std::string file_;
};

std::optional<Names> find(const Header& header, const Quantity& quantity, const Names& joints) {
  for (const std::string& stem : quantity.stems)
    for (const auto& [before, after] : std::vector<std::pair<std::string, std::string>>{{stem, ""},
                                                                                        {stem + "_", ""},
                                                                                        {stem + "[", "]"},
                                                                                        {stem + ".", ""},
                                                                                        {stem + "s_", ""},
                                                                                        {stem + "s[", "]"},
                                                                                        {stem + "/", ""},
                                                                                        {stem + " ", ""}})
      if (auto found = header.numbered(before, after, joints.size())) return found;
  for (const std::string& stem : quantity.stems) {
    if (auto found = header.named(joints, stem)) return found;
  }
  return std::nullopt;
}

std::vector<LogColumn> plain(const Names& names) {
  std::vector<LogColumn> out;
  for (const std::string& name : names) out.push_back({name});
  return out;
}

/// `text` up to the separator, which is removed from it with all before it.
std::string cut(std::string& text, char separator) {
  const std::size_t end = std::min(text.find(separator), text.size());
  const std::string head = text.substr(0, end);
  text.erase(0, std::min(end + 1, text.size()));
  return head;
}

/// [FACTOR*][-]NAME[+OFFSET], where the name need not be that of a column.
LogColumn parse_column(std::string text, const Header& header) {
  LogColumn out;
  if (header.has(text)) return {text};
  if (const auto factor = parse_number(text.substr(0, text.find('*'))); factor && text.find('*') != std::string::npos) {
    out.factor = *factor;
    cut(text, '*');
  }
  if (!text.empty() && text[0] == '-') {
    out.factor = -out.factor;
    text.erase(0, 1);
  }
  const std::size_t sign = text.find_last_of("+-");
  if (!header.has(text) && sign != std::string::npos && sign > 0) {
    if (const auto offset = parse_number(text.substr(sign))) {
      out.offset = *offset;
      text.erase(sign);
    }
  }
  out.name = text;
  return out;
}

/// Applies an item of --columns.
void apply(const std::string& item, const Header& header, std::size_t joints, LogColumns& columns) {
  std::string value = item;
  const std::string key(trimmed(cut(value, '=')));
  const auto refuse = [&](const std::string& what) { header.fail("--columns: \"" + item + "\": " + what); };
  if (item.find('=') == std::string::npos || value.empty())
    refuse("must be KEY=NAME, such as q=position_*, dq=none or q2=-q2");
  const LogColumn column = parse_column(value, header);
  if (key == "t") {
    if (!header.has(column.name)) refuse("there is no column " + column.name);
    columns.t = {column};
    return;
  }
  for (const Quantity& quantity : quantities()) {
    std::vector<LogColumn>& all = columns.*quantity.columns;
    if (key == quantity.key) {
      if (value == "none") {
        all.clear();
        return;
      }
      const std::size_t star = column.name.find('*');
      if (star == std::string::npos) refuse("needs a * in place of the joint's number");
      const auto found = header.numbered(column.name.substr(0, star), column.name.substr(star + 1), joints);
      if (!found)
        refuse("there are no " + std::to_string(joints) + " columns of this name, with numbers from 0 or 1 for the *");
      all.clear();
      for (const std::string& name : *found) all.push_back({name, column.factor, column.offset});
      return;
    }
    const std::string stem = quantity.key;
    if (key.size() <= stem.size() || key.compare(0, stem.size(), stem) != 0) continue;
    const auto number = parse_number(key.substr(stem.size()));
    if (!number) continue;
    if (!(*number >= 1 && *number <= static_cast<double>(joints) && *number == std::floor(*number)))
      refuse("the arm has joints 1 to " + std::to_string(joints));
    if (!header.has(column.name)) refuse("there is no column " + column.name);
    all.resize(joints);
    all[static_cast<std::size_t>(*number) - 1] = column;
    return;
  }
  refuse("\"" + key + "\" is none of t, q, dq, tau, tau_ext, or one of these with a joint's number");
}

}  // namespace

ColumnLayout column_layout(const std::vector<std::string_view>& header_names, const std::string& file,
                           const std::vector<std::string>& joints, const std::string& given) {
  const Header header(header_names, file);
  ColumnLayout out;
  LogColumns& columns = out.columns;
  for (const TimeColumn& time : kTimes) {
    if (!header.has(time.name)) continue;
    columns.t = {{time.name, time.factor}};
    break;
  }
  for (const std::string& stamp : {std::string("header.stamp."), std::string("/joint_states/header/stamp/"),
                                   std::string("stamp."), std::string("stamp_"), std::string("header_stamp_")}) {
    for (const char* fine : {"nanosec", "nsec", "nanosecs", "nsecs"})
      for (const char* coarse : {"sec", "secs"})
        if (header.has(stamp + fine) && header.has(stamp + coarse) && (columns.t.empty() || columns.t[0].name != "t"))
          columns.t = {{stamp + coarse}, {stamp + fine, kNano}};
  }
  for (const Quantity& quantity : quantities())
    if (const auto found = find(header, quantity, joints)) columns.*quantity.columns = plain(*found);
  for (std::string rest = given; !rest.empty();) apply(cut(rest, ','), header, joints.size(), columns);
  for (const Quantity& quantity : quantities())
    for (std::size_t j = 0; j < (columns.*quantity.columns).size(); ++j)
      if ((columns.*quantity.columns)[j].name.empty())
        header.fail(std::string("--columns: ") + quantity.key + std::to_string(j + 1) + " is missing");
  if (columns.t.empty()) header.fail("column t is missing: --columns t=NAME says which one has the time");
  if (columns.q.empty())
    header.fail("columns q1..q" + std::to_string(joints.size()) + " are missing: --columns 'q=NAME*' says which " +
                "columns have the positions of the arm's " + std::to_string(joints.size()) + " joints");
  const auto note = [&](const char* key, const std::vector<LogColumn>& from, const std::string& usual) {
    if (from.empty() || from.front().name == usual) return;
    std::string text = std::string(key) + " is " + from.front().name;
    if (from.size() > 1) text += (from.size() > 2 ? " .. " : " + ") + from.back().name;
    if (from.front().factor == kMilli) text += " [ms]";
    if (from.front().factor == kNano) text += " [ns]";
    out.notes.push_back(text);
  };
  note("t", columns.t, "t");
  for (const Quantity& quantity : quantities())
    note(quantity.key, columns.*quantity.columns, std::string(quantity.key) + "1");
  if (!columns.tau.empty() && columns.tau.front().name.find("current") != std::string::npos)
    out.notes.push_back("tau is motor current [A]: --gains K1,K2,... gives the joints' torque per ampere");
  return out;
}

}  // namespace rme::examples
