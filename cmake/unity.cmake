# SPDX-License-Identifier: GPL-3.0-or-later
# Sources of a room are compiled together, some in one translation unit, which reads their common headers once: most of
# the time that a source takes on its own goes there. The presets for development, sanitizers and clang-tidy compile each
# source on its own, where an error or a change concerns one source only and a missing #include is seen.
option(MESECINA_UNITY "Compile the sources of each room together, some at a time" ON)

# Sources of one translation unit at most. Twelve take 5 to 40 s and up to 1 GiB at -O2, which a change of one costs as well;
# of those that instantiate CGAL four take 45 s and 1.3 GiB, and the scripts start a compiler for each 2 GiB of memory.
set(mes_unity_batch 12)
set(mes_unity_batch_of_cgal 4)

# mes_unity_for(FOLDER TYPE): the targets of TYPE in FOLDER and in the folders below it, and those that are to be compiled
# together, unless they say themselves how. The translation units of a target get about as many sources each. A source that
# has options of its own stays alone.
function(mes_unity_for folder wanted)
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    get_target_property(is_unity ${target} UNITY_BUILD)
    get_target_property(is_together ${target} MESECINA_TOGETHER)
    if(is_unity OR NOT (type STREQUAL wanted OR is_together))
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
    mes_unity_for(${inner} "${wanted}")
  endforeach()
endfunction()

# Called when all targets are there.
function(mes_unity)
  if(MESECINA_UNITY)
    foreach(room IN ITEMS core render app)
      mes_unity_for(${PROJECT_SOURCE_DIR}/${room} STATIC_LIBRARY)
    endforeach()
    if(MESECINA_TESTS)
      mes_unity_for(${PROJECT_SOURCE_DIR}/tests "")
    endif()
  endif()
endfunction()
