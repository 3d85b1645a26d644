# One target per folder of core/: liftarm_<folder>. Sources are globbed, so a new file needs no edit here.

# liftarm_folder(<folder> [<folder it builds on>...])
function(liftarm_folder folder)
  set(target "liftarm_${folder}")
  file(GLOB sources CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/core/${folder}/*.cpp")
  list(TRANSFORM ARGN PREPEND liftarm_)
  set(uses liftarm_options liftarm_eigen liftarm_json ${ARGN})
  if(sources)
    add_library(${target} STATIC ${sources})
    target_link_libraries(${target} PUBLIC ${uses})
  else()
    add_library(${target} INTERFACE)
    target_link_libraries(${target} INTERFACE ${uses})
  endif()
endfunction()

# Folders that the WebAssembly module goes without, for the sake of its first load: it links what is in
# core/<folder>/absent/ in their place. A module that links liftarm_<folder>_whole has them all the same: objects
# win over what archives hold.
function(liftarm_absent_in_wasm)
  if(EMSCRIPTEN)
    foreach(folder IN LISTS ARGN)
      get_target_property(sources liftarm_${folder} SOURCES)
      get_target_property(uses liftarm_${folder} LINK_LIBRARIES)
      add_library(liftarm_${folder}_whole OBJECT ${sources})
      target_link_libraries(liftarm_${folder}_whole PUBLIC ${uses})
      file(GLOB stand_ins CONFIGURE_DEPENDS "${CMAKE_SOURCE_DIR}/core/${folder}/absent/*.cpp")
      set_property(TARGET liftarm_${folder} PROPERTY SOURCES ${stand_ins})
    endforeach()
  endif()
endfunction()

# Embeds core/<folder>/catalogue.json as liftarm::parts::catalogueJsonText() (parts/catalogue_data.h).
function(liftarm_embed_catalogue folder)
  set(data "${CMAKE_SOURCE_DIR}/core/${folder}/catalogue.json")
  get_target_property(type liftarm_${folder} TYPE)
  if(NOT EXISTS "${data}" OR type STREQUAL "INTERFACE_LIBRARY")
    return()
  endif()
  set(generated "${CMAKE_BINARY_DIR}/generated/catalogue_data.cpp")
  set(script "${CMAKE_SOURCE_DIR}/scripts/cmake/EmbedText.cmake")
  add_custom_command(
    OUTPUT "${generated}"
    COMMAND "${CMAKE_COMMAND}" "-DINPUT=${data}" "-DOUTPUT=${generated}" -P "${script}"
    DEPENDS "${data}" "${script}"
    VERBATIM)
  target_sources(liftarm_${folder} PRIVATE "${generated}")
  # Generated text is data: no point in linting it.
  set_source_files_properties("${generated}" PROPERTIES SKIP_LINTING ON)
endfunction()

# The command: build/<preset>/liftarm from core/<folder>/*.cpp. A library holds all but main.cpp, for tests.
function(liftarm_command folder)
  liftarm_folder(${folder} ${ARGN})
  set(main "${CMAKE_SOURCE_DIR}/core/${folder}/main.cpp")
  if(NOT EXISTS "${main}")
    return()
  endif()
  get_target_property(sources liftarm_${folder} SOURCES)
  list(REMOVE_ITEM sources "${main}")
  set_property(TARGET liftarm_${folder} PROPERTY SOURCES "${sources}")
  # Threads are for the command alone: it solves with several seeds at a time.
  find_package(Threads REQUIRED)
  target_link_libraries(liftarm_${folder} PUBLIC liftarm_cli11 Threads::Threads)
  add_executable(liftarm "${main}")
  target_link_libraries(liftarm PRIVATE liftarm_${folder})
endfunction()
