# contact_install_library(TARGET HEADERS...): installs a static library of apps,
# NAME or contact_NAME, as contact::NAME with these headers, paths below apps/,
# and its targets, which find_package(contact COMPONENTS NAME) loads.
function(contact_install_library target)
  string(REGEX REPLACE "^contact_" "" name ${target})
  add_library(contact::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES
    OUTPUT_NAME contact_${name} EXPORT_NAME ${name})
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/apps>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/libcontact>)
  add_dependencies(installed ${target})
  install(TARGETS ${target} EXPORT contact-${name}-targets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  foreach(header IN LISTS ARGN)
    get_filename_component(folder ${header} DIRECTORY)
    install(FILES ${PROJECT_SOURCE_DIR}/apps/${header}
      DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/libcontact/${folder})
  endforeach()
  install(EXPORT contact-${name}-targets NAMESPACE contact::
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/contact)
endfunction()
