# cmake -D STEP=... -D BUILD=... -D SOURCE=... -D WORK=... -D LIBDIR=... -P install_test.cmake
#
# One step of the test of the installed package. The steps share WORK: prefix/ (the install), third_party/ (a program
# and the template's plugin, built against it), projects/ (a project from each template, and one that builds them all),
# my_own/ (its build) and command_line/ (the command line, built against the install). What comes out wrong ends in a
# FATAL_ERROR.
set(prefix ${WORK}/prefix)
set(third_party ${WORK}/third_party)
set(stages tangent control decimator reconstructor solver)

function(run out)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE stdout ERROR_VARIABLE stderr RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "status ${status} of: ${command}\n${stdout}${stderr}")
  endif()
  set(${out} "${stdout}" PARENT_SCOPE)
endfunction()

function(expect_equal what is should)
  if(NOT "${is}" STREQUAL "${should}")
    message(FATAL_ERROR "${what}: is\n${is}\nbut should be\n${should}")
  endif()
endfunction()

function(expect_match what text pattern)
  if(NOT "${text}" MATCHES "${pattern}")
    message(FATAL_ERROR "${what}: no '${pattern}' in\n${text}")
  endif()
endfunction()

# The edges' lengths from the first corner of the rectangle.
function(check_first_row csv)
  file(STRINGS ${csv} rows REGEX "^[0-9]")
  list(GET rows 0 row)
  expect_equal("first row of the distances along edges" "${row}" "0,3,7,4")
endfunction()

# Runs the third party's program with the install in `where`.
function(check_library where)
  set(ENV{LD_LIBRARY_PATH} ${where}/${LIBDIR})
  set(csv ${WORK}/library.csv)
  file(REMOVE ${csv})
  run(summary ${third_party}/ten_lines ${SOURCE}/rectangle.off ${csv} ${third_party}/lib/geodrome)
  expect_match("summary" "${summary}" "solver_third_party")
  check_first_row(${csv})
endfunction()

# Runs the installed program with the third party's plugin.
function(check_program where)
  set(plugins ${third_party}/lib/geodrome)
  run(shown ${where}/bin/geodrome plugins show solver_third_party --plugin-path ${plugins})
  expect_match("plugins show" "${shown}" "third_party")
  set(csv ${WORK}/program.csv)
  file(REMOVE ${csv})
  run(ignored ${where}/bin/geodrome distances ${SOURCE}/rectangle.off -o ${csv} --solver third_party
      --plugin-path ${plugins})
  check_first_row(${csv})
endfunction()

