# A library that the Python module holds is loaded at run time. Nobody replaces a function of it, so that it is as quick as any.
function(toile_make_loadable target)
  if(TOILE_ENABLE_PYTHON)
    set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_compile_options(${target} PRIVATE -fno-semantic-interposition)
  endif()
endfunction()

# toile_package(<name> USES <packages...> USES_LIBRARIES <third-party...> PRIVATE_LIBRARIES <third-party...>)
#
# PRIVATE_LIBRARIES are used in sources only; their compile options do not reach other packages.
# One static library toile_<name> from src/*.cpp. A source or header of the package may include
# headers of the packages in USES and of no other, and includes some of each: the build fails otherwise.
function(toile_package name)
  cmake_parse_arguments(arg "" "" "USES;USES_LIBRARIES;PRIVATE_LIBRARIES" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/src/*.cpp" "${CMAKE_CURRENT_SOURCE_DIR}/src/*/*.cpp")
  if(NOT sources)
    add_library(toile_${name} INTERFACE)
    target_include_directories(toile_${name} INTERFACE "${CMAKE_CURRENT_SOURCE_DIR}/include")
    list(TRANSFORM arg_USES_LIBRARIES PREPEND toile_lib_)
    target_link_libraries(toile_${name} INTERFACE ${arg_USES_LIBRARIES} toile_options)
    toile_check_dependencies(${name} "${arg_USES}")
    return()
  endif()
  add_library(toile_${name} STATIC ${sources})
  toile_check_dependencies(${name} "${arg_USES}")
  toile_make_loadable(toile_${name})
  target_include_directories(toile_${name} PUBLIC "${CMAKE_CURRENT_SOURCE_DIR}/include")
  list(TRANSFORM arg_USES PREPEND toile_)
  list(TRANSFORM arg_USES_LIBRARIES PREPEND toile_lib_)
  list(TRANSFORM arg_PRIVATE_LIBRARIES PREPEND toile_lib_)
  target_link_libraries(toile_${name} PRIVATE ${arg_PRIVATE_LIBRARIES})
  target_link_libraries(toile_${name} PUBLIC ${arg_USES} ${arg_USES_LIBRARIES} toile_options)
  set_property(GLOBAL APPEND PROPERTY TOILE_PACKAGES ${name})
endfunction()

# The check runs when a file of the package has changed.
function(toile_check_dependencies name uses)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/include/*.hpp" "${CMAKE_CURRENT_SOURCE_DIR}/src/*.hpp"
    "${CMAKE_CURRENT_SOURCE_DIR}/src/*.cpp" "${CMAKE_CURRENT_SOURCE_DIR}/src/*/*.cpp")
  set(script "${PROJECT_SOURCE_DIR}/cmake/CheckDependencies.cmake")
  set(stamp "${CMAKE_CURRENT_BINARY_DIR}/dependencies.checked")
  string(REPLACE ";" "," uses "${uses}")
  add_custom_command(OUTPUT "${stamp}"
    COMMAND ${CMAKE_COMMAND} -DPACKAGE=${name} "-DFOLDER=${CMAKE_CURRENT_SOURCE_DIR}" "-DUSES=${uses}" "-DSTAMP=${stamp}" -P "${script}"
    DEPENDS ${files} "${script}" "${CMAKE_CURRENT_SOURCE_DIR}/CMakeLists.txt" COMMENT "Dependencies of package ${name}" VERBATIM)
  add_custom_target(toile_${name}_dependencies DEPENDS "${stamp}")
  add_dependencies(toile_${name} toile_${name}_dependencies)
endfunction()

# Adds packages/<name>; if it was switched off by TOILE_ENABLE_<NAME>, its stand-in packages/<name>/off, which needs none
# of the package's libraries and refuses what it lacks.
function(toile_add_package name)
  string(TOUPPER "TOILE_ENABLE_${name}" switch)
  if(NOT DEFINED ${switch} OR ${switch})
    add_subdirectory(packages/${name})
  else()
    add_subdirectory(packages/${name}/off)
  endif()
endfunction()
