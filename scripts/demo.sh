#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Computes the pictures of the demo into build/demo and, where ffmpeg is installed, the video build/demo.mp4. Arguments
# are handed to the program, e.g. --size 1920x1080.
set -uo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

"$root/scripts/install_packages.sh" build || exit 1
options=()
if [[ ! -e build/release/CMakeCache.txt ]]; then options=(-DMESECINA_TESTS=OFF); fi
configure release "${options[@]}"
build release --target mesecina

rm -rf build/demo
output=(--frames build/demo)
if command -v ffmpeg >/dev/null; then output+=(--video build/demo.mp4); fi
build/release/mesecina demo "${output[@]}" "$@" || fail "the demo could not be made"
say "The pictures are in $root/build/demo."
if command -v ffmpeg >/dev/null; then
  say "The video is $root/build/demo.mp4."
else
  say "ffmpeg is not installed, so there is no video."
fi
