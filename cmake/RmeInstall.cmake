# Installs the headers and the package files. rme::json has its own export set, so that rme::rme loads without nlohmann-json.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(rme_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/rme)

install(DIRECTORY include/rme DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp")
install(TARGETS rme EXPORT rmeTargets)
install(EXPORT rmeTargets NAMESPACE rme:: DESTINATION ${rme_package_dir})
if(RME_WITH_JSON)
  install(TARGETS rme_json EXPORT rmeJsonTargets)
  install(EXPORT rmeJsonTargets NAMESPACE rme:: DESTINATION ${rme_package_dir})
endif()

configure_package_config_file(cmake/rmeConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/rmeConfig.cmake
                              INSTALL_DESTINATION ${rme_package_dir})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/rmeConfigVersion.cmake COMPATIBILITY SameMajorVersion
                                 ARCH_INDEPENDENT)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/rmeConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/rmeConfigVersion.cmake
        DESTINATION ${rme_package_dir})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/rme)
