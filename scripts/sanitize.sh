#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs tests under sanitizers. Arguments after the first are handed to CTest.
#
#   scripts/sanitize.sh [asan]     address and undefined behaviour, all three of the following
#   scripts/sanitize.sh files      ... documents, files, inputs of the fuzzers
#   scripts/sanitize.sh geometry   ... exactness
#   scripts/sanitize.sh window     ... the window's model
#   scripts/sanitize.sh tsan       threads: the engine, saving and recording; before a release
#   scripts/sanitize.sh python     address and undefined behaviour in the Python module; before a release
set -uo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

kind=${1:-asan}
if (($# > 0)); then shift; fi
options=()
case $kind in
  asan)
    targets=(test_document test_exactness test_io test_model fuzzer)
    # What takes minutes under a sanitizer without reaching other code is left to the release.
    tests='^(test_document|test_exactness|test_io|test_model|fuzz)\.'
    ;;
  files)
    kind=asan
    targets=(test_document test_io fuzzer)
    tests='^(test_document|test_io|fuzz)\.'
    ;;
  geometry)
    kind=asan
    targets=(test_exactness)
    tests='^test_exactness\.'
    ;;
  window)
    kind=asan
    targets=(test_model)
    tests='^test_model\.'
    ;;
  tsan)
    targets=(test_document test_engine test_model)
    tests='^(test_document|test_engine|test_model)\.'
    ;;
  python)
    kind=asan
    options=(-DMESECINA_PYTHON=ON -DPython3_EXECUTABLE=/usr/bin/python3)
    targets=(mesecina_python mesecina)
    tests='^python\.test_(experiments|input|results|views)$'
    ;;
  *) fail "unknown kind '$kind'; there are asan, files, geometry, window, tsan and python" ;;
esac

"$root/scripts/install_packages.sh" test || exit 1
configure "$kind" -DMESECINA_WERROR=ON "${options[@]}"
build "$kind" --target "${targets[@]}"
exec ctest --test-dir "build/$kind" --output-on-failure --parallel "$(job_count)" --tests-regex "$tests" "$@"
