#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the packages that are missing; says nothing and touches nothing when none is.
#
#   scripts/install_packages.sh [build|python|notebook|test|bench|package|package-check|tidy|format]
#
# All but the last three include build, and notebook, test and package include python; default: test. It installs on Debian
# and Ubuntu; elsewhere it says what to install.
set -uo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

# The names of what is needed: `-` where there is no package or none is needed. The names of apt are used by every test
# run on Debian 12. Those of Ubuntu, which are the same, and of dnf, pacman and brew are from reading only, not tried:
# newer systems have version 3 of Catch2, and the tests need version 2; brew has neither EGL nor stb.
packages() {
  cat <<'TABLE'
# set          apt                 dnf                 pacman         brew
build          g++                 gcc-c++             gcc            gcc
build          cmake               cmake               cmake          cmake
build          ninja-build         ninja-build         ninja          ninja
build          pkg-config          pkgconf-pkg-config  pkgconf        pkgconf
build          libcgal-dev         CGAL-devel          cgal           cgal
build          libboost-dev        boost-devel         boost          boost
build          libgmp-dev          gmp-devel           gmp            gmp
build          libmpfr-dev         mpfr-devel          mpfr           mpfr
build          libmpfi-dev         mpfi-devel          mpfi           mpfi
build          libfmt-dev          fmt-devel           fmt            fmt
build          libglfw3-dev        glfw-devel          glfw           glfw
build          libimgui-dev        imgui-devel         imgui          imgui
build          libepoxy-dev        libepoxy-devel      libepoxy       libepoxy
build          libglm-dev          glm-devel           glm            glm
build          libegl-dev          libglvnd-devel      libglvnd       -
build          libgl1              libglvnd-glx        libglvnd       -
build          libegl1             libglvnd-egl        libglvnd       -
build          libgl1-mesa-dri     mesa-dri-drivers    mesa           -
build          libglx-mesa0        mesa-libGL          mesa           -
build          libpng-dev          libpng-devel        libpng         libpng
build          libjpeg-dev         libjpeg-turbo-devel  libjpeg-turbo  jpeg-turbo
build          libstb-dev          stb-devel           stb            -
build          libdeflate-dev      libdeflate-devel    libdeflate     libdeflate
build          libcairo2-dev       cairo-devel         cairo          cairo
build          libfreetype-dev     freetype-devel      freetype2      freetype
build          libglib2.0-dev      glib2-devel         glib2          glib
build          libcli11-dev        cli11-devel         cli11          cli11
build          nlohmann-json3-dev  json-devel          nlohmann-json  nlohmann-json
build          libpugixml-dev      pugixml-devel       pugixml        pugixml
build          libmuparser-dev     muParser-devel      muparser       muparser
build          libproj-dev         proj-devel          proj           proj
build          libfontconfig-dev   fontconfig-devel    fontconfig     fontconfig
build          libharfbuzz-dev     harfbuzz-devel      harfbuzz       harfbuzz
build          libpolyclipping-dev  polyclipping-devel  clipper       -
python         python3-dev         python3-devel       python         -
python         pybind11-dev        pybind11-devel      pybind11       pybind11
python         python3-numpy       python3-numpy       python-numpy   numpy
notebook       jupyter-notebook    python3-notebook    jupyter-notebook  jupyterlab
notebook       python3-matplotlib  python3-matplotlib  python-matplotlib  python-matplotlib
test           python3-pytest      python3-pytest      python-pytest  pytest
test           python3-networkx    python3-networkx    python-networkx  -
test           python3-pandas      python3-pandas      python-pandas  -
test           python3-matplotlib  python3-matplotlib  python-matplotlib  python-matplotlib
test           python3-shapely     python3-shapely     python-shapely  -
test           python3-nbconvert   python3-nbconvert   jupyter-nbconvert  -
test           python3-ipykernel   python3-ipykernel   python-ipykernel  -
test           python3-distributed  python3-distributed  python-distributed  -
test           ccache              ccache              ccache         ccache
test           mold                mold                mold           -
test           catch2              catch2-devel        catch2-v2      -
test           xvfb                xorg-x11-server-Xvfb  xorg-server-xvfb  -
test           libx11-dev          libX11-devel        libx11         -
test           xdotool             xdotool             xdotool        -
test           imagemagick         ImageMagick         imagemagick    imagemagick
test           dbus-daemon         dbus-daemon         dbus           -
test           proj-bin            proj                proj           proj
test           gdal-bin            gdal                gdal           gdal
test           librsvg2-bin        librsvg2-tools      librsvg        librsvg
test           poppler-utils       poppler-utils       poppler        poppler
test           ghostscript         ghostscript         ghostscript    ghostscript
bench          python3-scipy       python3-scipy       python-scipy   scipy
bench          python3-distributed  python3-distributed  python-distributed  -
bench          libbenchmark-dev    google-benchmark-devel  benchmark  google-benchmark
package        dpkg-dev            dpkg-dev            dpkg           dpkg
package        file                file                file           -
package        patchelf            patchelf            patchelf       -
package        xz-utils            xz                  xz             -
package-check  lintian             -                   -              -
package-check  debootstrap         -                   -              -
package-check  desktop-file-utils  -                   -              -
package-check  appstream           -                   -              -
package-check  shared-mime-info    -                   -              -
tidy           clang-tidy-14       clang-tools-extra   clang          llvm
format         clang-format-14     clang-tools-extra   clang          clang-format
TABLE
}

set_name=${1:-test}
case $set_name in
  build | package-check | tidy | format) sets=("$set_name") ;;
  test) sets=(build python test) ;;
  package | notebook) sets=(build python "$set_name") ;;
  python | bench) sets=(build "$set_name") ;;
  *) fail "unknown set '$1'; sets are build, python, notebook, test, bench, package, package-check, tidy and format" ;;
esac

# Who installs here, how it is asked, and the names of what it has installed.
if command -v dpkg-query >/dev/null; then
  column=2 command='apt-get install'
  installed() {
    dpkg-query --show --showformat='${db:Status-Abbrev} ${Package}\n' "$@" 2>/dev/null | sed -n 's/^ii  *//p'
  }
elif command -v dnf >/dev/null; then
  column=3 command='dnf install'
  installed() { rpm --query --queryformat '%{NAME}\n' "$@" 2>/dev/null; }
elif command -v pacman >/dev/null; then
  column=4 command='pacman -S'
  installed() { pacman --query --quiet "$@" 2>/dev/null; }
elif command -v brew >/dev/null; then
  column=5 command='brew install'
  installed() { brew list --formula -1; }
else
  fail "none of apt, dnf, pacman and brew is here; install by hand what the table in $0 lists"
fi

mapfile -t wanted < <(packages | awk -v sets="${sets[*]}" -v column="$column" '
  BEGIN { split(sets, names, " "); for (i in names) is_wanted[names[i]] = 1 }
  $1 in is_wanted && $column != "-" && !seen[$column]++ { print $column }')
present=$(installed "${wanted[@]}")
missing=()
for package in "${wanted[@]}"; do
  grep -qxF -- "$package" <<<"$present" || missing+=("$package")
done
if ((${#missing[@]} == 0)); then exit 0; fi
if ((column != 2)); then fail "packages are missing: $command ${missing[*]}"; fi

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
