# Flags of all our code, as one interface target.

add_library(liftarm_options INTERFACE)
target_include_directories(liftarm_options INTERFACE "$<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}/core>"
                                                    "$<INSTALL_INTERFACE:include/liftarm>")
# Ours alone: who builds against the installation has warnings of their own.
target_compile_options(
  liftarm_options INTERFACE "$<BUILD_INTERFACE:-Wall;-Wextra;-Wpedantic;-Wshadow;-Wconversion;-Wswitch>"
                            # The same bits on every platform: no fused multiply-add.
                            "$<BUILD_INTERFACE:-ffp-contract=off>")
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 sees overlaps in inlined std::string concatenation that are not there (GCC bug 105651).
  target_compile_options(liftarm_options INTERFACE "$<BUILD_INTERFACE:-Wno-restrict>")
endif()
# Several files in one translation unit (CMAKE_UNITY_BUILD, on in the presets that npm test builds): they parse the
# headers once. What one of them declares for itself is then global to the others, and a local name may hide it.
if(CMAKE_UNITY_BUILD)
  target_compile_options(liftarm_options INTERFACE "$<BUILD_INTERFACE:-Wno-shadow>")
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(liftarm_options INTERFACE "$<BUILD_INTERFACE:-Wshadow=local>")
  endif()
endif()
if(LIFTARM_STRICT)
  target_compile_options(liftarm_options INTERFACE "$<BUILD_INTERFACE:-Werror>")
endif()

# "Release with debug info" as we want it: full optimisation, line tables only.
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O3 -g1 -DNDEBUG")

# Folders that judge files of any origin check every index and every front() in all builds: an index that
# can be "none" must stop at once (in WebAssembly: trap), not write beside what it meant.
function(liftarm_checked)
  foreach(folder IN LISTS ARGN)
    if(EMSCRIPTEN)
      target_compile_options(liftarm_${folder} PRIVATE "-D_LIBCPP_ASSERT(x,m)=((x)?(void)0:__builtin_trap())")
    else()
      target_compile_definitions(liftarm_${folder} PRIVATE _GLIBCXX_ASSERTIONS)
    endif()
  endforeach()
endfunction()

# Folders that run once a model and not once a move: in WebAssembly they are built small, since the page
# waits for all of the module at its first visit.
function(liftarm_small)
  if(EMSCRIPTEN)
    foreach(folder IN LISTS ARGN)
      target_compile_options(liftarm_${folder} PRIVATE -Oz)
    endforeach()
  endif()
endfunction()

# The same for files of folders that run at every move.
function(liftarm_small_files)
  if(EMSCRIPTEN)
    set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS -Oz)
  endif()
endfunction()

if(LIFTARM_SANITIZE)
  list(JOIN LIFTARM_SANITIZE "," sanitizers)
  target_compile_options(liftarm_options INTERFACE "-fsanitize=${sanitizers}" -fno-omit-frame-pointer
                                                   -fno-sanitize-recover=all)
  target_link_options(liftarm_options INTERFACE "-fsanitize=${sanitizers}")
endif()

if(EMSCRIPTEN)
  set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")
  target_compile_options(liftarm_options INTERFACE -flto -fwasm-exceptions)
  target_link_options(liftarm_options INTERFACE -flto -fwasm-exceptions)
endif()
