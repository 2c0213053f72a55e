# SPDX-License-Identifier: GPL-3.0-or-later
# The headers that most tests read, those of the standard library and Catch2, are compiled once, which takes a third off the
# time of their build. For the program, whose sources are compiled together, it was no gain; and GCC 12 takes code of
# precompiled system headers for ours, and warns falsely about copies of strings, which the tests ignore.
set(mes_common_headers <algorithm> <array> <atomic> <bit> <chrono> <cmath> <condition_variable> <cstdint> <deque>
  <expected> <filesystem> <fstream> <functional> <limits> <map> <memory> <mutex> <numeric> <optional> <set> <span>
  <sstream> <string> <string_view> <thread> <unordered_map> <utility> <variant> <vector>)

# mes_precompile_for(OWNER FOLDER [option...]): each target of FOLDER and the folders in it reads what OWNER has compiled,
# and is compiled with the options.
function(mes_precompile_for owner folder)
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    get_target_property(uncounted ${target} MESECINA_UNCOUNTED)
    if(type MATCHES "^(STATIC_LIBRARY|EXECUTABLE)$" AND NOT target STREQUAL owner AND NOT uncounted)
      target_precompile_headers(${target} REUSE_FROM ${owner})
      target_compile_options(${target} PRIVATE ${ARGN})
    endif()
  endforeach()
  get_property(folders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(inner IN LISTS folders)
    mes_precompile_for(${owner} ${inner} ${ARGN})
  endforeach()
endfunction()

# Called when all targets are there.
function(mes_precompile)
  if(MESECINA_TESTS)
    # What the tests call is the program, as its users have it; their own code is compiled for the time that takes.
    set(quick $<$<CONFIG:Release>:-O1>)
    target_precompile_headers(mes_test_headers PRIVATE ${mes_common_headers} <catch2/catch.hpp>)
    target_compile_options(mes_test_headers PRIVATE ${quick})
    mes_precompile_for(mes_test_headers ${PROJECT_SOURCE_DIR}/tests ${quick}
      -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread)
  endif()
endfunction()
