# contact_unity(TARGET ROOMS...): compiles the sources of each room as one, but
# for those with options of their own (kernels) and those that set
# SKIP_UNITY_BUILD_INCLUSION. Rooms with much linear algebra gain nothing.
function(contact_unity target)
  if(NOT CONTACT_UNITY_BUILD)
    return()
  endif()
  set_target_properties(${target} PROPERTIES
    UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # Names of one source do not shadow those of the others. A room is too big
  # for the usual objects of Windows.
  target_compile_options(${target} PRIVATE
    $<$<CXX_COMPILER_ID:Clang>:-Wno-shadow>
    $<$<BOOL:${MINGW}>:-Wa,-mbig-obj>)
  # Programs take the functions that they need, not the room.
  target_compile_options(${target} PRIVATE -ffunction-sections)
  if(PROJECT_IS_TOP_LEVEL AND NOT APPLE AND NOT WIN32)
    target_link_options(${target} INTERFACE
      $<BUILD_INTERFACE:-Wl,--gc-sections>)
  endif()
  get_target_property(sources ${target} SOURCES)
  foreach(room ${ARGN})
    set(of_room ${sources})
    list(FILTER of_room INCLUDE REGEX "^${room}/")
    list(FILTER of_room EXCLUDE REGEX "_kernel")
    set_property(SOURCE ${of_room} PROPERTY UNITY_GROUP ${room})
  endforeach()
endfunction()
