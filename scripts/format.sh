#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Says which sources are not formatted as .clang-format says, and where; with --fix, formats them.
set -uo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

case ${1:-} in
  '') task=(--dry-run --Werror) ;;
  --fix) task=(-i) ;;
  *) fail "unknown option '$1'; there is --fix" ;;
esac

"$root/scripts/install_packages.sh" format || exit 1
find app core examples python render tests web \( -name '*.cpp' -o -name '*.h' \) -print0 |
  xargs -0 -n 32 -P "$(nproc)" clang-format-14 "${task[@]}" || fail "sources are not formatted; scripts/format.sh --fix does it"
