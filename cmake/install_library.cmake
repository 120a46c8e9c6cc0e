# contact_install_library(NAME HEADERS...): installs a static library of apps as
# contact::NAME with these headers, paths below apps/, and its targets, which
# find_package(contact COMPONENTS NAME) loads.
function(contact_install_library name)
  add_library(contact::${name} ALIAS ${name})
  set_target_properties(${name} PROPERTIES
    OUTPUT_NAME contact_${name} EXPORT_NAME ${name})
  target_include_directories(${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/apps>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/libcontact>)
  add_dependencies(installed ${name})
  install(TARGETS ${name} EXPORT contact-${name}-targets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  foreach(header IN LISTS ARGN)
    get_filename_component(folder ${header} DIRECTORY)
    install(FILES ${PROJECT_SOURCE_DIR}/apps/${header}
      DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/libcontact/${folder})
  endforeach()
  install(EXPORT contact-${name}-targets NAMESPACE contact::
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/contact)
endfunction()
