# Before cpack packs them: folders are everybody's to read, whatever the umask of
# who makes the packages (CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS has no
# effect on those of components).
file(CHMOD_RECURSE ${CPACK_TEMPORARY_INSTALL_DIRECTORY} DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
  WORLD_EXECUTE)
