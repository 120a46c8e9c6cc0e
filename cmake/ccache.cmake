# Uses ccache if it is installed and can write, unless the user sets a launcher.
# Only for g++: precompiled headers of clang++ store the times of their
# includes, and ccache rejects them.
find_program(CONTACT_CCACHE ccache)
mark_as_advanced(CONTACT_CCACHE)
if(NOT CONTACT_CCACHE OR NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU" OR
   DEFINED CMAKE_CXX_COMPILER_LAUNCHER OR DEFINED CMAKE_C_COMPILER_LAUNCHER)
  return()
endif()
# ccache fails without compiling if its cache cannot be written.
file(WRITE ${PROJECT_BINARY_DIR}/ccache/probe.cpp "int main() {}\n")
execute_process(
  COMMAND ${CONTACT_CCACHE} ${CMAKE_CXX_COMPILER} -c probe.cpp -o probe.o
  WORKING_DIRECTORY ${PROJECT_BINARY_DIR}/ccache
  RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
if(failed)
  return()
endif()
# ccache needs these two for sources with a precompiled header.
set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
  CCACHE_SLOPPINESS=pch_defines,time_macros ${CONTACT_CCACHE})
set(CMAKE_C_COMPILER_LAUNCHER ${CONTACT_CCACHE})
add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-fpch-preprocess>)
