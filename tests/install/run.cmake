# Installs a build tree into an empty folder, then builds and runs the outside
# project against it twice: by find_package and by pkg-config.
# -D BUILD=tree -D SOURCE=outside project -D WORK=folder -D COMPILER=...
# -D FLAGS=...
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status
    OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\nfailed (${status}):\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK})
set(prefix ${WORK}/prefix)
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})

file(GLOB_RECURSE private ${prefix}/include/*kernel*)
if(private)
  message(FATAL_ERROR "private headers installed: ${private}")
endif()
if(EXISTS ${BUILD}/bin/hinge-angle)
  run(${prefix}/bin/hinge-angle --load 2000
    --joint ${prefix}/share/libcontact/joints/hip_cocr_uhmwpe_infinite.toml)
  message(STATUS "installed program and joint: ${output}")
endif()

run(${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/build
  -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_CXX_COMPILER=${COMPILER}
  -D "CMAKE_CXX_FLAGS=${FLAGS}" -D CMAKE_BUILD_TYPE=Release)
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/outside)
message(STATUS "find_package: ${output}")
run(${WORK}/build/pendulum)
message(STATUS "docs/simulator.md: ${output}")
run(${WORK}/build/hip)
message(STATUS "README.md: ${output}")

set(joint ${prefix}/share/libcontact/joints/hip_cocr_uhmwpe_infinite.toml)
run(${WORK}/build/files ${joint})
message(STATUS "contact::files: ${output}")

file(GLOB_RECURSE headers ${prefix}/include/*)
foreach(header IN LISTS headers)
  file(STRINGS ${header} found REGEX "#include.*(boost|toml[+])")
  if(found)
    message(FATAL_ERROR "${header}: ${found}")
  endif()
endforeach()
file(GLOB_RECURSE core ${prefix}/*/libcontact.a)
if(core)
  execute_process(COMMAND nm -C ${core} OUTPUT_VARIABLE symbols ERROR_QUIET)
  if(symbols MATCHES "toml::")
    message(FATAL_ERROR "contact::contact has code of toml++")
  endif()
endif()

file(GLOB_RECURSE pc ${prefix}/*/contact.pc)
get_filename_component(pc_folder ${pc} DIRECTORY)
set(ENV{PKG_CONFIG_PATH} ${pc_folder})
run(pkg-config --cflags --libs --define-prefix contact)
separate_arguments(pc_flags UNIX_COMMAND "${output}")
separate_arguments(flags UNIX_COMMAND "${FLAGS}")
run(${COMPILER} -std=c++20 ${flags} ${SOURCE}/main.cpp
  -o ${WORK}/by_pkg_config ${pc_flags})
run(${WORK}/by_pkg_config)
message(STATUS "pkg-config: ${output}")
run(pkg-config --cflags --libs --define-prefix contact-files)
separate_arguments(pc_flags UNIX_COMMAND "${output}")
run(${COMPILER} -std=c++20 ${flags} ${SOURCE}/files.cpp
  -o ${WORK}/files_by_pkg_config ${pc_flags})
run(${WORK}/files_by_pkg_config ${joint})
