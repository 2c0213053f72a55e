# SPDX-License-Identifier: GPL-3.0-or-later
# Which rooms there are, and which others each of them may include. A room is a folder; what lies in its folder
# `internal`, or in folders in it, is for that room only. Every room comes after those it uses, so no arrow leads back.
# `core/*` stands for all rooms below core but core/builtins, which only app/main.cpp and the library name: everything
# else reads a registry that it is given. Run at each configuration, and as a test:
#
#   cmake -DROOT=. -P cmake/rooms.cmake
cmake_policy(VERSION 3.25)
set(rooms
  "core/base:"
  "core/kernel: core/base"
  "core/draw: core/base"
  "core/curves: core/base"
  "core/formula: core/base"
  "core/edit: core/base core/kernel"
  "core/raster: core/base core/curves"
  "core/glyphs: core/base core/curves"
  "core/document: core/base core/kernel core/draw core/curves"
  "core/io/text: core/base core/document"
  "core/io/files: core/base"
  "core/io/xml: core/base core/io/text"
  "core/io/session: core/base core/curves core/document core/io/text"
  "core/io/systems: core/base core/document core/io/text"
  "core/io: core/base core/curves core/raster core/document core/io/text core/io/files core/io/systems core/io/xml core/io/session"
  "core/io/drawings: core/base core/curves core/io/text core/io/xml core/io"
  "core/io/svg: core/base core/curves core/io/text core/io/xml core/io"
  "core/io/maps: core/base core/curves core/io/text core/io/files core/io/systems core/io/xml core/io/session core/io"
  "core/io/meshes: core/base core/curves core/io/text core/io/files core/io"
  "core/io/tables: core/base core/document core/io/text core/io/files core/io core/io/meshes"
  "core/shapes: core/base core/formula core/curves core/document"
  "core/graph: core/base core/draw core/document"
  "core/structures/inputs: core/base core/document core/graph"
  "core/structures/triangulation: core/base core/kernel"
  "core/structures/delaunay: core/base core/kernel core/graph core/structures/inputs core/structures/triangulation"
  "core/structures/crust: core/base core/kernel core/graph core/structures/inputs core/structures/delaunay"
  "core/structures/axis: core/base core/graph core/structures/delaunay core/structures/crust"
  "core/structures/filters: core/base core/kernel core/graph core/structures/inputs core/structures/delaunay core/structures/crust core/structures/axis"
  "core/structures/density: core/base core/kernel core/curves core/document core/graph core/structures/inputs core/structures/delaunay core/structures/crust"
  "core/structures/alpha: core/base core/kernel core/graph core/structures/inputs core/structures/delaunay"
  "core/structures/certificate: core/base core/kernel core/graph core/structures/axis"
  "core/structures/balls: core/base core/kernel core/graph core/structures/inputs core/structures/triangulation core/structures/delaunay core/structures/crust core/structures/axis core/structures/alpha core/structures/filters core/structures/certificate"
  "core/structures/poles: core/base core/kernel core/graph core/structures/inputs core/structures/delaunay core/structures/crust core/structures/balls"
  "core/structures/outline: core/base core/kernel core/curves core/document core/graph core/structures/inputs core/structures/triangulation core/structures/delaunay core/structures/crust core/structures/axis"
  "core/layers/parts: core/graph core/structures/*"
  "core/layers/union: core/layers/parts core/structures/balls"
  "core/layers: core/base core/draw core/graph core/layers/parts core/layers/union core/structures/*"
  "core/evolutions: core/base core/document core/graph core/structures/crust"
  "core/builtins: core/io core/io/* core/shapes core/graph core/layers core/evolutions core/structures/*"
  "core/engine: core/base core/draw core/document core/graph core/structures/inputs"
  "core/workbench: core/base core/kernel core/draw core/document core/io core/io/* core/graph core/engine"
  "core/resampling: core/base core/kernel core/curves core/document core/draw core/graph core/engine core/workbench core/evolutions core/structures/*"
  "core/library/mesecina:"
  "core/library: core/base core/kernel core/draw core/document core/io core/io/* core/shapes core/graph core/evolutions core/builtins core/engine core/workbench core/curves core/structures/inputs"
  "render: core/base core/raster core/draw"
  "render/figure: core/base core/draw render"
  "app/system: core/base core/io core/io/*"
  "app/actions: core/base"
  "app/experiments: core/* app/system"
  "app/layers: core/*"
  "app/editing: core/* app/layers app/system"
  "app/settings: core/* app/editing app/system"
  "app/insight: core/* app/layers app/system"
  "app/playing: core/* app/layers app/editing app/insight"
  "app/panes: core/* app/layers app/editing app/playing app/system render"
  "app/store: core/* app/layers app/editing app/playing app/system render"
  "app/picture: core/* app/layers app/editing app/panes app/settings render render/figure"
  "app/export: core/* app/layers app/editing app/playing app/panes app/settings app/picture app/store app/system render render/figure"
  "app/canvas/tools: core/base core/edit app/editing app/actions"
  "app/canvas: app/panes app/canvas/tools"
  "app/recording: core/* app/layers app/playing app/actions app/panes app/settings app/picture app/export app/system render"
  "app/ui: core/* app/settings app/actions app/canvas app/system render"
  "app/panels/dialogs: core/* app/system app/actions app/layers app/editing app/store app/export app/ui"
  "app/panels/on_canvas: core/* app/actions app/layers app/editing app/playing app/panes app/settings app/store app/picture app/canvas/tools app/canvas app/ui render"
  "app/panels/pages: core/* app/actions app/experiments app/layers app/editing app/insight app/playing app/picture app/canvas app/ui app/panels/on_canvas"
  "app/panels/layers: core/* app/actions app/layers app/editing app/store app/picture app/canvas app/ui render"
  "app/panels/bars: core/* app/actions app/experiments app/layers app/editing app/insight app/playing app/settings app/store app/picture app/canvas app/recording app/ui render"
  "app/window: core/* app/experiments app/panels/* app/ui app/layers app/editing app/insight app/playing app/panes app/settings app/store app/picture app/export app/canvas app/canvas/tools app/recording app/actions app/system render"
  "app/cli: core/* app/experiments app/layers app/editing app/insight app/playing app/settings app/store app/picture app/export app/recording app/actions app/system render render/figure"
  "app: app/cli app/window core/base core/builtins")

