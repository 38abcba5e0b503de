# boxbeam_twin(TARGET): the same target once more as TARGET_sanitized, with address and
# undefined-behaviour sanitizers and assertions. Its library is the library's twin.
# Beside BOXBEAM_SANITIZE, which builds everything so, this compiles the tests only once.
function(boxbeam_twin target)
  get_target_property(type ${target} TYPE)
  if(type STREQUAL EXECUTABLE)
    add_executable(${target}_sanitized)
  else()
    string(REPLACE "_LIBRARY" "" kind ${type})
    add_library(${target}_sanitized ${kind})
  endif()
  foreach(property SOURCES INCLUDE_DIRECTORIES COMPILE_DEFINITIONS LINK_LIBRARIES
          INTERFACE_INCLUDE_DIRECTORIES INTERFACE_LINK_LIBRARIES PRECOMPILE_HEADERS
          UNITY_BUILD UNITY_BUILD_MODE)
    get_target_property(value ${target} ${property})
    if(NOT value)
      continue()
    endif()
    list(TRANSFORM value REPLACE "^boxbeam_library$" "boxbeam_library_sanitized")
    list(TRANSFORM value REPLACE "TARGET_OBJECTS:boxbeam_text" "TARGET_OBJECTS:boxbeam_text_sanitized")
    set_target_properties(${target}_sanitized PROPERTIES ${property} "${value}")
  endforeach()
  # Eigen would take memory in another way than in the tests, which are compiled without sanitizers.
  target_compile_definitions(${target}_sanitized PRIVATE EIGEN_MALLOC_ALREADY_ALIGNED=1)
  # What the pointer checks of the undefined-behaviour sanitizer find, the address sanitizer finds.
  target_compile_options(${target}_sanitized PRIVATE -O1 -UNDEBUG -fsanitize=address
    -fsanitize=undefined -fno-sanitize=null,alignment,object-size,vptr -fno-sanitize-recover=all
    # False alarms in instrumented std::function and std::variant (GCC bug 105562).
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(${target}_sanitized PRIVATE -fsanitize=address,undefined)
endfunction()
