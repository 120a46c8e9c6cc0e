# Source files that are compiled once per instruction set: *_avx2.cpp,
# *_avx512*.cpp, and those for any machine.
function(contact_set_kernel_options)
  set(avx2 ${ARGN})
  list(FILTER avx2 INCLUDE REGEX "_avx2[.]cpp$")
  set_property(SOURCE ${avx2} APPEND PROPERTY COMPILE_OPTIONS "-mavx2;-mfma")
  # g++ 12 takes the undefined registers of its own avx512fintrin.h for
  # uninitialised variables (GCC bug 105593).
  set(avx512 ${ARGN})
  list(FILTER avx512 INCLUDE REGEX "_avx512.*[.]cpp$")
  set_property(SOURCE ${avx512} APPEND PROPERTY
    COMPILE_OPTIONS "-mavx512f;-mavx512dq;-mavx512vl;-mavx512bw;-mavx2;-mfma;-mprefer-vector-width=512;$<$<CXX_COMPILER_ID:GNU>:-Wno-uninitialized;-Wno-maybe-uninitialized>")
  set_property(SOURCE ${avx2} ${avx512} PROPERTY SKIP_PRECOMPILE_HEADERS ON)
  # g++ aligns the stack of Windows to 16 bytes, and moves vectors as if to 32
  # (GCC bug 54412).
  if(MINGW AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    set_property(SOURCE ${avx2} ${avx512} APPEND PROPERTY
      COMPILE_OPTIONS -Wa,-muse-unaligned-vector-move)
  endif()
  # Guards around each of their thousands of small variables take g++ minutes.
  if(CMAKE_CXX_FLAGS MATCHES "-fsanitize=[a-z,]*address" AND
     CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    set_property(SOURCE ${ARGN} APPEND PROPERTY
      COMPILE_OPTIONS "--param=asan-stack=0")
  endif()
endfunction()
