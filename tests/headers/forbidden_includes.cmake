# Headers do no I/O and know no clocks, threads or files; only the JSON headers may see nlohmann-json.
cmake_minimum_required(VERSION 3.22)
set(forbidden
    "iostream|istream|ostream|fstream|cstdio|stdio\\.h|thread|mutex|shared_mutex|condition_variable|future|chrono|ctime|time\\.h|filesystem|unistd\\.h"
)
file(GLOB_RECURSE headers RELATIVE ${INCLUDE} ${INCLUDE}/*.hpp)
foreach(header IN LISTS headers)
  file(STRINGS ${INCLUDE}/${header} lines REGEX "^[ \t]*#[ \t]*include")
  foreach(line IN LISTS lines)
    if(line MATCHES "[<\"](${forbidden})[>\"]" OR (line MATCHES "nlohmann" AND NOT header MATCHES "json\\.hpp$"))
      message(SEND_ERROR "${header}: ${line}")
    endif()
  endforeach()
endforeach()
