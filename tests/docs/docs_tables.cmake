# The tables that a script prints are those of a page.
# -D SCRIPT=script -D BUILD=its argument -D PAGE=page
execute_process(COMMAND ${SCRIPT} ${BUILD} OUTPUT_VARIABLE tables
  COMMAND_ERROR_IS_FATAL ANY)
file(READ ${PAGE} page)
string(REGEX MATCHALL "\\|[^\n]*\n" rows "${tables}")
list(LENGTH rows count)
if(count LESS 3)
  message(FATAL_ERROR "${SCRIPT}: no tables")
endif()
foreach(row IN LISTS rows)
  string(FIND "${page}" "\n${row}" place)
  if(place EQUAL -1)
    message(SEND_ERROR "${PAGE} has no row\n${row}")
  endif()
endforeach()
