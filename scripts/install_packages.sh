#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the Debian packages that are missing; says nothing and touches nothing when none is.
#
#   scripts/install_packages.sh [build|test|bench|format]      test and bench include build; default: test
set -uo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

build_packages=(
  g++ cmake ninja-build pkg-config
  libcgal-dev libgmp-dev libmpfr-dev                       # exact geometry
  libglfw3-dev libimgui-dev libepoxy-dev libegl-dev        # window and drawing
  libglm-dev                                               # vectors, matrices and colours of drawing
  libgl1 libegl1 libgl1-mesa-dri libglx-mesa0              # OpenGL, also without a graphics card
  libstb-dev libdeflate-dev                                # PNG
  libcli11-dev nlohmann-json3-dev                          # command line, JSON
)
test_packages=(catch2 xvfb xdotool imagemagick)
bench_packages=(libbenchmark-dev)
format_packages=(clang-format-14)

case ${1:-test} in
  build) wanted=("${build_packages[@]}") ;;
  test) wanted=("${build_packages[@]}" "${test_packages[@]}") ;;
  bench) wanted=("${build_packages[@]}" "${bench_packages[@]}") ;;
  format) wanted=("${format_packages[@]}") ;;
  *) fail "unknown set '$1'; there are build, test, bench and format" ;;
esac

command -v dpkg-query >/dev/null || fail "this is no Debian system; install by hand: ${wanted[*]}"

# One line "STATUS NAME" a package; what dpkg has never heard of has no line.
installed=$(dpkg-query --show --showformat='${db:Status-Abbrev} ${Package}\n' "${wanted[@]}" 2>/dev/null |
  awk '$1 == "ii" { print $2 }')
missing=()
for package in "${wanted[@]}"; do
  grep -qxF -- "$package" <<<"$installed" || missing+=("$package")
done
if ((${#missing[@]} == 0)); then exit 0; fi

if ((EUID == 0)); then
  as_root=(env)
elif command -v sudo >/dev/null && { [[ -t 0 ]] || sudo -n true 2>/dev/null; }; then
  as_root=(sudo env)
else
  fail "packages are missing, and this is neither root nor may it use sudo; install: ${missing[*]}"
fi

log=$(mktemp -t mesecina-apt.XXXXXX) || fail "cannot write to the temporary folder"
apt_get() {
  "${as_root[@]}" DEBIAN_FRONTEND=noninteractive apt-get -y -o DPkg::Lock::Timeout=300 "$@" </dev/null >>"$log" 2>&1
}
give_up() {
  local reason
  reason=$(grep -m1 '^E: ' "$log" || tail -n 1 "$log")
  fail "$1 failed: ${reason#E: } (all of it: $log)"
}

say "Installing ${missing[*]} ..."
# Mirrors hand over what they can reach even when one of several sources fails, so the install decides.
apt_get update
update_status=$?
if ! apt_get install --no-install-recommends "${missing[@]}"; then
  if ((update_status != 0)); then give_up "apt-get update"; fi
  give_up "apt-get install"
fi
rm -f "$log"
