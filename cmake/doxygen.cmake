# Target `reference`: the C++ and C reference as HTML in reference/html of the
# build tree. Target `site`: all pages with it, in site. A warning is an error.
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
  add_custom_target(site
    COMMAND ${PROJECT_SOURCE_DIR}/scripts/site.sh ${PROJECT_BINARY_DIR})
  if(CONTACT_BUILD_TESTS)
    add_test(NAME Reference.BuildsWithoutWarnings
      COMMAND ${CONTACT_DOXYGEN} ${PROJECT_BINARY_DIR}/Doxyfile)
    add_test(NAME Site.BuildsWithoutWarnings COMMAND
      ${PROJECT_SOURCE_DIR}/tests/support/needs.sh mkdocs-material
      "command -v mkdocs && test -d /usr/share/javascript/katex"
      ${PROJECT_SOURCE_DIR}/scripts/site.sh ${PROJECT_BINARY_DIR})
    set_tests_properties(Site.BuildsWithoutWarnings PROPERTIES
      ENVIRONMENT CONTACT_SKIP_SETUP=1)
    set_tests_properties(Reference.BuildsWithoutWarnings
      Site.BuildsWithoutWarnings PROPERTIES
      LABELS system RESOURCE_LOCK reference)
  endif()
endif()
