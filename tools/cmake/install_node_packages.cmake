# SPDX-License-Identifier: MIT
# cmake -D NPM=npm -D SOURCE=folder -D FOLDER=folder -P ...: fetches the packages that the lock in SOURCE names into
# FOLDER.
file(REMOVE_RECURSE ${FOLDER})
file(COPY ${SOURCE}/package.json ${SOURCE}/package-lock.json ${SOURCE}/.npmrc DESTINATION ${FOLDER})
execute_process(COMMAND ${NPM} ci --ignore-scripts --no-audit --no-fund --prefer-offline --fetch-retries=1
  WORKING_DIRECTORY ${FOLDER} RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(NOT result EQUAL 0)
  message(FATAL_ERROR
    "${said}\nnpm could not fetch the packages that the page of `geodrome compare --html` is made of. "
    "Connect this machine to an npm registry and build again, "
    "or build without the page: cmake -DGEODROME_BUILD_PAGE=OFF.")
endif()
