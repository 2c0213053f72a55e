#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds the fuzzers, and runs one of them or all, as many at a time as there are processors.
#
#   scripts/fuzz.sh [TARGET|all] [SECONDS]     default: all, 60 seconds each
#
# New inputs that reach something new are kept in build/fuzz/TARGET and are where the next run begins, beside
# tests/fuzz/corpus/TARGET. An input that breaks a promise ends the run with exit code 1 and stays in
# build/fuzz/findings. The environment variable SEED makes the choice of inputs the same again; RUNS ends a target after
# so many of them, if its seconds are not over before: then fast and slow machines try the same.
set -uo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

target=${1:-all}
seconds=${2:-60}
[[ $seconds =~ ^[0-9]+$ ]] || fail "'$seconds' is not a number of seconds"
mapfile -t known < <(cd tests/fuzz/corpus && printf '%s\n' *)
if [[ $target == all ]]; then
  targets=("${known[@]}")
else
  printf '%s\n' "${known[@]}" | grep -qxF -- "$target" || fail "there is no target '$target'; there are: ${known[*]}"
  targets=("$target")
fi

"$root/scripts/install_packages.sh" test || exit 1
configure asan -DMESECINA_WERROR=ON
build asan --target fuzzer

export seconds
export seed=${SEED:-$(date +%s)}
say "Fuzzing ${targets[*]} for $seconds seconds each, seed $seed ..."
fuzz_one() {
  local options=(--from "tests/fuzz/corpus/$1" --seconds "$seconds" --seed "$seed" --findings build/fuzz/findings)
  if [[ -n ${RUNS:-} ]]; then options+=(--runs "$RUNS"); fi
  if [[ -e tests/fuzz/dictionaries/$1.dict ]]; then options+=(--words "tests/fuzz/dictionaries/$1.dict"); fi
  mkdir -p "build/fuzz/$1"
  build/asan/fuzzer "$1" fuzz "build/fuzz/$1" "${options[@]}"
}
export -f fuzz_one
printf '%s\n' "${targets[@]}" | xargs -P "$(job_count)" -I{} bash -c 'fuzz_one {}' || {
  # The inputs as text too, for a machine of which only the output is kept.
  for finding in build/fuzz/findings/*; do
    say "$(basename "$finding"), in base64: $(base64 --wrap=0 "$finding")"
  done
  fail "there are findings in $root/build/fuzz/findings; build/asan/fuzzer TARGET replay FILE shows what they do"
}
