#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds the benchmark, and prints its table. Arguments are handed to it (--help lists them).
set -uo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

"$root/scripts/install_packages.sh" bench || exit 1
configure_program -DMESECINA_BENCH=ON
build release --target mesecina_bench
exec build/release/mesecina_bench "$@"
