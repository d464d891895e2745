# Run by cpack before it makes the packages: adds copyright and changelog, compresses manual pages,
# and strips static libraries.
find_program(gzip gzip REQUIRED)
find_program(strip strip REQUIRED)
set(source ${CPACK_KUSABI_SOURCE})
foreach(pair "command kusabi" "development libkusabi-dev" "documents kusabi-doc")
  separate_arguments(pair)
  list(GET pair 0 component)
  list(GET pair 1 package)
  set(usr ${CPACK_TEMPORARY_DIRECTORY}/${component}/usr)
  set(documents ${usr}/share/doc/${package})
  file(COPY ${source}/cmake/debian/copyright DESTINATION ${documents})
  file(COPY ${source}/cmake/debian/changelog.Debian DESTINATION ${documents})
  file(GLOB_RECURSE files ${usr}/share/man/*.1)
  execute_process(COMMAND ${gzip} -9n ${files} ${documents}/changelog.Debian COMMAND_ERROR_IS_FATAL ANY)
  file(GLOB_RECURSE libraries ${usr}/lib/*.a)
  foreach(library IN LISTS libraries)
    execute_process(COMMAND ${strip} --strip-debug --remove-section=.comment --remove-section=.note
      --enable-deterministic-archives ${library} COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
  # Permissions 0755 and 0644, independent of the umask.
  file(CHMOD_RECURSE ${usr} FILE_PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ
    DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
endforeach()
set(executable OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
file(CHMOD ${CPACK_TEMPORARY_DIRECTORY}/command/usr/bin/kusabi PERMISSIONS ${executable})
# Debian systems contain the text of the license.
set(license ${CPACK_TEMPORARY_DIRECTORY}/documents/usr/share/doc/kusabi/LICENSE)
file(REMOVE ${license})
file(CREATE_LINK ../../common-licenses/Apache-2.0 ${license} SYMBOLIC)
