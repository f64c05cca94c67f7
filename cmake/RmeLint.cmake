# Targets format, format-check, tidy and cppcheck, and the ctest lint.format. Included where every program is already defined.
file(GLOB_RECURSE rme_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/include/*.hpp ${PROJECT_SOURCE_DIR}/examples/*.[ch]pp
     ${PROJECT_SOURCE_DIR}/tests/*.[ch]pp)

# Other versions of clang-format break some lines elsewhere, so that only this one may complain.
set(rme_clang_version 14)
find_program(RME_CLANG_FORMAT NAMES clang-format-${rme_clang_version} DOC "clang-format for format-check and lint.format")
if(RME_CLANG_FORMAT)
  add_custom_target(format COMMAND ${RME_CLANG_FORMAT} -i ${rme_sources} VERBATIM)
  add_custom_target(format-check COMMAND ${RME_CLANG_FORMAT} --dry-run --Werror ${rme_sources} VERBATIM)
  add_test(NAME lint.format COMMAND ${RME_CLANG_FORMAT} --dry-run --Werror ${rme_sources})
else()
  rme_add_skipped_test(lint.format clang-format-${rme_clang_version})
endif()

# Takes minutes, so it is a target and no test. clang-tidy cannot read g++'s precompiled header, hence a configuration
# of its own; nothing but generated sources is built there.
find_program(RME_RUN_CLANG_TIDY NAMES run-clang-tidy-${rme_clang_version} DOC "clang-tidy for target tidy")
if(RME_RUN_CLANG_TIDY)
  set(rme_tidy_dir ${PROJECT_BINARY_DIR}/tidy)
  if(TARGET generated_sources)
    set(rme_tidy_sources COMMAND ${CMAKE_COMMAND} --build ${rme_tidy_dir} --target generated_sources)
  endif()
  add_custom_target(
    tidy
    COMMAND ${CMAKE_COMMAND} -S ${PROJECT_SOURCE_DIR} -B ${rme_tidy_dir} -G ${CMAKE_GENERATOR} -DRME_WITH_JSON=${RME_WITH_JSON}
            -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON
    ${rme_tidy_sources}
    COMMAND ${RME_RUN_CLANG_TIDY} -quiet -p ${rme_tidy_dir}
    VERBATIM USES_TERMINAL)
endif()

# Half a minute.
find_program(RME_CPPCHECK cppcheck DOC "cppcheck for target cppcheck")
if(RME_CPPCHECK)
  add_custom_target(
    cppcheck
    COMMAND ${RME_CPPCHECK} --enable=warning,performance,portability --language=c++ --std=c++17 --quiet --error-exitcode=1
            --suppressions-list=${PROJECT_SOURCE_DIR}/cmake/cppcheck_suppressions.txt -I ${PROJECT_SOURCE_DIR}/include
            -I ${PROJECT_SOURCE_DIR}/examples ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/examples
    VERBATIM USES_TERMINAL)
endif()
