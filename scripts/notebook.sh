#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds the Python module, and opens a notebook. Arguments are handed to Jupyter.
#
#   scripts/notebook.sh             the first steps
#   scripts/notebook.sh mine.ipynb  a notebook of one's own
set -uo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
start_folder=$OLDPWD

"$root/scripts/install_packages.sh" notebook || exit 1
configure_program -DMESECINA_PYTHON=ON -DPython3_EXECUTABLE=/usr/bin/python3
build release --target mesecina_python mesecina

cd "$start_folder" || exit 1 # file names in the arguments are relative to where the user stands
if (($# == 0)); then set -- "$root/examples/python/first_steps.ipynb"; fi
if ((EUID == 0)); then set -- --allow-root "$@"; fi
PYTHONPATH=$root/build/release/python exec /usr/bin/python3 -m notebook "$@"
