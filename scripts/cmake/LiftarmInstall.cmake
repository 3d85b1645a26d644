# `cmake --install build/native --prefix DIR`: the command, the libraries with their headers, and a package
# that find_package(liftarm) finds. A program links liftarm::liftarm (core/design/solve.h is its door).

set(LIFTARM_LIBRARIES base lattice parts sketch gears guide mechanisms model layout analysis objective instructions
                      search rivals exporters design)

# The targets that are exported: the folders, what all of them use, and one name for the whole.
function(liftarm_export)
  add_library(liftarm_library INTERFACE)
  target_link_libraries(liftarm_library INTERFACE liftarm_design)
  # Whoever builds against the installation has these packages from elsewhere (liftarmConfig.cmake).
  target_link_libraries(liftarm_eigen INTERFACE "$<INSTALL_INTERFACE:Eigen3::Eigen>")
  target_link_libraries(liftarm_json INTERFACE "$<INSTALL_INTERFACE:nlohmann_json::nlohmann_json>")
  target_compile_features(liftarm_options INTERFACE cxx_std_20)
  set(targets liftarm_library liftarm_options liftarm_eigen liftarm_json)
  foreach(folder IN LISTS LIFTARM_LIBRARIES)
    set_target_properties(liftarm_${folder} PROPERTIES EXPORT_NAME ${folder})
    list(APPEND targets liftarm_${folder})
  endforeach()
  set_target_properties(liftarm_library PROPERTIES EXPORT_NAME liftarm)
  install(TARGETS ${targets} EXPORT liftarmTargets ARCHIVE DESTINATION lib)
  install(EXPORT liftarmTargets NAMESPACE liftarm:: DESTINATION lib/cmake/liftarm)
endfunction()

function(liftarm_install)
  include(CMakePackageConfigHelpers)
  liftarm_export()
  install(TARGETS liftarm RUNTIME DESTINATION bin)
  foreach(folder IN LISTS LIFTARM_LIBRARIES)
    install(DIRECTORY "${CMAKE_SOURCE_DIR}/core/${folder}" DESTINATION include/liftarm FILES_MATCHING PATTERN "*.h")
  endforeach()
  configure_package_config_file("${CMAKE_SOURCE_DIR}/scripts/cmake/liftarmConfig.cmake.in"
                                "${CMAKE_BINARY_DIR}/liftarmConfig.cmake" INSTALL_DESTINATION lib/cmake/liftarm)
  write_basic_package_version_file("${CMAKE_BINARY_DIR}/liftarmConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
  install(FILES "${CMAKE_BINARY_DIR}/liftarmConfig.cmake" "${CMAKE_BINARY_DIR}/liftarmConfigVersion.cmake"
          DESTINATION lib/cmake/liftarm)
  install(FILES "${CMAKE_SOURCE_DIR}/LICENSE" "${CMAKE_SOURCE_DIR}/NOTICE" DESTINATION share/doc/liftarm)
endfunction()
