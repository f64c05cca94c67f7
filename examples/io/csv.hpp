#pragma once
/// Tables of numbers with a header line, plain or gzip-compressed. Every error in a file is reported.
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace rme::examples {

/// Says what is wrong with a log: "FILE:LINE: column NAME: ...", lines counted from 1.
class LogError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The content of a file; gzip is recognised by the content, whatever the file is called.
/// @throws LogError if the file cannot be opened or read, or its gzip data are damaged or cut short
std::string read_file(const std::string& path);

/// Reads a CSV text row by row. Lines may end in LF or CRLF, cells may have spaces around them, a UTF-8 byte
/// order mark is skipped. Quoted cells are not supported: a comma always ends a cell. If the header has no comma, cells
/// end at semicolons, or else at tabs, or else at spaces.
class CsvReader {
 public:
  /// @param text  the CSV text; it must outlive the reader
  /// @param name  of the file, for messages
  /// @throws LogError if there is no header line
  CsvReader(std::string_view text, std::string name);

  /// The column of this name, or nothing.
  /// @throws LogError if the header has it twice
  std::optional<std::size_t> find(std::string_view column) const;
  /// The column of this name.
  /// @throws LogError if it is missing or there twice
  std::size_t at(std::string_view column) const;

  /// Moves to the next row.
  /// @return false at the end of the text
  /// @throws LogError if the row has fewer or more cells than the header
  bool next();
  /// The number in this cell of the current row. Cells that are not read may contain anything.
  /// @throws LogError if it is not a finite number
  double number(std::size_t column) const;
  /// Throws LogError about this cell of the current row.
  [[noreturn]] void fail(std::size_t column, const std::string& what) const;

  const std::string& name() const noexcept { return name_; }
  const std::vector<std::string_view>& header() const noexcept { return header_; }
  std::size_t line() const noexcept { return line_; }  ///< of the current row; the header is line 1

 private:
  void split_line();
  [[noreturn]] void fail(const std::string& what) const;

  std::string_view rest_;  // what has not been read yet
  std::string name_;
  std::vector<std::string_view> header_;
  std::vector<std::string_view> cells_;
  std::size_t line_ = 0;
  char separator_ = ',';
};

}  // namespace rme::examples
