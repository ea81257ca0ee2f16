# SPDX-License-Identifier: MIT
# cmake -D CASE=... -D SOURCE=... -D WORK=... -D GENERATOR=... -D COMPILER=... -P configure_test.cmake
#
# Configures Geodrome in WORK in one way. What comes out wrong ends in a FATAL_ERROR.

# Sets `said` and `status` in the caller's scope.
function(configure)
  file(REMOVE_RECURSE ${WORK})
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK} -G ${GENERATOR} -D CMAKE_CXX_COMPILER=${COMPILER}
    -D GEODROME_BUILD_TESTS=OFF -D GEODROME_BUILD_BENCH=OFF -D GEODROME_BUILD_PAGE=OFF ${ARGN}
    OUTPUT_VARIABLE out ERROR_VARIABLE out RESULT_VARIABLE result)
  string(REGEX REPLACE "[ \n]+" " " out "${out}")
  set(said "${out}" PARENT_SCOPE)
  set(status ${result} PARENT_SCOPE)
endfunction()

function(expect_said text)
  string(FIND "${said}" "${text}" place)
  if(place EQUAL -1)
    message(FATAL_ERROR "no '${text}' in\n${said}")
  endif()
endfunction()

# expect_left_out(<plugin>...): these, and none beside them.
function(expect_left_out)
  string(REGEX MATCHALL "(tangent|control|decimator|reconstructor|solver)_[a-z_]+ is left out" found "${said}")
  list(TRANSFORM found REPLACE " is left out" "")
  if(NOT status EQUAL 0 OR NOT "${found}" STREQUAL "${ARGN}")
    message(FATAL_ERROR "status ${status}, left out: ${found}\nbut should be: ${ARGN}\n${said}")
  endif()
endfunction()

if(CASE STREQUAL "choice")
  string(JOIN "\;" some control_constant decimator_none reconstructor_stars solver_chen_han tangent_pca tangent_jet)
  configure("-DGEODROME_PLUGINS=${some}")
  expect_left_out(control_lipschitz decimator_greedy reconstructor_advancing_front reconstructor_delaunay_cut
    solver_cgal solver_aleksandrov solver_edge_dijkstra solver_fast_marching solver_heat solver_merged_windows
    solver_schreiber tangent_pole)
  expect_said("solver_cgal is left out: GEODROME_PLUGINS does not name it")
elseif(CASE STREQUAL "core")
  configure(-DGEODROME_PLUGINS=solver_aleksandrov)
  expect_said("solver_aleksandrov is left out: GEODROME_PLUGINS does not name solver_chen_han")
elseif(CASE STREQUAL "unknown")
  configure("-DGEODROME_PLUGINS=solver_chen_han\;solver_cen_han")
  if(status EQUAL 0)
    message(FATAL_ERROR "an unknown plugin was taken\n${said}")
  endif()
  expect_said("there is no plugin 'solver_cen_han'")
  foreach(known tangent_jet control_constant decimator_none reconstructor_stars solver_chen_han)
    expect_said(${known})
  endforeach()
elseif(CASE STREQUAL "package")
  configure(-DCMAKE_DISABLE_FIND_PACKAGE_METIS=ON)
  expect_left_out(solver_aleksandrov)
  expect_said("solver_aleksandrov is left out: METIS::METIS was not found (Debian: libmetis-dev)")
elseif(CASE STREQUAL "part")
  configure(-DCMAKE_DISABLE_FIND_PACKAGE_OpenMesh=ON)
  expect_left_out(reconstructor_advancing_front reconstructor_delaunay_cut reconstructor_stars tangent_pole)
  expect_said("tangent_pole is left out: OpenMeshCore was not found (Debian: libopenmesh-dev)")
else()
  message(FATAL_ERROR "unknown case '${CASE}'")
endif()
