# The C or C++ block of a page is the file that the tests compile.
# -D PAGE=page -D SOURCE=file
file(READ ${PAGE} page)
file(READ ${SOURCE} source)
cmake_path(GET SOURCE EXTENSION LAST_ONLY dot_language)
string(SUBSTRING ${dot_language} 1 -1 language)
string(FIND "${page}" "```${language}\n${source}```" place)
if(place EQUAL -1)
  message(FATAL_ERROR "${PAGE}: its code is not that of ${SOURCE}")
endif()
