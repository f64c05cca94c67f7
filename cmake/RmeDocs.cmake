# Target docs_html: the headers, README and docs/ as HTML, with docs/README.md as the main page; a warning of Doxygen's is an
# error. No LaTeX, no graphviz: formulas are plain text.
find_package(Doxygen 1.9 QUIET)
if(DOXYGEN_FOUND)
  set(DOXYGEN_PROJECT_BRIEF "${PROJECT_DESCRIPTION}")
  set(DOXYGEN_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/docs)
  set(DOXYGEN_USE_MDFILE_AS_MAINPAGE ${PROJECT_SOURCE_DIR}/docs/README.md)
  set(DOXYGEN_STRIP_FROM_PATH ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR})
  set(DOXYGEN_IMAGE_PATH ${PROJECT_SOURCE_DIR}/docs)
  set(DOXYGEN_FILE_PATTERNS *.hpp *.md)
  set(DOXYGEN_EXCLUDE_SYMBOLS rme::detail)
  set(DOXYGEN_JAVADOC_AUTOBRIEF YES)  # a class is introduced by its first sentence
  set(DOXYGEN_BUILTIN_STL_SUPPORT YES)
  set(DOXYGEN_HAVE_DOT NO)
  set(DOXYGEN_QUIET YES)
  set(DOXYGEN_WARN_IF_UNDOCUMENTED YES)
  set(DOXYGEN_WARN_IF_INCOMPLETE_DOC YES)  # whoever describes one parameter describes all
  set(DOXYGEN_WARN_AS_ERROR FAIL_ON_WARNINGS)
  doxygen_add_docs(docs_html ${PROJECT_SOURCE_DIR}/include/rme ${PROJECT_SOURCE_DIR}/docs ${PROJECT_SOURCE_DIR}/README.md)
  add_test(NAME docs.doxygen COMMAND ${CMAKE_COMMAND} --build ${PROJECT_BINARY_DIR} --target docs_html)
else()
  rme_add_skipped_test(docs.doxygen doxygen)
endif()
