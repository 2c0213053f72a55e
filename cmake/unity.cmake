# SPDX-License-Identifier: GPL-3.0-or-later
# Sources of a room are compiled together, some in one translation unit, which reads their common headers once: most of
# the time that a source takes on its own goes there. The presets for development, sanitizers and clang-tidy compile each
# source on its own, where an error or a change concerns one source only and a missing #include is seen.
option(MESECINA_UNITY "Compile the sources of each room together, some at a time" ON)

set(mes_unity_batch 12)
set(mes_unity_batch_of_cgal 4)

# mes_unity_for(FOLDER): the targets of FOLDER and of the folders in it, unless they say themselves how they are compiled.
# All translation units of a target get as many sources, or one less. What a source has options of its own for stays alone.
function(mes_unity_for folder)
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    get_target_property(is_unity ${target} UNITY_BUILD)
    if(NOT type STREQUAL "STATIC_LIBRARY" OR is_unity)
      continue()
    endif()
    get_target_property(sources ${target} SOURCES)
    set(together 0)
    foreach(source IN LISTS sources)
      get_source_file_property(options ${source} TARGET_DIRECTORY ${target} COMPILE_OPTIONS)
      get_source_file_property(is_alone ${source} TARGET_DIRECTORY ${target} SKIP_UNITY_BUILD_INCLUSION)
      if(source MATCHES "\\.cpp$" AND NOT options AND NOT is_alone)
        math(EXPR together "${together} + 1")
      endif()
    endforeach()
    get_target_property(libraries ${target} LINK_LIBRARIES)
    set(most ${mes_unity_batch})
    if("dep_cgal" IN_LIST libraries)
      set(most ${mes_unity_batch_of_cgal})
    endif()
    if(together GREATER 1)
      math(EXPR units "(${together} + ${most} - 1) / ${most}")
      math(EXPR batch "(${together} + ${units} - 1) / ${units}")
      set_target_properties(${target} PROPERTIES MESECINA_UNITY ON UNITY_BUILD ON
        UNITY_BUILD_BATCH_SIZE ${batch})
    endif()
  endforeach()
  get_property(folders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(inner IN LISTS folders)
    mes_unity_for(${inner})
  endforeach()
endfunction()

# Called when all targets are there.
function(mes_unity)
  if(MESECINA_UNITY)
    foreach(room IN ITEMS core render app)
      mes_unity_for(${PROJECT_SOURCE_DIR}/${room})
    endforeach()
  endif()
endfunction()
