#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds the soak test, and makes so many random edits (100000 unless given), comparing the
# picture with a fresh computation all along. Arguments are handed to it: soak.sh [EDITS] [--seed FIRST].
set -uo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

"$root/scripts/install_packages.sh" test || exit 1
configure release -DMESECINA_TESTS=ON -DMESECINA_WERROR=ON
build release --target soak
exec build/release/soak "$@"
