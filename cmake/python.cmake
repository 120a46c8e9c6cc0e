# The first python3 on the PATH may lack NumPy; this takes the first one with
# NumPy unless Python_EXECUTABLE is set.
if(NOT Python_EXECUTABLE)
  foreach(candidate python3 /usr/bin/python3)
    execute_process(COMMAND ${candidate} -c "import numpy, tomllib, sys
print(sys.executable)" OUTPUT_VARIABLE found ERROR_QUIET
      OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE failed)
    if(NOT failed)
      set(Python_EXECUTABLE ${found} CACHE FILEPATH "The Python of the package")
      break()
    endif()
  endforeach()
endif()
find_package(Python 3.11 REQUIRED COMPONENTS Interpreter Development.Module
  NumPy)
# Prefers pip's pybind11, which is newer than the system's.
execute_process(COMMAND ${Python_EXECUTABLE} -P -m pybind11 --cmakedir
  OUTPUT_VARIABLE folder ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE
  RESULT_VARIABLE failed)
if(NOT failed)
  set(pybind11_ROOT ${folder})
endif()
message(STATUS "Python package for ${Python_EXECUTABLE} (${Python_VERSION}); "
  "-D Python_EXECUTABLE= takes another")
