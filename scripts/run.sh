#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds, and opens the window. Arguments are handed to the program.
#
#   scripts/run.sh                        the window with a sample shape
#   scripts/run.sh my_points.csv          the window with a file
#   scripts/run.sh render a.poff -o a.png any command of the program
#
# Without a display and without arguments it renders the first sample shape into a picture instead.
set -uo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
start_folder=$OLDPWD

"$root/scripts/install_packages.sh" build || exit 1
configure_program
build release --target mesecina

program=$root/build/release/mesecina
if (($# == 0)) && [[ -z ${DISPLAY:-} && -z ${WAYLAND_DISPLAY:-} ]]; then
  shape=$(sed -n 's/.*"file": *"\([^"]*\)".*/\1/p' assets/shapes/index.json | head -n 1)
  picture=$root/build/first-picture.png
  say "No display: rendering the sample shape $shape instead of opening the window."
  "$program" render "assets/shapes/$shape" --layers interior-voronoi-disks,curve,medial-axis,points \
    --size 1600x1200 -o "$picture" || fail "the picture could not be made"
  say "The picture is $picture; $program --help lists the commands."
  exit 0
fi
cd "$start_folder" || exit 1 # file names in the arguments are relative to where the user stands
exec "$program" "$@"
