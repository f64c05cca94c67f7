#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "log_format/log_format.hpp"
#include "support/catch.hpp"
#include "support/program.hpp"

namespace {

using namespace rme::examples;
using rme::testing::TemporaryFile;
using Strings = std::vector<std::string>;

const Strings kJoints = {"shoulder", "elbow"};

std::vector<std::string_view> split(const std::string& header) {
  std::vector<std::string_view> names;
  for (std::size_t begin = 0, end = 0; begin <= header.size(); begin = end + 1) {
    end = std::min(header.find(',', begin), header.size());
    names.push_back(std::string_view(header).substr(begin, end - begin));
  }
  return names;
}

ColumnLayout layout(const std::string& header, const std::string& given = "") {
  return column_layout(split(header), "a.csv", kJoints, given);
}

Strings names(const std::vector<LogColumn>& columns) {
  Strings out;
  for (const LogColumn& c : columns) out.push_back(c.name);
  return out;
}

TEST_CASE("column_layout: the columns of common recorders are found", "[log_format]") {
  struct Case {
    const char* header;
    Strings t, q, dq, tau;
    double unit;  // of t [s]
  };
  const auto known = GENERATE(values<Case>({
      {"t,q1,q2,dq1,dq2,tau1,tau2", {"t"}, {"q1", "q2"}, {"dq1", "dq2"}, {"tau1", "tau2"}, 1},
      {"t,q0,q1,dq0,dq1,tau0,tau1", {"t"}, {"q0", "q1"}, {"dq0", "dq1"}, {"tau0", "tau1"}, 1},
      {"%time,field.header.seq,field.name0,field.name1,field.position0,field.position1,field.velocity0,"
       "field.velocity1,field.effort0,field.effort1",
       {"%time"},
       {"field.position0", "field.position1"},
       {"field.velocity0", "field.velocity1"},
       {"field.effort0", "field.effort1"},
       1e-9},
      // PlotJuggler names joints in the message's order, which is the alphabet's.
      {"__time,/joint_states/elbow/effort,/joint_states/elbow/position,/joint_states/elbow/velocity,"
       "/joint_states/shoulder/effort,/joint_states/shoulder/position,/joint_states/shoulder/velocity",
       {"__time"},
       {"/joint_states/shoulder/position", "/joint_states/elbow/position"},
       {"/joint_states/shoulder/velocity", "/joint_states/elbow/velocity"},
       {"/joint_states/shoulder/effort", "/joint_states/elbow/effort"},
       1},
      {"header.stamp.sec,header.stamp.nanosec,position_0,position_1,velocity_0,velocity_1,effort_0,effort_1",
       {"header.stamp.sec", "header.stamp.nanosec"},
       {"position_0", "position_1"},
       {"velocity_0", "velocity_1"},
       {"effort_0", "effort_1"},
       1},
      {"timestamp,target_q_0,target_q_1,actual_q_0,actual_q_1,actual_qd_0,actual_qd_1,actual_current_0,actual_current_"
       "1",
       {"timestamp"},
       {"actual_q_0", "actual_q_1"},
       {"actual_qd_0", "actual_qd_1"},
       {"actual_current_0", "actual_current_1"},
       1},
      {"duration,success_rate,state.q[0],state.q[1],state.dq[0],state.dq[1],state.tau_J[0],state.tau_J[1]",
       {"duration"},
       {"state.q[0]", "state.q[1]"},
       {"state.dq[0]", "state.dq[1]"},
       {"state.tau_J[0]", "state.tau_J[1]"},
       1e-3},
  }));
  CAPTURE(known.header);
  const LogColumns columns = layout(known.header).columns;
  CHECK(names(columns.t) == known.t);
  CHECK(columns.t[0].factor == known.unit);
  CHECK(names(columns.q) == known.q);
  CHECK(names(columns.dq) == known.dq);
  CHECK(names(columns.tau) == known.tau);
  CHECK(columns.tau_ext.empty());
}

TEST_CASE("column_layout: --columns maps names, units, signs, zeros and orders", "[log_format]") {
  const std::string header = "clock,a-1,a-2,b1,b2,c1,c2";
  const LogColumns columns = layout(header, "t=0.001*clock,q=0.5*a-*,dq=none,tau=b*,q2=-a-1+1.5,tau1=-2*b2").columns;
  CHECK(names(columns.t) == Strings{"clock"});
  CHECK(columns.t[0].factor == 0.001);
  CHECK(names(columns.q) == Strings{"a-1", "a-1"});
  CHECK(columns.q[0].factor == 0.5);
  CHECK(columns.q[1].factor == -1);
  CHECK(columns.q[1].offset == 1.5);
  CHECK(columns.dq.empty());
  CHECK(names(columns.tau) == Strings{"b2", "b2"});
  CHECK(columns.tau[0].factor == -2);
}

TEST_CASE("column_layout: what is missing or wrong is named, with what there is", "[log_format]") {
  const auto message = [](const std::string& header, const std::string& given) -> std::string {
    try {
      layout(header, given);
    } catch (const LogError& error) {
      return error.what();
    }
    return "";
  };
  CHECK(message("x,q1,q2", "") ==
        "a.csv:1: column t is missing: --columns t=NAME says which one has the time; the file has x, q1, q2");
  CHECK_THAT(message("t,q1", ""), contains("columns q1..q2 are missing: --columns 'q=NAME*'") && contains("has t, q1"));
  CHECK_THAT(message("t,q1,q2,q3", ""), contains("columns q1..q2 are missing"));  // another arm's
  CHECK_THAT(message("t,q1,q2", "q"), contains("--columns: \"q\": must be KEY=NAME"));
  CHECK_THAT(message("t,q1,q2", "q=p*"), contains("\"q=p*\": there are no 2 columns of this name"));
  CHECK_THAT(message("t,q1,q2", "q=q1"), contains("\"q=q1\": needs a * in place of the joint's number"));
  CHECK_THAT(message("t,q1,q2", "q3=q1"), contains("\"q3=q1\": the arm has joints 1 to 2"));
  CHECK_THAT(message("t,q1,q2", "q1=z"), contains("\"q1=z\": there is no column z"));
  CHECK_THAT(message("t,q1,q2", "p=q*"), contains("\"p\" is none of t, q, dq, tau, tau_ext"));
  CHECK_THAT(message("t,q1,q2,a1,a2", "dq2=a2"), contains("--columns: dq1 is missing"));
}

TEST_CASE("zero_phase_derivative: neither delay nor uneven steps show", "[log_format]") {
  std::vector<double> t;
  std::vector<Eigen::Vector2d> q;
  for (int i = 0; i < 200; ++i) {
    t.push_back(0.01 * i + (i % 3) * 0.002);  // uneven
    q.emplace_back(std::sin(2 * t.back()), std::cos(2 * t.back()));
  }
  const auto dq = zero_phase_derivative(t, q);
  // The third derivative is 8 at most: in windows of 25 ms, a quadratic's slope is off by up to 8 / 6 * 0.6 * 0.03^2.
  for (std::size_t i = 5; i + 5 < t.size(); ++i) {
    CHECK(dq[i][0] == Approx(2 * std::cos(2 * t[i])).margin(1e-3));
    CHECK(dq[i][1] == Approx(-2 * std::sin(2 * t[i])).margin(1e-3));
  }
}

/// Four joints, since no fewer are compiled.
std::string four_joints(const std::string& header, double first, double step, double unit, bool wrapped) {
  std::string text = header + '\n';
  for (int i = 0; i < 200; ++i) {
    const double angle = 2 + 0.01 * i * (wrapped ? 2 : 0.1);
    const double shown = wrapped ? std::remainder(angle, 2 * 3.141592653589793) : angle;
    text += std::to_string(first + i * step);
    for (int j = 0; j < 4; ++j) text += ' ' + std::to_string(unit * shown);
    for (int j = 0; j < 4; ++j) text += ' ' + std::to_string(i);
    text += '\n';
  }
  return text;
}

TEST_CASE("read_formatted_log: calendars, degrees, turns, missing dq and late torque are put right", "[log_format]") {
  const std::string header = "timestamp actual_q_0 actual_q_1 actual_q_2 actual_q_3 tau_0 tau_1 tau_2 tau_3";
  const Strings joints = {"a", "b", "c", "d"};
  const double degree = 180 / 3.141592653589793;
  const TemporaryFile file("rtde.csv", four_joints(header, 1.7e9, 0.01, degree, true));
  LogFormat format;
  format.degrees = true;
  const FormattedLog<4> read = read_formatted_log<4>(file.name, format, joints);
  CHECK(read.differentiated);
  CHECK(read.log.t.front() == 0);
  CHECK(read.log.t.back() == Approx(1.99).margin(1e-5));
  // From 2 rad on with 2 rad/s: the jump at pi is undone.
  CHECK(read.log.q.back()[0] == Approx(2 + 1.99 * 2).margin(1e-4));
  for (std::size_t i = 0; i < 200; ++i) CHECK(read.log.dq[i][3] == Approx(2).margin(1e-3));
  std::string notes;
  for (const std::string& note : read.notes) notes += note + '\n';
  CHECK_THAT(notes, contains("q is actual_q_0 .. actual_q_3") && contains("t counts from the first row") &&
                        contains("q jumps by a whole turn 4 times: undone") &&
                        contains("dq is not in the log: it is the derivative of q"));

  const TemporaryFile late("late.csv", four_joints(header, 5, 0.01, 1, false));
  LogFormat delayed;
  delayed.torque_delay = 0.025;  // two and a half rows
  const FormattedLog<4> advanced = read_formatted_log<4>(late.name, delayed, joints);
  CHECK(advanced.log.t.front() == 5);
  CHECK(advanced.log.tau.front()[0] == Approx(2.5));
  CHECK(advanced.log.tau[100][2] == Approx(102.5));
  delayed.torque_delay = 3;
  CHECK_THROWS_WITH(read_formatted_log<4>(late.name, delayed, joints), contains("lasts less than --torque-delay"));
}

TEST_CASE("read_formatted_log: a calendar's nanoseconds are seconds from the first row on", "[log_format]") {
  std::string text = "t,q1,q2,q3,q4\n";
  for (int i = 0; i < 5; ++i) text += std::to_string(1700000000000000000 + i * 10000000LL) + ",1,1,1,1\n";
  const TemporaryFile file("nano.csv", text);
  const FormattedLog<4> read = read_formatted_log<4>(file.name, LogFormat(), {"a", "b", "c", "d"});
  CHECK(read.log.t.back() == Approx(0.04).margin(1e-6));
}

}  // namespace
