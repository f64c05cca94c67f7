# What rme's own programs and tests are built with. Nothing here reaches a user of rme::rme.
if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
set(CMAKE_CXX_EXTENSIONS OFF)  # names the standard on every command line, which clang-tidy needs as well
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

add_library(rme_development INTERFACE)
target_compile_features(rme_development INTERFACE cxx_std_17)
target_compile_options(rme_development INTERFACE -Wall -Wextra -Wconversion -Wshadow -Werror)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  add_compile_options(--param=ggc-min-heapsize=500000)  # [KiB]: g++ collects garbage later; saves a twentieth
endif()

add_compile_options(-fPIC)  # one object is good for a program and for a Python module; it is no slower

# The numbers of joints for which programs are compiled, from one to another. An instrumented build shows nothing more of
# five of them than of two.
set(rme_joint_counts 4 5 6 7 8)
if(RME_SANITIZED)
  set(rme_joint_counts 6 7)
  target_compile_definitions(rme_development INTERFACE RME_JOINT_COUNTS=6,7)
endif()

# rme_hot(FILE...): where the time of programs is spent. An instrumented build, which compiles everything else without
# optimisation, optimises these.
function(rme_hot)
  if(RME_SANITIZED)
    set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS -O1 SKIP_PRECOMPILE_HEADERS ON)
  endif()
endfunction()

# rme_add_example(NAME SOURCE...): an example program. The global property RME_EXAMPLES lists all of them.
function(rme_add_example name)
  add_executable(${name} ${ARGN})
  target_link_libraries(${name} PRIVATE rme_precompiled)
  target_precompile_headers(${name} REUSE_FROM rme_precompiled)
  set_property(GLOBAL APPEND PROPERTY RME_EXAMPLES ${name})
endfunction()

# Folders whose tests are those of include/rme.
set(rme_core_folders core sensing inference tracking network published control estimator host robustness)

# rme_add_test(FILE [NUMBERS] [LIBRARY...]): one Catch2 program from tests/<folder>/test_<header>.cpp; each test case becomes a
# ctest with the program's name as its label. Target tests_<folder> builds the folder's programs. Tests of include/rme are
# labelled core:<program>; target tests_core builds them, and `ctest -L core` runs them. NUMBERS: it compares numbers alone,
# and what it calls runs under the sanitizers in other tests, so that their build leaves it out.
function(rme_add_test file)
  if("NUMBERS" IN_LIST ARGN AND RME_SANITIZED)
    return()
  endif()
  list(REMOVE_ITEM ARGN NUMBERS)
  get_filename_component(name ${file} NAME_WE)
  get_filename_component(folder ${CMAKE_CURRENT_SOURCE_DIR} NAME)
  set(target ${folder}_${name})
  add_executable(${target} ${file})
  target_link_libraries(${target} PRIVATE rme::rme rme_development rme_test_main ${ARGN})
  target_precompile_headers(${target} REUSE_FROM rme_test_main)
  # ctest splits a name at a semicolon, and then no case has that name.
  file(READ ${file} text)
  if(text MATCHES "TEST_CASE[A-Z_]*\\([ \n]*(\"[^\"]*\"[ \n]*)*\"[^\"\n]*;[^\n]*")
    message(FATAL_ERROR "${CMAKE_CURRENT_SOURCE_DIR}/${file}: a semicolon in a test case's name: ${CMAKE_MATCH_0}")
  endif()
  if(Catch2_VERSION VERSION_LESS 3)
    set(strict EXTRA_ARGS -w NoTests)
  endif()
  set(label ${target})
  set(groups tests_${folder})
  if(folder IN_LIST rme_core_folders)
    set(label core:${target})
    list(APPEND groups tests_core)
  endif()
  catch_discover_tests(${target} TEST_PREFIX "${folder}: " ${strict} PROPERTIES TIMEOUT 600 LABELS ${label})
  foreach(group IN LISTS groups)
    if(NOT TARGET ${group})
      add_custom_target(${group})
    endif()
    add_dependencies(${group} ${target})
  endforeach()
endfunction()

# rme_add_skipped_test(NAME PACKAGE...): a test in place of those that cannot run here, since packages (Debian's names) are
# missing. tests/run.sh reads the packages from its output.
function(rme_add_skipped_test name)
  list(JOIN ARGN " " packages)
  add_test(NAME ${name} COMMAND ${CMAKE_COMMAND} -E echo "skipped: needs ${packages}")
  set_tests_properties(${name} PROPERTIES SKIP_REGULAR_EXPRESSION "skipped: needs")
endfunction()

# rme_extract_snippet(DOCUMENT NAME OUTPUT): the code block after "<!-- snippet: NAME -->" in a Markdown file, so that what
# a reader copies is what the tests build. Reconfigures when the document changes.
function(rme_extract_snippet document name output)
  file(READ ${document} text)
  string(FIND "${text}" "<!-- snippet: ${name} -->" at)
  if(at EQUAL -1)
    message(FATAL_ERROR "${document} has no snippet ${name}")
  endif()
  string(SUBSTRING "${text}" ${at} -1 text)
  string(REGEX MATCH "^[^\n]*\n```[a-z]+\n" head "${text}")
  string(LENGTH "${head}" begin)
  string(SUBSTRING "${text}" ${begin} -1 text)
  string(FIND "${text}" "\n```" end)
  if(begin EQUAL 0 OR end EQUAL -1)
    message(FATAL_ERROR "${document}: snippet ${name} is not followed by a code block")
  endif()
  string(SUBSTRING "${text}" 0 ${end} text)
  file(CONFIGURE OUTPUT ${output} CONTENT "${text}\n" @ONLY)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${document})
endfunction()
