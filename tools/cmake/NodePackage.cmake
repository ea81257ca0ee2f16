# SPDX-License-Identifier: MIT
# geodrome_node_package(<name> FILES file...)
#
# Makes a folder with package.json, package-lock.json, .npmrc and FILES (all relative to the current source folder)
# ready in the build tree, with the packages that the lock names; nothing is written into the source tree. Sets in the
# caller's scope <name>_FOLDER, and <name>_READY: what to depend on. Packages are fetched anew only when the package
# files have changed.
function(geodrome_node_package name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "FILES")
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/package)
  set(script ${PROJECT_SOURCE_DIR}/tools/cmake/install_node_packages.cmake)
  set(package_files package.json package-lock.json .npmrc)
  list(TRANSFORM package_files PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  add_custom_command(OUTPUT ${folder}/packages.stamp
    COMMAND ${CMAKE_COMMAND}
      -D NPM=${GEODROME_NPM} -D SOURCE=${CMAKE_CURRENT_SOURCE_DIR} -D FOLDER=${folder} -P ${script}
    COMMAND ${CMAKE_COMMAND} -E touch ${folder}/packages.stamp
    DEPENDS ${package_files} ${script} COMMENT "Fetching the Node packages of ${name}" VERBATIM)

  foreach(file IN LISTS arg_FILES)
    list(APPEND copies COMMAND ${CMAKE_COMMAND} -E copy ${CMAKE_CURRENT_SOURCE_DIR}/${file} ${folder}/${file})
    list(APPEND sources ${CMAKE_CURRENT_SOURCE_DIR}/${file})
  endforeach()
  add_custom_command(OUTPUT ${folder}/files.stamp
    COMMAND ${CMAKE_COMMAND} -E rm -rf ${folder}/src
    ${copies}
    COMMAND ${CMAKE_COMMAND} -E touch ${folder}/files.stamp
    DEPENDS ${folder}/packages.stamp ${sources} COMMENT "Copying the files of ${name}" VERBATIM)
  set(${name}_FOLDER ${folder} PARENT_SCOPE)
  set(${name}_READY ${folder}/files.stamp PARENT_SCOPE)
endfunction()
