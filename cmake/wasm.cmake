# Toolchain: WebAssembly by Debian's emscripten 3.1.6, or by an emsdk if its
# environment is set when the build tree is made, with vectors and exceptions;
# programs run in node.
set(emscripten /usr/share/emscripten)
if(DEFINED ENV{EMSDK})
  set(emscripten $ENV{EMSDK}/upstream/emscripten)
endif()
set(CONTACT_EMSCRIPTEN ${emscripten} CACHE PATH "Folder of emscripten")
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES CONTACT_EMSCRIPTEN)
include(${CONTACT_EMSCRIPTEN}/cmake/Modules/Platform/Emscripten.cmake)
set(CMAKE_CXX_FLAGS_INIT "-msimd128 -fwasm-exceptions \
-include ${CMAKE_CURRENT_LIST_DIR}/libcxx13.hpp")
# Node, and pages opened from disk, cannot fetch a second file.
set(CMAKE_EXE_LINKER_FLAGS_INIT "-s SINGLE_FILE=1")
