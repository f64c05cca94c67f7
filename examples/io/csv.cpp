#include "io/csv.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <memory>
#include <system_error>
#include <utility>

#include "io/number.hpp"

namespace rme::examples {

std::string read_file(const std::string& path) {
  struct Close {
    void operator()(gzFile file) const { gzclose_r(file); }
  };
  errno = 0;
  const std::unique_ptr<gzFile_s, Close> file(gzopen(path.c_str(), "rb"));  // passes plain files through unchanged
  if (!file) throw LogError(path + ": cannot be opened: " + std::generic_category().message(errno));

  std::string text;
  std::array<char, 1u << 16> block{};
  int size = 0;
  while ((size = gzread(file.get(), block.data(), static_cast<unsigned>(block.size()))) > 0) {
    text.append(block.data(), static_cast<std::size_t>(size));
  }
  // A stream that was cut short ends like a complete one; only the error code shows it.
  int error = Z_OK;
  gzerror(file.get(), &error);
  if (error == Z_ERRNO) throw LogError(path + ": cannot be read: " + std::generic_category().message(errno));
  if (error == Z_BUF_ERROR) throw LogError(path + ": the gzip data are cut short");
  if (error != Z_OK) throw LogError(path + ": the gzip data are damaged");
  return text;
}

CsvReader::CsvReader(std::string_view text, std::string name) : rest_(text), name_(std::move(name)) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (rest_.substr(0, byte_order_mark.size()) == byte_order_mark) rest_.remove_prefix(byte_order_mark.size());
  rest_ = rest_.substr(0, rest_.find_last_not_of(" \t\r\n") + 1);  // blank lines at the end are not rows
  if (rest_.empty()) throw LogError(name_ + ": is empty");
  const std::string_view first = rest_.substr(0, rest_.find('\n'));
  for (const char separator : {' ', '\t', ';', ','})
    if (trimmed(first).find(separator) != std::string_view::npos) separator_ = separator;
  split_line();
  header_ = cells_;
}

std::optional<std::size_t> CsvReader::find(std::string_view column) const {
  const auto found = std::find(header_.begin(), header_.end(), column);
  if (found == header_.end()) return std::nullopt;
  if (std::find(found + 1, header_.end(), column) != header_.end()) {
    throw LogError(name_ + ":1: column " + std::string(column) + " is there twice");
  }
  return static_cast<std::size_t>(found - header_.begin());
}

std::size_t CsvReader::at(std::string_view column) const {
  const auto found = find(column);
  if (!found) throw LogError(name_ + ":1: column " + std::string(column) + " is missing");
  return *found;
}

bool CsvReader::next() {
  if (rest_.empty()) return false;
  split_line();
  if (cells_.size() < header_.size()) {
    fail(cells_.size(), "no such cell: the row has " + std::to_string(cells_.size()) + " cells, the header " +
                            std::to_string(header_.size()));
  }
  if (cells_.size() > header_.size()) {
    fail("column " + std::to_string(header_.size() + 1) + ": the row has " + std::to_string(cells_.size()) +
         " cells, the header " + std::to_string(header_.size()));
  }
  return true;
}

double CsvReader::number(std::size_t column) const {
  const auto value = parse_number(cells_[column]);
  if (!value) fail(column, "\"" + std::string(cells_[column]) + "\" is not a finite number");
  return *value;
}

void CsvReader::fail(std::size_t column, const std::string& what) const {
  fail("column " + std::string(header_[column]) + ": " + what);
}

void CsvReader::fail(const std::string& what) const {
  throw LogError(name_ + ":" + std::to_string(line_) + ": " + what);
}

void CsvReader::split_line() {
  ++line_;
  const std::size_t end = std::min(rest_.find('\n'), rest_.size());
  std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(std::min(end + 1, rest_.size()));
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  cells_.clear();
  if (separator_ == ' ') line = trimmed(line);
  for (std::size_t end_of_cell = 0; (end_of_cell = line.find(separator_)) != std::string_view::npos;) {
    cells_.push_back(trimmed(line.substr(0, end_of_cell)));
    line.remove_prefix(end_of_cell + 1);
    if (separator_ == ' ') line = trimmed(line);  // several spaces are one
  }
  cells_.push_back(trimmed(line));
}

}  // namespace rme::examples
