# SPDX-License-Identifier: GPL-3.0-or-later
# Sources of a library are compiled together, some in one translation unit, which reads their common headers once: most
# of the time that a source takes on its own goes there. So rooms that are used together are one library. The preset for
# development compiles each source on its own, since an error or a change concerns one source only; scripts/separate.sh
# checks that this works.
option(MESECINA_UNITY "Compile sources of each library together, some at a time" ON)

# mes_add_rooms(TARGET folder... [EXCEPT source...]): a static library of all sources in the folders, rooms of
# cmake/rooms.cmake.
function(mes_add_rooms target)
  cmake_parse_arguments(ARG "" "" "EXCEPT" ${ARGN})
  set(sources "")
  foreach(folder IN LISTS ARG_UNPARSED_ARGUMENTS)
    file(GLOB_RECURSE found CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cpp)
    list(APPEND sources ${found})
  endforeach()
  list(TRANSFORM ARG_EXCEPT PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  list(REMOVE_ITEM sources ${ARG_EXCEPT})
  add_library(${target} STATIC ${sources})
  cmake_path(RELATIVE_PATH CMAKE_CURRENT_SOURCE_DIR BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE here)
  list(TRANSFORM ARG_UNPARSED_ARGUMENTS PREPEND ${here}/ OUTPUT_VARIABLE folders)
  list(TRANSFORM folders REPLACE "/\\.$" "")
  set_target_properties(${target} PROPERTIES MESECINA_FOLDERS "${folders}")
  set_property(GLOBAL APPEND PROPERTY mes_libraries_of_rooms ${target})
endfunction()

# Sources of one translation unit at most. A unit of the program takes up to 1.6 GiB at -O2, and half a minute or more,
# also after a change of one source; sources of tests read precompiled headers and gain less. Of sources that
# instantiate triangulations of CGAL three take as much: those with the property MESECINA_TRIANGULATES, and tests that
# name CGAL. The scripts start a compiler for each 2 GiB of memory.
set(mes_unity_batch 46)
set(mes_unity_batch_of_tests 24)
set(mes_unity_batch_of_triangulations 3)

# The sources of the target are compiled together, about as many in each translation unit and at most `most` of them.
function(mes_compile_together target name most sources)
  list(LENGTH sources count)
  if(count LESS 2)
    return()
  endif()
  math(EXPR units "(${count} + ${most} - 1) / ${most}")
  math(EXPR batch "(${count} + ${units} - 1) / ${units}")
  set(place 0)
  foreach(source IN LISTS sources)
    math(EXPR unit "${place} / ${batch}")
    set_source_files_properties(${source} TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP ${name}_${unit})
    math(EXPR place "${place} + 1")
  endforeach()
  set_target_properties(${target} PROPERTIES MESECINA_UNITY ON UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()

# mes_unity_for(FOLDER TYPE MOST): the targets of TYPE in FOLDER and in the folders below it, and those that are to be
# compiled together, at most MOST sources at a time. A source that has options of its own stays alone.
function(mes_unity_for folder wanted most)
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    get_target_property(is_together ${target} MESECINA_TOGETHER)
    if(NOT (type STREQUAL wanted OR is_together))
      continue()
    endif()
    get_target_property(sources ${target} SOURCES)
    get_target_property(source_folder ${target} SOURCE_DIR)
    get_target_property(libraries ${target} LINK_LIBRARIES)
    set(rest "")
    set(triangulating "")
    foreach(name IN LISTS sources)
      cmake_path(ABSOLUTE_PATH name BASE_DIRECTORY ${source_folder} NORMALIZE OUTPUT_VARIABLE source)
      get_source_file_property(options ${source} TARGET_DIRECTORY ${target} COMPILE_OPTIONS)
      get_source_file_property(is_alone ${source} TARGET_DIRECTORY ${target} SKIP_UNITY_BUILD_INCLUSION)
      get_source_file_property(triangulates ${source} TARGET_DIRECTORY ${target} MESECINA_TRIANGULATES)
      if(NOT source MATCHES "\\.cpp$" OR options OR is_alone)
        continue()
      elseif(triangulates OR (is_together AND "dep_cgal" IN_LIST libraries))
        list(APPEND triangulating ${source})
      else()
        list(APPEND rest ${source})
      endif()
    endforeach()
    mes_compile_together(${target} triangulating ${mes_unity_batch_of_triangulations} "${triangulating}")
    mes_compile_together(${target} unit ${most} "${rest}")
  endforeach()
  get_property(folders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(inner IN LISTS folders)
    mes_unity_for(${inner} "${wanted}" ${most})
  endforeach()
endfunction()

# Called when all targets are there.
function(mes_unity)
  if(MESECINA_UNITY)
    foreach(room IN ITEMS core render app)
      mes_unity_for(${PROJECT_SOURCE_DIR}/${room} STATIC_LIBRARY ${mes_unity_batch})
    endforeach()
    if(MESECINA_TESTS)
      mes_unity_for(${PROJECT_SOURCE_DIR}/tests "" ${mes_unity_batch_of_tests})
    endif()
    if(MESECINA_PYTHON)
      mes_unity_for(${PROJECT_SOURCE_DIR}/python "" ${mes_unity_batch})
    endif()
  endif()
endfunction()
