# Puts the page together: cmake -D ENGINE=engine.js -D PAGE=calculator.html
#   -D VERSION=0.2.0 -D SCRIPTS=a.js;b.js -D NODE=node
#   -D DATA=data -P assemble.cmake
# engine.wasm lies beside engine.js.
set(html ${CMAKE_CURRENT_LIST_DIR}/../cli/html)
string(REGEX REPLACE "[.]js$" ".wasm" wasm ${ENGINE})
file(SHA256 ${wasm} nonce)
string(SUBSTRING ${nonce} 0 16 nonce)
# Packed as gzip does, but a little smaller, in base64.
execute_process(COMMAND zopfli -c ${wasm} COMMAND base64 -w0
  OUTPUT_VARIABLE packed_wasm COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND cat ${ENGINE} ${CMAKE_CURRENT_LIST_DIR}/worker.js
  OUTPUT_VARIABLE engine COMMAND_ERROR_IS_FATAL ANY)
if(engine MATCHES "</script|<!--")
  message(FATAL_ERROR "The engine's script cannot stand in a page.")
endif()
execute_process(COMMAND ${NODE} ${CMAKE_CURRENT_LIST_DIR}/choices.js ${ENGINE} ${DATA}
  OUTPUT_VARIABLE choices COMMAND_ERROR_IS_FATAL ANY)
file(READ ${CMAKE_CURRENT_LIST_DIR}/start.js start)

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
    "title=Hinge calculator" "style=${style}${own_style}"
    "policy= 'wasm-unsafe-eval'; worker-src blob:" "version=${VERSION}"
    "engine=${engine}" "wasm=${packed_wasm}" "start=${start}"
    "choices=${choices}"
    "scripts=(() => {\n'use strict';\n${all}})();" "nonce=${nonce}")
  string(FIND "${part}" "=" at)
  string(SUBSTRING "${part}" 0 ${at} name)
  math(EXPR at "${at} + 1")
  string(SUBSTRING "${part}" ${at} -1 text)
  string(REPLACE "{{${name}}}" "${text}" page "${page}")
endforeach()
file(WRITE ${PAGE} "${page}")
