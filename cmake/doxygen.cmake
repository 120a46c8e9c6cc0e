# Target `reference`: the API reference as HTML in reference/html of the build
# tree. A warning is an error.
find_program(CONTACT_DOXYGEN doxygen)
if(CONTACT_DOXYGEN)
  file(STRINGS ${PROJECT_BINARY_DIR}/public_headers.txt headers)
  list(TRANSFORM headers PREPEND ${PROJECT_SOURCE_DIR}/libcontact/)
  list(JOIN headers " " CONTACT_REFERENCE_INPUT)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/Doxyfile.in
    ${PROJECT_BINARY_DIR}/Doxyfile @ONLY)
  add_custom_target(reference
    COMMAND ${CONTACT_DOXYGEN} ${PROJECT_BINARY_DIR}/Doxyfile
    COMMENT "API reference in ${PROJECT_BINARY_DIR}/reference/html")
  if(CONTACT_BUILD_TESTS)
    add_test(NAME Reference.BuildsWithoutWarnings
      COMMAND ${CONTACT_DOXYGEN} ${PROJECT_BINARY_DIR}/Doxyfile)
    set_tests_properties(Reference.BuildsWithoutWarnings PROPERTIES
      LABELS system)
  endif()
endif()
