# geodrome_add_plugin_part(<name> file...): code of a plugin that others of its kind share or tests reach, linked
# statically into the plugin, so that a plugin stays one file that exports nothing but its entry. Built where something
# that is built needs it.
function(geodrome_add_plugin_part name)
  add_library(${name} STATIC EXCLUDE_FROM_ALL ${ARGN})
  set_target_properties(${name} PROPERTIES
    POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  target_link_libraries(${name} PRIVATE geodrome_build_flags)
endfunction()

# geodrome_needs(<name> <target> [<package>]): where <target> is not there, leaves the plugin or part <name> out, which
# the caller's CMakeLists.txt makes, and says why. <package>: the Debian package that <target> comes from; without it,
# <target> is a part that may have been left out itself, for want of a package that is then named.
macro(geodrome_needs name target)
  if(NOT TARGET ${target})
    geodrome_leave_out(${name} ${target} ${ARGN})
    return()
  endif()
endmacro()

function(geodrome_leave_out name target)
  if(ARGN)
    set(reason "${target} was not found (Debian: ${ARGN})")
  else()
    get_property(reason GLOBAL PROPERTY GEODROME_LEFT_OUT_${target})
  endif()
  set_property(GLOBAL PROPERTY GEODROME_LEFT_OUT_${name} "${reason}")
  message(STATUS "${name} is left out: ${reason}")
endfunction()
