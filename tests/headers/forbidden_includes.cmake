# Headers do no I/O and know no clocks, threads or files; only the JSON headers may see nlohmann-json. Core includes core
# alone. Control and the estimator, with all that this is made of, do not include each other. The hosts' headers are included
# by rme.hpp and by each other alone; only the two that need a robot's library may see it.
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
    if((line MATCHES "<franka/" AND NOT header STREQUAL rme/host/franka.hpp)
       OR (line MATCHES "<pinocchio/" AND NOT header STREQUAL rme/host/pinocchio.hpp))
      message(SEND_ERROR "${header}: ${line}")
    endif()
    if((header MATCHES "^rme/core/" AND line MATCHES "<rme/" AND NOT line MATCHES "<rme/core/")
       OR (header MATCHES "^rme/control/" AND line MATCHES "<rme/" AND NOT line MATCHES "<rme/(core|control)/")
       OR (NOT header MATCHES "^rme/(host/|rme\\.hpp)" AND line MATCHES "<rme/host/")
       OR (header MATCHES "^rme/(sensing|network|inference|tracking|published|estimator|runtime)" AND line MATCHES "<rme/control/"))
      message(SEND_ERROR "${header}, against the arrows: ${line}")
    endif()
  endforeach()
endforeach()
