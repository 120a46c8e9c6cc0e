# The python3 of the PATH may be one without NumPy; the first one that has it is
# taken, unless Python_EXECUTABLE says which.
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
# Of pip's pybind11, where this Python has it: newer than the system's.
execute_process(COMMAND ${Python_EXECUTABLE} -P -m pybind11 --cmakedir
  OUTPUT_VARIABLE folder ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE
  RESULT_VARIABLE failed)
if(NOT failed)
  set(pybind11_ROOT ${folder})
endif()
message(STATUS "Python package for ${Python_EXECUTABLE} (${Python_VERSION}); "
  "-D Python_EXECUTABLE= takes another")
