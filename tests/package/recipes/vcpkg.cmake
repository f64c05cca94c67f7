# Runs the vcpkg port with stand-ins for vcpkg's functions, which do what vcpkg's do, as far as rme uses them.
cmake_minimum_required(VERSION 3.22)
set(PORT rme)
set(CURRENT_PORT_DIR ${SOURCE}/cmake/packaging/vcpkg/rme)
set(CURRENT_PACKAGES_DIR ${STAGE}/packages)
file(REMOVE_RECURSE ${STAGE})

function(vcpkg_check_features)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "OUT_FEATURE_OPTIONS" "FEATURES")
  list(GET arg_FEATURES 1 option)
  set(${arg_OUT_FEATURE_OPTIONS} -D${option}=ON PARENT_SCOPE)
endfunction()
function(vcpkg_cmake_configure)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "SOURCE_PATH" "OPTIONS")
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${arg_SOURCE_PATH} -B ${STAGE}/build -DCMAKE_CXX_COMPILER=${CXX}
                          -DCMAKE_INSTALL_LIBDIR=lib -DCMAKE_BUILD_TYPE=Release ${arg_OPTIONS}
                  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endfunction()
function(vcpkg_cmake_install)
  execute_process(COMMAND ${CMAKE_COMMAND} --install ${STAGE}/build --prefix ${CURRENT_PACKAGES_DIR} OUTPUT_QUIET
                          COMMAND_ERROR_IS_FATAL ANY)
endfunction()
function(vcpkg_cmake_config_fixup)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "PACKAGE_NAME;CONFIG_PATH" "")
  file(GLOB files ${CURRENT_PACKAGES_DIR}/${arg_CONFIG_PATH}/*.cmake)
  file(MAKE_DIRECTORY ${CURRENT_PACKAGES_DIR}/share/${arg_PACKAGE_NAME})
  foreach(file IN LISTS files)  # two folders up from share/rme, where it was three from lib/cmake/rme
    file(READ ${file} text)
    string(REPLACE "/../../../\"" "/../../\"" text "${text}")
    string(REPLACE [[get_filename_component(_IMPORT_PREFIX "${_IMPORT_PREFIX}" PATH)
get_filename_component(_IMPORT_PREFIX "${_IMPORT_PREFIX}" PATH)
get_filename_component(_IMPORT_PREFIX "${_IMPORT_PREFIX}" PATH)]]
                   [[get_filename_component(_IMPORT_PREFIX "${_IMPORT_PREFIX}" PATH)
get_filename_component(_IMPORT_PREFIX "${_IMPORT_PREFIX}" PATH)]] text "${text}")
    get_filename_component(name ${file} NAME)
    file(WRITE ${CURRENT_PACKAGES_DIR}/share/${arg_PACKAGE_NAME}/${name} "${text}")
  endforeach()
endfunction()
function(vcpkg_install_copyright)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "" "FILE_LIST")
  configure_file(${arg_FILE_LIST} ${CURRENT_PACKAGES_DIR}/share/${PORT}/copyright COPYONLY)
endfunction()

include(${CURRENT_PORT_DIR}/portfile.cmake)

file(GLOB_RECURSE headers RELATIVE ${SOURCE}/include ${SOURCE}/include/*.hpp)
file(GLOB_RECURSE installed RELATIVE ${CURRENT_PACKAGES_DIR} ${CURRENT_PACKAGES_DIR}/*)
list(TRANSFORM headers PREPEND include/)
set(files rmeConfig.cmake rmeConfigVersion.cmake rmeTargets.cmake rmeJsonTargets.cmake usage copyright)
list(TRANSFORM files PREPEND share/rme/)
foreach(file IN LISTS headers files)
  if(NOT file IN_LIST installed)
    message(SEND_ERROR "the port does not install ${file}")
  endif()
  list(REMOVE_ITEM installed ${file})
endforeach()
if(installed)
  message(SEND_ERROR "the port installs what no package should hold: ${installed}")
endif()

execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE}/cmake/packaging/conan/test_package -B ${STAGE}/consumer
                        -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_PREFIX_PATH=${CURRENT_PACKAGES_DIR} -DEigen3_DIR=${EIGEN3_DIR}
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
