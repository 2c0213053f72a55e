# SPDX-License-Identifier: GPL-3.0-or-later
# mes_add_tests(NAME [TOGETHER] source...): a Catch2 executable whose source files are one CTest test each, chosen by file tag.
# `#` tags need no list of test names kept anywhere: Catch2's -# option tags each case with its file name.
# Names of its sources are unique where they may be compiled TOGETHER (cmake/unity.cmake).
# Those of tests/slow_tests.txt begin first, so that no processor is left with a long one at the end.
file(STRINGS ${PROJECT_SOURCE_DIR}/tests/slow_tests.txt mes_slow_tests REGEX "^[0-9]")
function(mes_add_tests name)
  cmake_parse_arguments(ARG "TOGETHER" "TIMEOUT" "SOURCES;LINK;ENVIRONMENT" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 600)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE mes_test_main ${ARG_LINK})
  set_target_properties(${name} PROPERTIES MESECINA_TOGETHER ${ARG_TOGETHER})
  foreach(source IN LISTS ARG_SOURCES)
    get_filename_component(unit ${source} NAME_WE)
    add_test(NAME ${name}.${unit} COMMAND ${name} -\# "[#${unit}]" WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
    set_tests_properties(${name}.${unit} PROPERTIES TIMEOUT ${ARG_TIMEOUT} SKIP_RETURN_CODE 77)
    if("${mes_slow_tests}" MATCHES "([0-9]+) ${name}\\.${unit}(;|$)")
      set_tests_properties(${name}.${unit} PROPERTIES COST ${CMAKE_MATCH_1})
    endif()
    if(ARG_ENVIRONMENT)
      set_tests_properties(${name}.${unit} PROPERTIES ENVIRONMENT "${ARG_ENVIRONMENT}")
    endif()
  endforeach()
endfunction()
