#pragma once
/// Tables, CSV files and progress of the experiments.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/arguments.hpp"

namespace rme::examples {

/// A Markdown table whose columns are also aligned as plain text.
class MarkdownTable {
 public:
  explicit MarkdownTable(std::vector<std::string> head) : rows_{std::move(head)} {}
  void row(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }

  /// Columns of numbers are aligned to the right: those whose last cell starts with a digit or a sign.
  void print() const {
    std::vector<std::size_t> width(rows_[0].size(), 3);
    for (const auto& row : rows_)
      for (std::size_t i = 0; i < row.size(); ++i) width[i] = std::max(width[i], length(row[i]));
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      for (std::size_t i = 0; i < rows_[r].size(); ++i) {
        const std::string pad(width[i] - length(rows_[r][i]), ' ');
        std::printf("| %s%s%s ", right(i) ? pad.c_str() : "", rows_[r][i].c_str(), right(i) ? "" : pad.c_str());
      }
      std::printf("|\n");
      if (r > 0) continue;
      for (std::size_t i = 0; i < width.size(); ++i)
        std::printf("|%s%s", std::string(width[i] + 1, '-').c_str(), right(i) ? ":" : "-");
      std::printf("|\n");
    }
    std::printf("\n");
  }

 private:
  bool right(std::size_t column) const {
    const std::string& cell = rows_.back()[column];
    return !cell.empty() && std::string("0123456789+-").find(cell[0]) != std::string::npos;
  }
  // In visible characters: UTF-8 continues a character with bytes 10xxxxxx.
  static std::size_t length(const std::string& text) {
    std::size_t n = 0;
    for (const char c : text) n += (static_cast<unsigned char>(c) & 0xC0) != 0x80 ? 1 : 0;
    return n;
  }

  std::vector<std::vector<std::string>> rows_;
};

/// printf into a string of at most 127 bytes: a table's cell.
template <typename... Values>
std::string text(const char* format, Values... values) {
  char buffer[128];
  std::snprintf(buffer, sizeof buffer, format, values...);
  return buffer;
}
inline std::string text(const char* plain) {
  return plain;
}

/// A CSV file in the output folder; without a folder nothing is written. Its stream throws if a later row cannot be
/// written.
class CsvFile {
 public:
  /// @throws ArgumentError if the header cannot be written
  CsvFile(const std::optional<std::string>& folder, const std::string& name, const std::string& head) {
    if (!folder) return;
    const std::string path = *folder + "/" + name;
    file_.open(path);
    file_.precision(9);
    if (!(file_ << head << '\n')) throw ArgumentError("--output: cannot write " + path);
    file_.exceptions(std::ofstream::failbit | std::ofstream::badbit);
  }
  /// One row of numbers and words.
  template <typename First, typename... Rest>
  void row(const First& first, const Rest&... rest) {
    if (!file_.is_open()) return;
    file_ << first;
    ((file_ << ',' << rest), ...);
    file_ << '\n';
  }

 private:
  std::ofstream file_;
};

/// Prints "WHAT: 12 of 60" to stderr, apart from the report on stdout.
inline void progress(const char* what, std::size_t done, std::size_t all) {
  std::fprintf(stderr, "\r%s: %zu of %zu%s", what, done, all, done == all ? "\n" : "");
}

}  // namespace rme::examples
