# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# Sourced by the other scripts: where the project is, how to say things, and how many compilers fit this machine.
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root" || exit 1

say() { printf '%s\n' "$*" >&2; }
fail() {
  say "$(basename "$0"): $*"
  exit 1
}

# As many jobs as processors, but none without 2 GiB: a CGAL file takes more than one.
job_count() {
  local processors bytes limit
  processors=$(nproc)
  bytes=$(awk '/^MemTotal:/ { printf "%.0f", $2 * 1024 }' /proc/meminfo)
  limit=$(cat /sys/fs/cgroup/memory.max 2>/dev/null)
  if [[ $limit =~ ^[0-9]+$ ]] && ((limit < bytes)); then bytes=$limit; fi
  local fitting=$((bytes / (2 * 1024 * 1024 * 1024)))
  if ((fitting < 1)); then fitting=1; fi
  echo $((fitting < processors ? fitting : processors))
}

# configure PRESET [option...]
configure() {
  local preset=$1 log
  log=build/$preset-configure.log
  mkdir -p build
  shift
  if ! cmake --preset "$preset" "$@" >"$log" 2>&1; then
    cat "$log" >&2
    fail "cmake could not configure the $preset build"
  fi
}

# configure_program [option...]: the release. A fresh build folder needs no tests; one that has them keeps them.
configure_program() {
  local options=()
  if [[ ! -e build/release/CMakeCache.txt ]]; then options=(-DMESECINA_TESTS=OFF); fi
  configure release "${options[@]}" "$@"
}

# build PRESET [cmake --build option...]
build() {
  local preset=$1 count
  count=$(job_count)
  shift
  say "Building $PWD/build/$preset with $count job(s) ..."
  cmake --build "build/$preset" --parallel "$count" "$@" >&2 || fail "the $preset build failed"
}
