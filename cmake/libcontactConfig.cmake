# find_package(libcontact ...) is find_package(contact ...).
include(CMakeFindDependencyMacro)
set(contact_DIR ${CMAKE_CURRENT_LIST_DIR}/../contact)
find_dependency(contact ${libcontact_FIND_VERSION} CONFIG
  COMPONENTS ${libcontact_FIND_COMPONENTS})
