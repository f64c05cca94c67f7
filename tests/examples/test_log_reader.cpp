#include <cstdio>
#include <fstream>
#include <locale>
#include <string>
#include <vector>

#include "io/log_reader.hpp"
#include "support/catch.hpp"

namespace {

using rme::examples::Log;
using rme::examples::LogError;
using rme::examples::parse_log;
using rme::examples::read_log;

/// A file in the current folder for as long as the test runs.
struct TemporaryFile {
  TemporaryFile(std::string file_name, const std::string& content) : name(std::move(file_name)) {
    std::ofstream(name, std::ios::binary) << content;
  }
  ~TemporaryFile() { std::remove(name.c_str()); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  std::string name;
};

/// Two joints keep the texts readable.
Log<2> parse(const std::string& text) {
  return parse_log<2>(text, "a.csv");
}

/// `printf 't,q1,q2\n0,1,2\n1,3,4\n' | gzip -n -9`, made by gzip 1.12.
const std::string gzipped(
    "\x1f\x8b\x08\x00\x00\x00\x00\x00\x02\x03\x2b\xd1\x29\x34\xd4\x29\x34\xe2\x32\xd0\x31\xd4\x31\xe2\x32\xd4\x31\xd6"
    "\x31\xe1\x02\x00\xf8\x1c\x66\xf4\x14\x00\x00\x00",
    40);

TEST_CASE("parse_log: finds the columns by name in any order and leaves the others alone", "[log_reader]") {
  const Log<2> log = parse(
      "note,q2,tau_ext2,t,m,tau_ext1,q1,rz,ry,rx,tau1,tau2,dq1,dq2,\n"
      "hello,2,-4,0.5,1.5,-3,1,0.3,0.2,0.1,5,6,7,8,nan\n"
      ",20,-40,0.75,0,-30,10,0,0,0,50,60,70,80,\n");
  CHECK(log.t == std::vector<double>{0.5, 0.75});
  REQUIRE(log.q.size() == 2);
  CHECK(log.q[0] == Eigen::Vector2d(1, 2));
  CHECK(log.q[1] == Eigen::Vector2d(10, 20));
  REQUIRE(log.tau_ext.size() == 2);
  CHECK(log.tau_ext[0] == Eigen::Vector2d(-3, -4));
  REQUIRE(log.tau.size() == 2);
  CHECK(log.tau[1] == Eigen::Vector2d(50, 60));
  REQUIRE(log.dq.size() == 2);
  CHECK(log.dq[1] == Eigen::Vector2d(70, 80));
  REQUIRE(log.truth.size() == 2);
  CHECK(log.truth[0] == Eigen::Vector4d(1.5, 0.1, 0.2, 0.3));
}

TEST_CASE("parse_log: quantities that the file does not hold are empty", "[log_reader]") {
  const Log<2> log = parse("t,q1,q2\n0,1,2\n");
  CHECK(log.size() == 1);
  CHECK(log.dq.empty());
  CHECK(log.tau_ext.empty());
  CHECK(log.tau.empty());
  CHECK(log.truth.empty());
}

TEST_CASE("parse_log: byte order mark, CRLF, spaces, plus signs and exponents are all right", "[log_reader]") {
  for (const char* text :
       {"\xEF\xBB\xBFt,q1,q2\r\n 0 ,\t+1.0,2e-3\r\n1E0,-1.,.5\r\n\r\n", "t,q1 , q2\n0,1,.002\n1,-1,0.5"}) {
    CAPTURE(text);
    const Log<2> log = parse(text);
    CHECK(log.t == std::vector<double>{0, 1});
    REQUIRE(log.q.size() == 2);
    CHECK(log.q[0] == Eigen::Vector2d(1, 0.002));
    CHECK(log.q[1] == Eigen::Vector2d(-1, 0.5));
  }
}

TEST_CASE("parse_log: what is wrong is said with file, line and column", "[log_reader]") {
  struct Case {
    const char* text;
    const char* message;
  };
  const auto wrong = GENERATE(values<Case>({
      {"", "a.csv: is empty"},
      {" \r\n\n", "a.csv: is empty"},
      {"t,q1,q2\n", "a.csv: has a header but no rows"},
      {"q1,q2\n1,2\n", "a.csv:1: column t is missing"},
      {"t,q1\n0,1\n", "a.csv:1: column q2 is missing"},
      {"0,1,2\n1,1,2\n", "a.csv:1: column t is missing"},
      {"t,q1,q2,q1\n0,1,2,3\n", "a.csv:1: column q1 is there twice"},
      {"t,q1,q2,q3\n0,1,2,3\n", "a.csv:1: column q3: the arm has 2 joints"},
      {"t,q1,q2,dq2\n0,1,2,3\n", "a.csv:1: column dq1 is missing"},
      {"t,q1,q2,tau_ext1\n0,1,2,3\n", "a.csv:1: column tau_ext2 is missing"},
      {"t,q1,q2,tau1\n0,1,2,3\n", "a.csv:1: column tau2 is missing"},
      {"t,q1,q2,m,rx,rz\n0,1,2,3,4,5\n", "a.csv:1: column ry is missing"},
      {"t,q1,q2\n0,1,2\n1,3\n", "a.csv:3: column q2: no such cell: the row has 2 cells, the header 3"},
      {"t,q1,q2\n0,1,2\n\n1,3,4\n", "a.csv:3: column q1: no such cell: the row has 1 cells, the header 3"},
      {"t,q1,q2\n0,1,2,3\n", "a.csv:2: column 4: the row has 4 cells, the header 3"},
      {"t,q1,q2\n0,1,2\n1,3,x\n", "a.csv:3: column q2: \"x\" is not a finite number"},
      {"t,q1,q2\n0,1,\n", "a.csv:2: column q2: \"\" is not a finite number"},
      {"t,q1,q2\n0,nan,2\n", "a.csv:2: column q1: \"nan\" is not a finite number"},
      {"t,q1,q2\n0,1,-inf\n", "a.csv:2: column q2: \"-inf\" is not a finite number"},
      {"t,q1,q2\n0,1e999,2\n", "a.csv:2: column q1: \"1e999\" is not a finite number"},
      {"t,q1,q2\n0,1 2,2\n", "a.csv:2: column q1: \"1 2\" is not a finite number"},
      {"t,q1,q2\n0,0x1,2\n", "a.csv:2: column q1: \"0x1\" is not a finite number"},
      {"t,q1,q2\n0,+-1,2\n", "a.csv:2: column q1: \"+-1\" is not a finite number"},
      {"t,q1,q2,m,rx,ry,rz\n0,1,2,3,4,5,?\n", "a.csv:2: column rz: \"?\" is not a finite number"},
      {"t,q1,q2\n0,1,2\n1,1,2\n0.5,1,2\n", "a.csv:4: column t: time does not increase from the row before"},
  }));
  CAPTURE(wrong.text);
  std::string message;
  try {
    parse(wrong.text);
  } catch (const LogError& error) {
    message = error.what();
  }
  CHECK(message == wrong.message);
}

TEST_CASE("parse_log: a row with the time stamp of the row before is left out, and counted", "[log_reader]") {
  const auto log = rme::examples::parse_log<2>("t,q1,q2\n0,1,2\n0,1,3\n0,1,4\n1,5,6\n", "a.csv");
  REQUIRE(log.size() == 2);
  CHECK(log.q[0] == Eigen::Vector2d(1, 2));
  CHECK(log.q[1] == Eigen::Vector2d(5, 6));
  CHECK(log.same_instant == 2);
}

TEST_CASE("parse_log: numbers mean the same where the decimal sign is a comma", "[log_reader]") {
  // A hand-made locale, since no other than "C" is sure to be on the machine. It reaches streams, not strtod.
  struct DecimalComma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
  };
  const std::locale before = std::locale::global(std::locale(std::locale(), new DecimalComma));
  const Log<2> log = parse("t,q1,q2\n0.25,1.5,2.5\n");
  std::locale::global(before);
  CHECK(log.t == std::vector<double>{0.25});
  CHECK(log.q[0] == Eigen::Vector2d(1.5, 2.5));
}

TEST_CASE("read_log: gzip is recognised by its content, not by the file's name", "[log_reader]") {
  for (const bool compressed : {false, true}) {
    CAPTURE(compressed);
    const TemporaryFile file(compressed ? "content_gzip.csv" : "content_plain.csv.gz",
                             compressed ? gzipped : "t,q1,q2\n0,1,2\n1,3,4\n");
    const Log<2> log = read_log<2>(file.name);
    CHECK(log.name == file.name);
    CHECK(log.t == std::vector<double>{0, 1});
    REQUIRE(log.q.size() == 2);
    CHECK(log.q[0] == Eigen::Vector2d(1, 2));
    CHECK(log.q[1] == Eigen::Vector2d(3, 4));
  }
}

TEST_CASE("read_log: gzip data cut short anywhere are refused", "[log_reader]") {
  // Below two bytes nothing tells that it was gzip, and it is no log either.
  for (std::size_t size = 2; size < gzipped.size(); ++size) {
    CAPTURE(size);
    const TemporaryFile file("truncated.csv.gz", gzipped.substr(0, size));
    CHECK_THROWS_WITH(read_log<2>(file.name), "truncated.csv.gz: the gzip data are cut short");
  }
}

TEST_CASE("read_log: gzip data with any byte of the content or checksum flipped are refused", "[log_reader]") {
  constexpr std::size_t header = 10;  // method, flags, time, system: not covered by the checksum
  for (std::size_t at = header; at < gzipped.size(); ++at) {
    CAPTURE(at);
    std::string damaged = gzipped;
    damaged[at] = static_cast<char>(~damaged[at]);
    const TemporaryFile file("damaged.csv.gz", damaged);
    CHECK_THROWS_WITH(read_log<2>(file.name), contains("the gzip data are"));
  }
}

TEST_CASE("read_log: a file that cannot be opened or is a folder is named with the reason", "[log_reader]") {
  CHECK_THROWS_WITH(read_log("no_such_file.csv"), "no_such_file.csv: cannot be opened: No such file or directory");
  CHECK_THROWS_WITH(read_log("."), ".: cannot be read: Is a directory");
}

TEST_CASE("require_external_torque: says which columns are missing", "[log_reader]") {
  using rme::examples::require_external_torque;
  CHECK_NOTHROW(require_external_torque(parse("t,q1,q2,tau_ext1,tau_ext2\n0,1,2,3,4\n")));
  CHECK_NOTHROW(require_external_torque(parse("t,q1,q2,tau1,tau2,dq1,dq2\n0,1,2,3,4,5,6\n")));
  CHECK_THROWS_WITH(require_external_torque(parse("t,q1,q2,dq1,dq2\n0,1,2,3,4\n")),
                    contains("a.csv:1: columns tau_ext1..tau_ext2 are missing"));
  CHECK_THROWS_WITH(require_external_torque(parse("t,q1,q2,tau1,tau2\n0,1,2,3,4\n")),
                    contains("a.csv:1: columns dq1..dq2 are missing"));
}

}  // namespace
