# Writes the material pairs as rows of shelf.cpp:
#   cmake -D DATA=data -D SHELF=shelf.inc -P shelf.cmake
set(rows "")
file(GLOB files RELATIVE ${DATA} ${DATA}/materials/*.toml)
foreach(file ${files})
  file(READ ${DATA}/${file} text)
  string(APPEND rows "{\"/data/${file}\", R\"toml(${text})toml\"},\n")
endforeach()
file(WRITE ${SHELF} "${rows}")
