# Sources that were compiled before come from ccache where it is installed and
# can write; a launcher that the user sets stands. Of g++ alone: the precompiled
# headers of clang++ keep the times of what they include, and are refused.
find_program(CONTACT_CCACHE ccache)
mark_as_advanced(CONTACT_CCACHE)
if(NOT CONTACT_CCACHE OR NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU" OR
   DEFINED CMAKE_CXX_COMPILER_LAUNCHER OR DEFINED CMAKE_C_COMPILER_LAUNCHER)
  return()
endif()
# Where the cache cannot be written ccache fails, and does not compile.
file(WRITE ${PROJECT_BINARY_DIR}/ccache/probe.cpp "int main() {}\n")
execute_process(
  COMMAND ${CONTACT_CCACHE} ${CMAKE_CXX_COMPILER} -c probe.cpp -o probe.o
  WORKING_DIRECTORY ${PROJECT_BINARY_DIR}/ccache
  RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
if(failed)
  return()
endif()
# Without these two ccache takes no source that has a precompiled header.
set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
  CCACHE_SLOPPINESS=pch_defines,time_macros ${CONTACT_CCACHE})
set(CMAKE_C_COMPILER_LAUNCHER ${CONTACT_CCACHE})
add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-fpch-preprocess>)
