# SPDX-License-Identifier: GPL-3.0-or-later
# Which rooms there are, and which others each of them may include. A room is a folder; what lies in its folder
# `internal`, or in folders in it, is for that room only. Every room comes after those it uses, so no arrow leads back.
# A name stands for the room and for the rooms in its folder that come before. `core/*` stands for all rooms below core but
# core/builtins, which only app/main.cpp and the library name: everything else reads a registry that it is given. Run at each configuration, and as a test:
#
#   cmake -DROOT=. -P cmake/rooms.cmake
cmake_policy(VERSION 3.25)
set(rooms
  "core/base:"
  "core/base/jobs: core/base"
  "core/base/geometry: core/base"
  "core/kernel/numbers: core/base"
  "core/kernel: core/base"
  "core/draw: core/base"
  "core/curves: core/base"
  "core/curves/interpolation: core/base core/curves"
  "core/formula: core/base"
  "core/edit: core/base core/kernel"
  "core/raster: core/base core/curves"
  "core/glyphs: core/base core/curves"
  "core/document/settings: core/base core/kernel core/draw"
  "core/document: core/base core/kernel core/draw core/curves"
  "core/document/timeline: core/base core/document"
  "core/io/text: core/base core/document"
  "core/io/files: core/base"
  "core/io/xml: core/base core/io/text"
  "core/io/session: core/base core/curves core/document core/io/text core/io/files"
  "core/io/systems: core/base core/document core/io/text"
  "core/io: core/base core/curves core/raster core/document core/io/text core/io/files core/io/systems core/io/xml core/io/session"
  "core/io/drawings: core/base core/curves core/io/text core/io/xml core/io"
  "core/io/svg: core/base core/curves core/io/text core/io/xml core/io"
  "core/io/maps: core/base core/kernel core/curves core/io/text core/io/files core/io/systems core/io/xml core/io/session core/io"
  "core/io/meshes: core/base core/curves core/io/text core/io/files core/io"
  "core/io/tables: core/base core/document core/io/text core/io/files core/io core/io/meshes"
  "core/shapes: core/base core/formula core/curves core/document"
  "core/graph: core/base core/draw core/document"
  "core/structures/inputs: core/base core/document core/graph"
  "core/structures/triangulation: core/base core/kernel"
  "core/structures/delaunay: core/base core/kernel core/graph core/structures/inputs core/structures/triangulation"
  "core/structures/crust: core/base core/kernel core/graph core/structures/inputs core/structures/delaunay"
  "core/structures/axis: core/base core/graph core/structures/delaunay core/structures/crust"
  "core/structures/filters/paths: core/base"
  "core/structures/filters: core/base core/kernel core/graph core/structures/inputs core/structures/delaunay core/structures/crust core/structures/axis"
  "core/structures/density: core/base core/kernel core/curves core/document core/graph core/structures/inputs core/structures/delaunay core/structures/crust"
  "core/structures/alpha: core/base core/kernel core/graph core/structures/inputs core/structures/delaunay"
  "core/structures/certificate: core/base core/kernel core/graph core/structures/axis"
  "core/structures/balls: core/base core/kernel core/graph core/structures/inputs core/structures/triangulation core/structures/delaunay core/structures/crust core/structures/axis core/structures/alpha core/structures/filters core/structures/certificate"
  "core/structures/poles: core/base core/kernel core/graph core/structures/inputs core/structures/delaunay core/structures/crust core/structures/balls"
  "core/structures/outline: core/base core/kernel core/curves core/document core/graph core/structures/inputs core/structures/triangulation core/structures/delaunay core/structures/crust core/structures/axis core/structures/filters/paths"
  "core/layers/parts: core/graph core/structures/*"
  "core/layers/union: core/graph core/layers/parts core/structures/balls core/structures/poles"
  "core/layers: core/base core/draw core/graph core/layers/parts core/layers/union core/structures/*"
  "core/evolutions: core/base core/document core/graph core/structures/crust"
  "core/builtins: core/io core/io/* core/shapes core/graph core/layers core/evolutions core/structures/*"
  "core/engine: core/base core/draw core/document core/graph core/structures/inputs"
  "core/workbench: core/base core/kernel core/draw core/document core/io core/io/* core/graph core/engine"
  "core/resampling: core/base core/kernel core/curves core/document core/draw core/graph core/engine core/workbench core/evolutions core/structures/*"
  "core/library/mesecina:"
  "core/library: core/base core/kernel core/draw core/document core/io core/io/* core/shapes core/graph core/evolutions core/builtins core/engine core/workbench core/curves core/structures/inputs"
  "render/device: core/base core/draw"
  "render/image: core/base core/raster"
  "render/instances: core/base core/draw render/device"
  "render: core/base core/draw"
  "render/figure: core/base core/draw render"
  "app/system: core/base core/io core/io/*"
  "app/actions: core/base"
  "app/experiments: core/* app/system"
  "app/layers/words: core/*"
  "app/layers: core/*"
  "app/editing/places: core/*"
  "app/editing: core/* app/layers"
  "app/editing/curves: core/* app/layers app/editing app/system"
  "app/editing/tools: core/* app/editing"
  "app/settings: core/* app/editing app/system"
  "app/insight: core/* app/layers app/system"
  "app/playing: core/* app/layers app/editing app/insight"
  "app/panes: core/* app/layers app/editing app/playing app/system render"
  "app/store/looks: core/* app/layers app/system render"
  "app/store/texts: core/*"
  "app/store: core/* app/editing app/playing app/system render"
  "app/picture/paper: core/* app/layers app/panes app/settings render"
  "app/picture/annotations: core/* app/editing app/picture/paper"
  "app/picture: core/* app/layers app/editing app/panes app/settings render"
  "app/export: core/* app/layers app/editing app/playing app/panes app/settings app/picture app/store app/system render"
  "app/export/lessons: core/* app/layers app/playing app/settings app/picture app/store app/export render"
  "app/canvas/tools: core/base core/edit app/editing app/actions"
  "app/canvas: app/actions app/panes"
  "app/recording: core/* app/layers app/playing app/actions app/panes app/settings app/picture app/export app/system render"
  "app/ui/screen: core/* app/settings app/actions render"
  "app/ui/widgets: core/* app/actions app/ui/screen"
  "app/ui/dialogs: core/* app/system app/actions app/ui/*"
  "app/panels/dialogs/questions: core/* app/store app/ui/*"
  "app/panels/dialogs: core/* app/system app/actions app/layers app/editing app/store app/export app/ui/*"
  "app/panels/on_canvas/marks: core/* app/layers app/editing app/panes app/settings app/picture app/canvas app/ui/* render"
  "app/panels/on_canvas/cards: core/* app/panels/on_canvas/marks app/actions app/layers app/editing app/playing app/picture app/canvas app/ui/* render"
  "app/panels/on_canvas: core/* app/actions app/layers app/editing app/playing app/panes app/store app/picture app/canvas app/ui/*"
  "app/panels/pages: core/* app/actions app/experiments app/layers app/editing app/insight app/playing app/picture app/canvas app/ui/* app/panels/on_canvas"
  "app/panels/layers: core/* app/actions app/layers app/editing app/store app/picture app/canvas app/ui/* render"
  "app/panels/bars: core/* app/actions app/experiments app/layers app/editing app/insight app/playing app/settings app/store app/picture app/canvas app/recording app/ui/* render"
  "app/window/work: core/* app/actions app/panels/on_canvas app/ui/* app/layers app/editing app/insight app/playing app/panes app/settings app/store app/picture app/export app/canvas app/system"
  "app/window/runs: core/* app/actions app/experiments app/panels/dialogs app/panels/on_canvas app/ui/* app/playing app/panes app/settings app/store app/recording app/system app/window/work"
  "app/window/files: core/* app/actions app/panels/dialogs app/insight app/playing app/settings app/store app/export app/recording app/system render app/window/work app/window/runs"
  "app/window: core/* app/actions app/experiments app/panels/* app/ui/* app/layers app/editing app/playing app/settings app/store app/picture app/export app/canvas app/system"
  "app/cli/console: app/export app/system core/*"
  "app/cli/requests: core/* app/layers app/playing app/settings app/store app/export render app/cli/console"
  "app/cli/commands: core/* app/actions app/experiments app/layers app/editing app/insight app/playing app/store app/picture app/export app/recording render app/cli/console app/cli/requests"
  "app/cli/manual: core/* app/actions app/layers app/settings app/store app/picture app/export app/cli/console app/cli/requests app/cli/commands"
  "app/cli: core/* app/experiments app/store app/export"
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
  # What a room may include, as one regular expression; the rooms in its own folder that come before are among it.
  set(pattern "${room}")
  # All that lies below it, by room: what it may use, and what that may use.
  set(below_${room} ${room})
  string(REPLACE " " ";" allowed "${allowed}")
  foreach(other IN LISTS room allowed)
    string(REGEX REPLACE "/\\*$" "" folder "${other}")
    if(folder STREQUAL other)
      if(NOT (other IN_LIST known OR other STREQUAL room))
        list(APPEND problems "cmake/rooms.cmake: ${room} may use ${other}, which does not come before it")
      endif()
      foreach(inner IN LISTS known)
        if(inner MATCHES "^${other}(/|$)")
          string(APPEND pattern "|${inner}")
          list(APPEND below_${room} ${below_${inner}})
        endif()
      endforeach()
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
