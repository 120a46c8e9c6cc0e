# For cross compilers: provides find_package() with the header-only libraries of
# this machine by links, so that none of its other headers is found.
set(CONTACT_HEADERS_OF_HOST /usr/include CACHE PATH "Where this machine has them")
set(CONTACT_HEADERS ${CMAKE_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${CONTACT_HEADERS})
foreach(name eigen3/Eigen eigen3/unsupported boost fmt toml++ nlohmann)
  get_filename_component(link ${name} NAME)
  file(CREATE_LINK ${CONTACT_HEADERS_OF_HOST}/${name} ${CONTACT_HEADERS}/${link}
    SYMBOLIC)
endforeach()

macro(contact_provide method name)
  if("${name}" MATCHES "^(Eigen3|Boost|fmt|tomlplusplus)$")
    set(${name}_FOUND TRUE)
    foreach(target Eigen3::Eigen Boost::headers fmt::fmt-header-only
        tomlplusplus::tomlplusplus)
      if(NOT TARGET ${target})
        add_library(${target} INTERFACE IMPORTED GLOBAL)
        target_include_directories(${target} SYSTEM
          INTERFACE ${CONTACT_HEADERS})
      endif()
    endforeach()
    set_property(TARGET fmt::fmt-header-only
      PROPERTY INTERFACE_COMPILE_DEFINITIONS FMT_HEADER_ONLY=1)
  endif()
endmacro()
cmake_language(SET_DEPENDENCY_PROVIDER contact_provide
  SUPPORTED_METHODS FIND_PACKAGE)
