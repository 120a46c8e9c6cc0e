# Puts the page together: cmake -D ENGINE=engine.js -D PAGE=calculator.html
#   -D VERSION=0.2.0 -D SCRIPTS=a.js;b.js -P assemble.cmake
# engine.wasm lies beside engine.js.
set(html ${CMAKE_CURRENT_LIST_DIR}/../cli/html)
string(REGEX REPLACE "[.]js$" ".wasm" wasm ${ENGINE})
file(SHA256 ${wasm} nonce)
string(SUBSTRING ${nonce} 0 16 nonce)
# By gzip, in base64.
function(pack variable)
  execute_process(COMMAND cat ${ARGN} COMMAND gzip -9n COMMAND base64 -w0
    OUTPUT_VARIABLE packed COMMAND_ERROR_IS_FATAL ANY)
  set(${variable} "${packed}" PARENT_SCOPE)
endfunction()
pack(packed_wasm ${wasm})
pack(packed_engine ${ENGINE} ${CMAKE_CURRENT_LIST_DIR}/worker.js)

set(all "")
foreach(name ${SCRIPTS})
  file(READ ${CMAKE_CURRENT_LIST_DIR}/${name} text)
  string(APPEND all "${text}\n")
endforeach()
file(READ ${html}/page.css style)
file(READ ${CMAKE_CURRENT_LIST_DIR}/page.css own_style)

file(READ ${html}/head.html page)
file(READ ${CMAKE_CURRENT_LIST_DIR}/page.html body)
string(APPEND page "${body}")
foreach(part
    "title=Calculator of hinges" "style=${style}${own_style}"
    "policy= 'wasm-unsafe-eval'; worker-src blob:" "version=${VERSION}"
    "engine=${packed_engine}" "wasm=${packed_wasm}"
    "scripts=(() => {\n'use strict';\n${all}})();" "nonce=${nonce}")
  string(FIND "${part}" "=" at)
  string(SUBSTRING "${part}" 0 ${at} name)
  math(EXPR at "${at} + 1")
  string(SUBSTRING "${part}" ${at} -1 text)
  string(REPLACE "{{${name}}}" "${text}" page "${page}")
endforeach()
file(WRITE ${PAGE} "${page}")
