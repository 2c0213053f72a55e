# SPDX-License-Identifier: GPL-3.0-or-later
# Flags of our own code, as one interface target that every room links.
add_library(mes_options INTERFACE)
target_include_directories(mes_options INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(mes_options INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wold-style-cast $<$<BOOL:${MESECINA_WERROR}>:-Werror>
  -ffp-contract=off)
# Names of files count from the sources, so that the program has the same bytes wherever it is built.
add_compile_options(-ffile-prefix-map=${PROJECT_SOURCE_DIR}/=)
# So do the folders in which libraries of the build are found: a path that is taken out when it is installed leaves its
# length behind.
set(CMAKE_BUILD_RPATH_USE_ORIGIN ON)
# A local name may be that of a constant of another source, which comes before it in a translation unit of several.
target_compile_options(mes_options INTERFACE $<$<NOT:$<BOOL:$<TARGET_PROPERTY:MESECINA_UNITY>>>:-Wshadow>)
target_compile_definitions(mes_options INTERFACE MESECINA_VERSION="${PROJECT_VERSION}")

# What was compiled before, in another clone or after a change that was taken back, comes from a cache where there is one.
# Paths count from the sources; what depends on where these lie, such as names of files in tests, is compiled again. Whether
# there is a cache is asked once for each build folder: one that is installed later would be a reason to compile all again.
if(NOT DEFINED CACHE{MESECINA_CCACHE})
  find_program(MESECINA_CCACHE ccache)
  if(NOT MESECINA_CCACHE)
    set(MESECINA_CCACHE "" CACHE FILEPATH "The program ccache; empty: none is used" FORCE)
  endif()
endif()
mark_as_advanced(MESECINA_CCACHE)
if(MESECINA_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1
    CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${MESECINA_CCACHE})
endif()

# GCC looks for memory that it can use again when half a GiB is taken, not a quarter of that, which is its own limit: this
# saves a tenth of the time, and the largest source takes 1.5 GiB instead of 1.4. Sanitizers add to that.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT MESECINA_SANITIZE)
  add_compile_options("SHELL:--param ggc-min-heapsize=524288")
endif()

# Predicates rely on plain IEEE doubles; release must not carry CGAL's own checks.
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG -DCGAL_NDEBUG")
set(CMAKE_CXX_FLAGS_DEBUG "-O1 -g1")

if(MESECINA_SANITIZE)
  add_compile_options(-fsanitize=${MESECINA_SANITIZE} -fno-omit-frame-pointer -g1)
  add_link_options(-fsanitize=${MESECINA_SANITIZE})
  # The instrumented code confuses these warnings: they fire inside the standard library.
  target_compile_options(mes_options INTERFACE -Wno-maybe-uninitialized -Wno-array-bounds -Wno-restrict
                         -Wno-stringop-overflow -Wno-stringop-overread)
  if(MESECINA_SANITIZE MATCHES "undefined")
    # Two checks at each access of a member take a quarter of the time to compile. Memory that is not there ends the program
    # under the address sanitizer as well, and pointers are cast between types of bytes only, which cannot lie misaligned.
    add_compile_options(-fno-sanitize-recover=undefined -fno-sanitize=null,alignment)
  endif()
elseif(NOT EMSCRIPTEN)
  # An error in memory ends the program before a file made for the purpose can use it. Sanitizers see more without
  # this; the checked functions of the C library come with optimisation only.
  add_compile_options(-fstack-protector-strong)
  string(APPEND CMAKE_CXX_FLAGS_RELEASE " -D_FORTIFY_SOURCE=2")
  add_link_options(-Wl,-z,relro,-z,now)
endif()

if(MESECINA_FUZZ)
  # The compiler counts which edges of the program are taken; tests/fuzz/driver says how. The counters themselves are
  # left out.
  target_compile_options(mes_options INTERFACE
    $<$<NOT:$<BOOL:$<TARGET_PROPERTY:MESECINA_UNCOUNTED>>>:-fsanitize-coverage=trace-pc>)
  target_link_libraries(mes_options INTERFACE mes_fuzz_coverage)
endif()
