# An overlay port of this source tree's library, without programs. Not run yet:
#   vcpkg install libcontact --overlay-ports=LIBCONTACT/cmake/vcpkg
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}" OPTIONS
  -DCONTACT_BUILD_APPS=OFF -DCONTACT_BUILD_PYTHON=OFF -DCONTACT_BUILD_TESTS=OFF
  -DCONTACT_BUILD_BENCH=OFF -DCONTACT_BUILD_REFERENCE=OFF)
vcpkg_cmake_install()
# The C interface is a shared library always.
set(VCPKG_POLICY_DLLS_IN_STATIC_LIBRARY enabled)
vcpkg_cmake_config_fixup(PACKAGE_NAME libcontact
  CONFIG_PATH lib/cmake/libcontact DO_NOT_DELETE_PARENT_CONFIG_PATH)
vcpkg_cmake_config_fixup(PACKAGE_NAME contact CONFIG_PATH lib/cmake/contact)
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include"
  "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
