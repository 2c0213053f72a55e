#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Checks that each source of the program and of the benchmark compiles on its own, with all warnings, and makes nothing.
#
#   scripts/separate.sh [PART/PARTS]     default: 1/1, all sources; 2/10: the second tenth of them
set -uo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

[[ ${1:-1/1} =~ ^([0-9]+)/([0-9]+)$ ]] || fail "'$1' is not PART/PARTS"
part=${BASH_REMATCH[1]}
parts=${BASH_REMATCH[2]}
((1 <= part && part <= parts)) || fail "there is no part $part of $parts"

"$root/scripts/install_packages.sh" bench || exit 1
configure separate -DMESECINA_WERROR=ON -DMESECINA_BENCH=ON
mapfile -t objects < <(ninja -C build/separate -t targets all | sed -n 's/\.cpp\.o:.*/.cpp.o/p' |
  awk -v part="$part" -v parts="$parts" 'NR % parts == part % parts')
build separate --target "${objects[@]}"
say "${#objects[@]} sources compile on their own."
