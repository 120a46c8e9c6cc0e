# Headers, library, find_package(contact) and pkg-config file.
add_dependencies(installed contact contact_files)
install(TARGETS contact contact_files EXPORT contact-targets
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
foreach(header IN LISTS public_headers)
  get_filename_component(folder ${header} DIRECTORY)
  install(FILES ${header}
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/libcontact/${folder})
endforeach()
install(FILES ${PROJECT_BINARY_DIR}/include/libcontact/version.hpp
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/libcontact)
install(EXPORT contact-targets NAMESPACE contact::
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/contact)
configure_package_config_file(
  ${PROJECT_SOURCE_DIR}/cmake/contactConfig.cmake.in
  ${PROJECT_BINARY_DIR}/contactConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/contact)
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/contactConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/contactConfig.cmake
  ${PROJECT_BINARY_DIR}/contactConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/contact)
install(FILES ${PROJECT_SOURCE_DIR}/cmake/libcontactConfig.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/libcontact)
install(FILES ${PROJECT_BINARY_DIR}/contactConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/libcontact
  RENAME libcontactConfigVersion.cmake)
foreach(pc contact.pc contact-files.pc)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/${pc}.in
    ${PROJECT_BINARY_DIR}/${pc} @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${pc}
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endforeach()
# Examples, which the programs and users start from.
set(examples backings cases duty joints materials schemas studies)
list(TRANSFORM examples PREPEND ${PROJECT_SOURCE_DIR}/data/)
install(DIRECTORY ${examples}
  DESTINATION ${CMAKE_INSTALL_DATADIR}/libcontact COMPONENT programs)
