# Installs a build tree into an empty folder, then builds and runs the outside
# project against it twice: by find_package and by pkg-config.
# The same for the door to C, if it was built.
# -D BUILD=tree -D SOURCE=outside project -D WORK=folder -D COMPILER=...
# -D C_COMPILER=... -D FLAGS=...
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status
    OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\nfailed (${status}):\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

set(top ${SOURCE}/../../..)
if(EXISTS ${BUILD}/bin/hinge-separation)
  set(with_apps ${top})
endif()
file(REMOVE_RECURSE ${WORK})
set(prefix ${WORK}/prefix)
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})
run(${SOURCE}/../runpaths.sh ${prefix})

file(GLOB_RECURSE private ${prefix}/include/*kernel*)
if(private)
  message(FATAL_ERROR "private headers installed: ${private}")
endif()
if(EXISTS ${BUILD}/bin/hinge-angle)
  run(${prefix}/bin/hinge-angle --load 2000
    --joint ${prefix}/share/libcontact/joints/hip_cocr_uhmwpe_infinite.toml)
  message(STATUS "installed program and joint: ${output}")
  run(${prefix}/bin/hinge-angle --load 2000 --joint hip_cocr_uhmwpe_infinite)
  foreach(file man/man1/hinge-angle.1 zsh/site-functions/_hinge-angle
      bash-completion/completions/hinge-angle
      fish/vendor_completions.d/hinge-angle.fish)
    file(SIZE ${prefix}/share/${file} size)
    if(size LESS 1000)
      message(FATAL_ERROR "share/${file} is not installed whole")
    endif()
  endforeach()
endif()

foreach(file LICENSE README.md libcontact/docs/tutorials/first_steps.md
    plots/hinge.png)
  if(NOT EXISTS ${prefix}/share/doc/libcontact/${file})
    message(FATAL_ERROR "${file} is not installed")
  endif()
endforeach()

# What fails says why.
function(run_fails expected)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status
    OUTPUT_VARIABLE output ERROR_VARIABLE output)
  string(REGEX REPLACE "[ \n]+" " " output "${output}")
  if(status EQUAL 0 OR NOT output MATCHES "${expected}")
    message(FATAL_ERROR "${ARGN}\n(${status}): ${output}")
  endif()
endfunction()
file(WRITE ${WORK}/misspelt/CMakeLists.txt "
cmake_minimum_required(VERSION 3.25)
project(misspelt LANGUAGES CXX)
find_package(contact REQUIRED COMPONENTS fils)
")
run_fails("no component fils; its components are c, runs_c, files, "
  ${CMAKE_COMMAND} -S ${WORK}/misspelt -B ${WORK}/misspelt/build
  -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_CXX_COMPILER=${COMPILER})
run_fails("error: (#error )?.libcontact needs C..20; "
  ${COMPILER} -std=c++17 -fsyntax-only -I${prefix}/include ${SOURCE}/main.cpp)

file(GLOB_RECURSE mujoco ${prefix}/*/libcontact_mujoco.a)
run(${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/build
  -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_CXX_COMPILER=${COMPILER}
  -D "CMAKE_CXX_FLAGS=${FLAGS}" -D CMAKE_BUILD_TYPE=Release
  -D WITH_APPS=${with_apps} -D WITH_MUJOCO=${mujoco})
run(${CMAKE_COMMAND} --build ${WORK}/build)
if(mujoco)
  run(${WORK}/build/arm ${SOURCE}/arm.xml ${top}/data/joints/pin_joint.toml)
  # The arm is 0.1 deg off the vertical, which friction holds.
  if(NOT output MATCHES "^rate 0 rad/s at 0 rad")
    message(FATAL_ERROR "contact::mujoco: ${output}")
  endif()
  message(STATUS "contact::mujoco: ${output}")
endif()
if(with_apps)
  run(${WORK}/build/swing)
  if(NOT output MATCHES "rests after 44[.]3")
    message(FATAL_ERROR "contact::multibody: ${output}")
  endif()
  message(STATUS "contact::multibody: ${output}")
  run(${CMAKE_COMMAND} -E chdir ${with_apps} ${WORK}/build/turn)
  message(STATUS "contact::separation: ${output}")
endif()
run(${WORK}/build/outside)
message(STATUS "find_package: ${output}")
run(${WORK}/build/pendulum)
message(STATUS "docs/tutorials/pendulum.md: ${output}")
run(${WORK}/build/hip)
message(STATUS "docs/tutorials/first_steps.md: ${output}")
run(${WORK}/build/numbers)
if(NOT output MATCHES "p_peak_Pa +[0-9.e+]+ ")
  message(FATAL_ERROR "tables of quantities: ${output}")
endif()

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
run(pkg-config --cflags --libs contact)
separate_arguments(pc_flags UNIX_COMMAND "${output}")
separate_arguments(flags UNIX_COMMAND "${FLAGS}")
run(${COMPILER} -std=c++20 ${flags} ${SOURCE}/main.cpp
  -o ${WORK}/by_pkg_config ${pc_flags})
run(${WORK}/by_pkg_config)
message(STATUS "pkg-config: ${output}")
run(pkg-config --cflags --libs contact-files)
separate_arguments(pc_flags UNIX_COMMAND "${output}")
run(${COMPILER} -std=c++20 ${flags} ${SOURCE}/files.cpp
  -o ${WORK}/files_by_pkg_config ${pc_flags})
run(${WORK}/files_by_pkg_config ${joint})

file(GLOB_RECURSE library ${prefix}/*/libcontact_c.so)
# Whoever wants a joint's moment loads no integrator and no collision library.
run(ldd ${library})
if(output MATCHES "sundials|fcl|qhull|hdf5|fmt|ccd")
  message(FATAL_ERROR "libcontact_c loads ${output}")
endif()
run(${CMAKE_COMMAND} -S ${SOURCE}_c -B ${WORK}/build_c
  -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_BUILD_TYPE=Release
  -D CMAKE_C_COMPILER=${C_COMPILER} -D "CMAKE_C_FLAGS=${FLAGS}"
  -D CMAKE_CXX_COMPILER=${COMPILER} -D "CMAKE_CXX_FLAGS=${FLAGS}"
  -D WITH_APPS=${with_apps})
run(${CMAKE_COMMAND} --build ${WORK}/build_c)
run(${CMAKE_COMMAND} -E chdir ${top} ${WORK}/build_c/turning)
set(by_cmake "${output}")
message(STATUS "contact::c: ${output}")
run(${WORK}/build_c/bridge)
message(STATUS "C++17: ${output}")
if(NOT output MATCHES "C.. 201703: utilisation 0\\.[0-9]+")
  message(FATAL_ERROR "unexpected")
endif()
if(with_apps)
  file(GLOB_RECURSE runs_library ${prefix}/*/libcontact_runs_c.so)
  run(${WORK}/build_c/threads ${library} ${runs_library}
    ${top}/data/joints/pin_joint.toml ${top}/data/cases/two_stage_turn.toml)
  message(STATUS "dlopen: ${output}")
  run(${CMAKE_COMMAND} -E chdir ${top} ${WORK}/build_c/stages)
  set(stages_by_cmake "${output}")
  message(STATUS "contact::runs_c: ${output}")
endif()
run(pkg-config --cflags --libs contact-c)
separate_arguments(pc_flags UNIX_COMMAND "${output}")
get_filename_component(folder ${library} DIRECTORY)
run(${C_COMPILER} -std=c11 -pedantic -Wall -Werror ${flags}
  ${SOURCE}_c/turning.c -o ${WORK}/c_by_pkg_config ${pc_flags}
  -Wl,-rpath,${folder})
run(${CMAKE_COMMAND} -E chdir ${top} ${WORK}/c_by_pkg_config)
if(NOT output STREQUAL by_cmake)
  message(FATAL_ERROR "by pkg-config: ${output}")
endif()
if(with_apps)
  run(pkg-config --cflags --libs contact-runs-c)
  separate_arguments(pc_flags UNIX_COMMAND "${output}")
  run(${C_COMPILER} -std=c11 -pedantic -Wall -Werror ${flags}
    ${SOURCE}_c/stages.c -o ${WORK}/stages_by_pkg_config ${pc_flags}
    -Wl,-rpath,${folder})
  run(${CMAKE_COMMAND} -E chdir ${top} ${WORK}/stages_by_pkg_config)
  if(NOT output STREQUAL stages_by_cmake)
    message(FATAL_ERROR "by pkg-config: ${output}")
  endif()
endif()
