# The C++ block of a page is the file that the tests compile.
# -D PAGE=page -D SOURCE=file
file(READ ${PAGE} page)
file(READ ${SOURCE} source)
string(FIND "${page}" "```cpp\n${source}```" place)
if(place EQUAL -1)
  message(FATAL_ERROR "${PAGE}: its code is not that of ${SOURCE}")
endif()
