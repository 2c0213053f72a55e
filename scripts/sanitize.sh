#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs tests under sanitizers. Arguments after the first are handed to CTest.
#
#   scripts/sanitize.sh [asan]     address and undefined behaviour: geometry, files, the window's model, inputs of fuzzers
#   scripts/sanitize.sh tsan       threads: the engine, saving and recording; before a release
set -uo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

kind=${1:-asan}
if (($# > 0)); then shift; fi
case $kind in
  asan)
    targets=(test_document test_exactness test_io test_model fuzzer)
    # What takes minutes under a sanitizer without reaching other code is left to the release.
    tests='^(test_document|test_exactness|test_io|test_model|fuzz)\.'
    ;;
  tsan)
    targets=(test_document test_engine test_failures test_model)
    tests='^(test_document|test_engine|test_failures|test_model)\.'
    ;;
  *) fail "unknown kind '$kind'; there are asan and tsan" ;;
esac

"$root/scripts/install_packages.sh" test || exit 1
configure "$kind" -DMESECINA_WERROR=ON
build "$kind" --target "${targets[@]}"
exec ctest --test-dir "build/$kind" --output-on-failure --parallel "$(job_count)" --tests-regex "$tests" "$@"
