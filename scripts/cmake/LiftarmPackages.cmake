# Header-only packages, staged: one link per package in the build tree. find_package() does not find them
# under the Emscripten toolchain, and searching /usr/include would bring in the machine's own libc headers.

function(liftarm_header_package target marker folder)
  find_path(${target}_ROOT "${marker}" PATHS ${ARGN} NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH REQUIRED)
  set(stage "${CMAKE_BINARY_DIR}/staged/${target}")
  file(MAKE_DIRECTORY "${stage}")
  file(CREATE_LINK "${${target}_ROOT}/${folder}" "${stage}/${folder}" SYMBOLIC)
  add_library(${target} INTERFACE)
  target_include_directories(${target} SYSTEM INTERFACE "$<BUILD_INTERFACE:${stage}>")
endfunction()

liftarm_header_package(liftarm_eigen Eigen/Core Eigen /usr/include/eigen3 /usr/local/include/eigen3)
liftarm_header_package(liftarm_json nlohmann/json.hpp nlohmann /usr/include /usr/local/include)
if(NOT EMSCRIPTEN)
  liftarm_header_package(liftarm_cli11 CLI/CLI.hpp CLI /usr/include /usr/local/include)
endif()