if(NOT DEFINED ROOT)
  set(ROOT ${PROJECT_SOURCE_DIR})
endif()

set(known "")
set(problems "")
foreach(line IN LISTS rooms)
  string(REGEX MATCH "^([^:]+):(.*)$" matched "${line}")
  set(room ${CMAKE_MATCH_1})
  string(STRIP "${CMAKE_MATCH_2}" allowed)
  # What a room may include, as one regular expression; `core/*` is every room below core that is listed above,
  # but core/builtins.
  set(pattern "${room}")
  # All that lies below it, by room: what it may use, and what that may use.
  set(below_${room} ${room})
  string(REPLACE " " ";" allowed "${allowed}")
  foreach(other IN LISTS allowed)
    string(REGEX REPLACE "/\\*$" "" folder "${other}")
    if(folder STREQUAL other)
      if(NOT other IN_LIST known)
        list(APPEND problems "cmake/rooms.cmake: ${room} may use ${other}, which does not come before it")
      endif()
      string(APPEND pattern "|${other}")
      list(APPEND below_${room} ${below_${other}})
    else()
      foreach(below IN LISTS known)
        if(below MATCHES "^${folder}/" AND NOT below STREQUAL "core/builtins")
          string(APPEND pattern "|${below}")
          list(APPEND below_${room} ${below_${below}})
        endif()
      endforeach()
    endif()
  endforeach()
  list(REMOVE_DUPLICATES below_${room})
  list(APPEND known ${room})

  file(GLOB sources ${ROOT}/${room}/*.h ${ROOT}/${room}/*.cpp)
  file(GLOB_RECURSE internal ${ROOT}/${room}/internal/*.h ${ROOT}/${room}/internal/*.cpp)
  list(APPEND sources ${internal})
  if(sources STREQUAL "")
    list(APPEND problems "cmake/rooms.cmake: ${room} is empty")
  endif()
  foreach(source IN LISTS sources)
    file(STRINGS ${source} includes REGEX "^#include \"(app|core|render)/")
    foreach(include IN LISTS includes)
      string(REGEX REPLACE "^#include \"(.*)/[^/]*\".*$" "\\1" used "${include}")
      string(REGEX REPLACE "^${room}/internal(/.*)?$" "${room}" used "${used}")
      if(NOT used MATCHES "^(${pattern})$")
        file(RELATIVE_PATH name ${ROOT} ${source})
        list(APPEND problems "${name}: ${room} may not include from ${used}")
      endif()
    endforeach()
  endforeach()
endforeach()

file(GLOB_RECURSE everything RELATIVE ${ROOT} ${ROOT}/app/*.h ${ROOT}/app/*.cpp ${ROOT}/core/*.h ${ROOT}/core/*.cpp
     ${ROOT}/render/*.h ${ROOT}/render/*.cpp)
foreach(source IN LISTS everything)
  get_filename_component(room ${source} DIRECTORY)
  string(REGEX REPLACE "/internal(/.*)?$" "" room "${room}")
  if(NOT room IN_LIST known)
    list(APPEND problems "${source}: ${room} is not a room of cmake/rooms.cmake")
  endif()
endforeach()

if(problems)
  list(REMOVE_DUPLICATES problems)
  list(JOIN problems "\n  " text)
  message(FATAL_ERROR "Includes against the arrows between rooms:\n  ${text}")
endif()
