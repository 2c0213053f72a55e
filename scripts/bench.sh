#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds the benchmark, and prints its table. Arguments are handed to it (--help lists them).
#
#   scripts/bench.sh python [axis|moves|columns|cluster ...]    prints the rows of the Python module instead
set -uo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

"$root/scripts/install_packages.sh" bench || exit 1
if [[ ${1:-} == python ]]; then
  "$root/scripts/install_packages.sh" python || exit 1
  configure_program -DMESECINA_PYTHON=ON -DPython3_EXECUTABLE=/usr/bin/python3
  build release --target mesecina_python mesecina
  PYTHONPATH=build/release/python exec /usr/bin/python3 tests/bench/python.py "${@:2}"
fi
configure_program -DMESECINA_BENCH=ON
build release --target mesecina mesecina_bench
exec build/release/mesecina_bench "$@"
