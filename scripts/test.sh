#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds, and runs every test. Arguments are handed to CTest, e.g. -R render.
set -uo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

"$root/scripts/install_packages.sh" test || exit 1
# The interpreter whose packages were installed, not another one that comes first in the path.
configure release -DMESECINA_TESTS=ON -DMESECINA_WERROR=ON -DMESECINA_PYTHON=ON -DPython3_EXECUTABLE=/usr/bin/python3
build release
exec ctest --test-dir build/release --output-on-failure --parallel "$(job_count)" "$@"
