# Toolchain: WebAssembly by Debian's emscripten 3.1.6, or by an emsdk if its
# environment is set, with vectors and exceptions; programs run in node.
set(CONTACT_EMSCRIPTEN /usr/share/emscripten)
if(DEFINED ENV{EMSDK})
  set(CONTACT_EMSCRIPTEN $ENV{EMSDK}/upstream/emscripten)
endif()
include(${CONTACT_EMSCRIPTEN}/cmake/Modules/Platform/Emscripten.cmake)
set(CMAKE_CXX_FLAGS_INIT "-msimd128 -fwasm-exceptions \
-include ${CMAKE_CURRENT_LIST_DIR}/libcxx13.hpp")
# Node, and pages opened from disk, cannot fetch a second file.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-s SINGLE_FILE=1")
