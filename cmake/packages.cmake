# cpack -G DEB: a Debian package for each installed component: programs with the
# examples, the shared C libraries, the development files, and the Python
# package.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "the authors of libcontact")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/package_folders.cmake)
set(CPACK_COMPONENTS_ALL programs c dev)
if(TARGET contact_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(c_package libcontact${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})

include(cmake/sbom.cmake)
# package(COMPONENT NAME DESCRIPTION DEPENDENCIES)
function(package component name description depends)
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name} PARENT_SCOPE)
  set(CPACK_COMPONENT_${upper}_DESCRIPTION
    "${PROJECT_DESCRIPTION}: ${description}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS "${depends}" PARENT_SCOPE)
  install(FILES LICENSE DESTINATION share/doc/${name} RENAME copyright
    COMPONENT ${component} EXCLUDE_FROM_ALL)
  install(FILES ${PROJECT_BINARY_DIR}/libcontact.spdx
    DESTINATION share/doc/${name} COMPONENT ${component} EXCLUDE_FROM_ALL)
endfunction()
package(programs libcontact-tools "programs and examples" "")
package(c ${c_package} "shared libraries for C" "")
package(dev libcontact-dev "headers and libraries for C++ and C"
  "${c_package} (= ${PROJECT_VERSION}), libeigen3-dev")
package(python python3-libcontact "package for Python" "python3, python3-numpy")
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_RECOMMENDS gnuplot-nox)
# What its components need, and the simulators that it has adapters to.
set(suggests libsundials-dev libfmt-dev nlohmann-json3-dev libqhull-dev)
foreach(host mujoco simbody ode dart)
  if(TARGET contact::${host})
    list(APPEND suggests lib${host}-dev)
  endif()
endforeach()
list(JOIN suggests ", " CPACK_DEBIAN_DEV_PACKAGE_SUGGESTS)
set(CPACK_DEBIAN_DEV_PACKAGE_SHLIBDEPS OFF)
# Studies in parts need hinge-study of the same version.
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS
  "libcontact-tools (= ${PROJECT_VERSION})")
include(CPack)
