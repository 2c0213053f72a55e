#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Checks that what a room uses is defined in it or in a room below: no function is declared in one and defined in another
# that the first may not use.
#
#   definitions_point_down.sh LIBRARY=LIBRARY,LIBRARY,...     a static library of rooms, and those that it may use
set -uo pipefail

# The symbols of the namespace in each library: D where it is defined, U where it is used and not defined. What is inline
# is defined wherever it is used.
symbols() {
  local library
  for library in "${@%%=*}"; do
    nm --format=posix "$library" 2>/dev/null |
      awk -v library="$library" '$1 ~ /^_ZN?K?3mes/ && NF > 1 { print ($2 == "U" ? "U" : "D"), library, $1 }'
  done
}

problems=$({
  for arrow in "$@"; do printf 'A %s %s\n' "${arrow%%=*}" "${arrow#*=}"; done
  symbols "$@"
} | awk '
  $1 == "A" { for (i = split($3, below, ","); i > 0; --i) may_use[$2, below[i]] = 1 }
  $1 == "D" { definers[$3] = definers[$3] " " $2 }
  $1 == "U" { users[++count] = $2; used[count] = $3 }
  END {
    for (i = 1; i <= count; ++i) {
      # No library of rooms defines it: it is of a generated file, or of a template.
      if (!(used[i] in definers)) continue
      known++
      is_below = 0
      for (j = split(definers[used[i]], all, " "); j > 0; --j) if ((users[i], all[j]) in may_use) is_below = 1
      if (!is_below && !said[users[i], used[i]]++) print users[i], all[1], used[i]
    }
    if (known < 1000) print "libraries", "symbols", "too-few"
  }')
[[ -z $problems ]] && exit 0
while read -r user definer symbol; do
  echo "$(basename "$user") uses $(c++filt "$symbol"), which is defined in $(basename "$definer")"
done <<<"$problems"
exit 1
