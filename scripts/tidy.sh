#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Checks sources with clang-tidy as .clang-tidy says; those that its clang cannot parse are counted and left out.
#
#   scripts/tidy.sh [FILE...]     default: everything in app, core and render
#
# CLANG_TIDY names another program than clang-tidy-14.
set -uo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

"$root/scripts/install_packages.sh" build || exit 1
if [[ -z ${CLANG_TIDY:-} ]]; then "$root/scripts/install_packages.sh" tidy || exit 1; fi
export tidy=${CLANG_TIDY:-clang-tidy-14}
configure separate -DMESECINA_WERROR=OFF
files=("$@")
if ((${#files[@]} == 0)); then mapfile -t files < <(git ls-files 'app/*.cpp' 'core/*.cpp' 'render/*.cpp'); fi

check() {
  local said
  # The build is for GCC, whose names of standard and warnings a clang may not know.
  said=$("$tidy" --quiet -p build/separate --extra-arg=-std=c++2b --extra-arg=-Wno-unknown-warning-option "$1" 2>/dev/null)
  # An error of the parser hides what the checks would say.
  if [[ $said == *'[clang-diagnostic-error]'* ]]; then
    echo "unparsed $1"
  elif [[ -n $said ]]; then
    printf '%s\n' "$said" >&2
    echo "faulty $1"
  else
    echo "good $1"
  fi
}
export -f check
results=$(printf '%s\0' "${files[@]}" | xargs -0 -P "$(job_count)" -I{} bash -c 'check {}')
say "$(grep -c '^good' <<<"$results") good, $(grep -c '^unparsed' <<<"$results") not parsed by $tidy."
if grep -q '^faulty' <<<"$results"; then fail "clang-tidy complains"; fi
grep -q '^good' <<<"$results" || fail "no file could be checked"
