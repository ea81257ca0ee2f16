# geodrome_add_plugin(<stage>_<name> SOURCES file... [LIBRARIES target...])
#
# A plugin: a shared library named after its target that exports nothing but its entry and is complete in itself
# (--no-undefined). Where GEODROME_PLUGIN_OUTPUT_DIR is set it is built there, otherwise into <build>/lib/geodrome, so
# that `geodrome --plugin-path <build>/lib/geodrome` finds it; where GEODROME_PLUGIN_INSTALL_DIR is set it is installed.
function(geodrome_add_plugin name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBRARIES")
  if(NOT arg_SOURCES OR arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "geodrome_add_plugin(${name}): give SOURCES and, if needed, LIBRARIES")
  endif()
  if(NOT name MATCHES "^(tangent|control|decimator|reconstructor|solver)_[a-z0-9_]+$")
    message(FATAL_ERROR "geodrome_add_plugin(${name}): the name starts with its stage: solver_${name}, ...")
  endif()
  set(output ${GEODROME_PLUGIN_OUTPUT_DIR})
  if(NOT output)
    set(output ${CMAKE_BINARY_DIR}/lib/geodrome)
  endif()

  add_library(${name} MODULE ${arg_SOURCES})
  set_property(GLOBAL APPEND PROPERTY GEODROME_PLUGINS ${name})
  target_link_libraries(${name} PRIVATE geodrome::interfaces ${arg_LIBRARIES})
  target_link_options(${name} PRIVATE -Wl,--no-undefined)
  set_target_properties(${name} PROPERTIES
    PREFIX "" CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON LIBRARY_OUTPUT_DIRECTORY ${output})
  if(TARGET geodrome_build_flags)
    target_link_libraries(${name} PRIVATE geodrome_build_flags)
  endif()
  if(GEODROME_PLUGIN_INSTALL_DIR)
    install(TARGETS ${name} LIBRARY DESTINATION ${GEODROME_PLUGIN_INSTALL_DIR})
  endif()
endfunction()
