#pragma once
/// Finds the columns of a log by the names that common recorders give them.
#include <string>
#include <string_view>
#include <vector>

#include "io/log_reader.hpp"

namespace rme::examples {

/// Where a file has its quantities, and what was taken for granted to find them.
struct ColumnLayout {
  LogColumns columns;
  std::vector<std::string> notes;  ///< for the user, a sentence each; none for the columns of docs/conventions.md
};

/// Recognises the columns of docs/conventions.md. Others that it knows: those of ROS joint_states (rostopic echo -p,
/// PlotJuggler, with or without names of joints), of UR's RTDE recorder and of libfranka's log. Joints may be numbered
/// from 0 or from 1.
/// @param header  names of the file's columns
/// @param file    name of the file, for messages
/// @param joints  names of the arm's joints, from the base on
/// @param given   the value of --columns, which goes before what is recognised:
///
///     KEY=[FACTOR*][-]NAME[+OFFSET],...
///
///   KEY is t, q, dq, tau or tau_ext, with a '*' in NAME for the joint's number, or it is a single joint's, such as q3.
///   The number is factor times the cell, plus the offset. NAME "none": the file's columns are not used.
/// @throws LogError naming what is missing, and the columns that there are; or the item of `given` that is wrong
ColumnLayout column_layout(const std::vector<std::string_view>& header, const std::string& file,
                           const std::vector<std::string>& joints, const std::string& given);

}  // namespace rme::examples
