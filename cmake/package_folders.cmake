# Makes folders readable for everyone before cpack packs them, for any umask
# (CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS has no effect on components).
# CHMOD_RECURSE fails at links whose target is in another package.
file(GLOB_RECURSE paths LIST_DIRECTORIES true
  "${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*")
foreach(path "${CPACK_TEMPORARY_INSTALL_DIRECTORY}" ${paths})
  if(IS_DIRECTORY "${path}" AND NOT IS_SYMLINK "${path}")
    file(CHMOD "${path}" DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE
      OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
  endif()
endforeach()
