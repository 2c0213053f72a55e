#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Starts the program from wherever this folder lies. What a desktop has is taken from there, as drivers of graphics cards
# use it too; where something is missing, as on a server, all of it comes from lib/desktop.
here=$(dirname -- "$(readlink -f -- "$0")")
if LD_TRACE_LOADED_OBJECTS=1 "$here/bin/mesecina" 2>&1 | grep -q 'not found'; then
  export LD_LIBRARY_PATH="$here/lib/desktop${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"
fi
# The database of PROJ is that of this folder, though the environment may name another one; its grids are found as well.
others=${PROJ_DATA:-${PROJ_LIB:-}}
export PROJ_DATA="$here/share/proj${others:+:$others}"
exec "$here/bin/mesecina" "$@"