if(STEP STREQUAL "install")
  file(REMOVE_RECURSE ${WORK})
  run(ignored ${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})
  foreach(file bin/geodrome bin/geodrome-vet bin/geodrome-judge include/geodrome/conformance/gtest.hpp
          ${LIBDIR}/libgeodrome_engine.so include/geodrome/plugin.hpp
          include/geodrome/engine.hpp include/geodrome/solver_kit/packed_mesh.hpp
          ${LIBDIR}/libgeodrome_solver_kit.a ${LIBDIR}/cmake/geodrome/geodromeConfig.cmake)
    if(NOT EXISTS ${prefix}/${file})
      message(FATAL_ERROR "${file} was not installed")
    endif()
  endforeach()
  # What engine and plugins of this repository share is no part of the SDK.
  file(GLOB_RECURSE private ${prefix}/include/*/closest_point_tree.hpp ${prefix}/include/*/internal/*)
  expect_equal("private headers installed" "${private}" "")
elseif(STEP STREQUAL "package")
  # Neither compile flags nor what the engine is made of may reach a user's targets.
  file(GLOB files ${prefix}/${LIBDIR}/cmake/geodrome/geodromeTargets*.cmake
    ${prefix}/${LIBDIR}/cmake/geodrome/geodromeConfig.cmake)
  foreach(file IN LISTS files)
    string(JOIN "|" private Boost CGAL OpenMesh flann xxhash nlohmann Eigen lz4 build_flags -W
      INTERFACE_COMPILE_OPTIONS INTERFACE_LINK_OPTIONS ${BUILD} ${prefix})
    file(STRINGS ${file} leaks REGEX "${private}")
    expect_equal("${file}" "${leaks}" "")
  endforeach()
elseif(STEP STREQUAL "build")
  run(ignored ${prefix}/bin/geodrome plugins new third_party --stage solver -o ${WORK}/solver_third_party)
  run(ignored ${CMAKE_COMMAND} -D PLUGIN_SOURCE=${WORK}/solver_third_party/third_party.cpp -S ${SOURCE}/third_party
    -B ${third_party} -G ${GENERATOR} -D CMAKE_BUILD_TYPE=Release
      -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_CXX_FLAGS=${FLAGS}
      -D CMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER} -D CMAKE_FIND_USE_PACKAGE_REGISTRY=OFF)
  run(ignored ${CMAKE_COMMAND} --build ${third_party})
elseif(STEP STREQUAL "command_line")
  # The program needs nothing of the engine but what is installed. Not optimized: it is compiled to be run once.
  set(root ${WORK}/command_line_root)
  file(MAKE_DIRECTORY ${root}/tools)
  foreach(folder geodrome shapes)
    file(CREATE_LINK ${SOURCE}/../../tools/${folder} ${root}/tools/${folder} SYMBOLIC)
  endforeach()
  run(ignored ${CMAKE_COMMAND} -D ROOT=${root} -S ${SOURCE}/command_line -B ${WORK}/command_line -G ${GENERATOR}
      -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_CXX_FLAGS=${FLAGS}
      -D CMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER} -D CMAKE_FIND_USE_PACKAGE_REGISTRY=OFF)
  run(ignored ${CMAKE_COMMAND} --build ${WORK}/command_line)
  set(csv ${WORK}/command_line.csv)
  run(ignored ${WORK}/command_line/geodrome/geodrome distances ${SOURCE}/rectangle.off -o ${csv}
      --solver edge_dijkstra)
  check_first_row(${csv})
elseif(STEP STREQUAL "new")
  # What a stranger does: a project from the template, built, judged by the program and by its own tests. Of every
  # stage, all in one project.
  set(all "cmake_minimum_required(VERSION 3.25)\nproject(all LANGUAGES CXX)\nenable_testing()\n")
  file(MAKE_DIRECTORY ${WORK}/projects)
  foreach(stage IN LISTS stages)
    run(ignored ${CMAKE_COMMAND} -E chdir ${WORK}/projects ${prefix}/bin/geodrome plugins new my_own --stage ${stage})
    string(APPEND all "add_subdirectory(${stage}_my_own)\n")
  endforeach()
  file(WRITE ${WORK}/projects/CMakeLists.txt "${all}")
  set(ENV{LD_LIBRARY_PATH} ${prefix}/${LIBDIR})  # also for a build with sanitizers
  run(ignored ${CMAKE_COMMAND} -S ${WORK}/projects -B ${WORK}/my_own -G ${GENERATOR}
      -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_CXX_FLAGS=${FLAGS}
      -D CMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER} -D CMAKE_FIND_USE_PACKAGE_REGISTRY=OFF)
  run(ignored ${CMAKE_COMMAND} --build ${WORK}/my_own)
elseif(STEP STREQUAL "new_check")
  foreach(stage IN LISTS stages)
    run(verdicts ${prefix}/bin/geodrome plugins check ${WORK}/my_own/lib/geodrome/${stage}_my_own.so)
    expect_match("verdicts" "${verdicts}" "${stage}_my_own: [1-9][0-9]* held, 0 failed")
  endforeach()
elseif(STEP STREQUAL "new_tests")
  run(tests ${CMAKE_CTEST_COMMAND} --test-dir ${WORK}/my_own)
  expect_match("tests" "${tests}" "100% tests passed, 0 tests failed")
elseif(STEP STREQUAL "library")
  check_library(${prefix})
elseif(STEP STREQUAL "program")
  check_program(${prefix})
elseif(STEP STREQUAL "move")
  file(REMOVE_RECURSE ${WORK}/elsewhere)
  file(RENAME ${prefix} ${WORK}/elsewhere)
elseif(STEP STREQUAL "moved_library")
  check_library(${WORK}/elsewhere)
elseif(STEP STREQUAL "moved_program")
  check_program(${WORK}/elsewhere)
else()
  message(FATAL_ERROR "unknown step '${STEP}'")
endif()
