#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Compiles the predicates for browsers, as WebAssembly, and runs their tests under node.
#
# Emscripten 3.1.60 or later is taken where it is found. Otherwise Debian 13, which has 3.1.69, is installed into a
# folder (mmdebstrap, as root), which takes three minutes and 2.9 GB once. The sources of libraries come from Debian
# through apt. All of this is kept in MESECINA_WEB_CACHE, by default ~/.cache/mesecina/web.
set -uo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
cache=${MESECINA_WEB_CACHE:-${XDG_CACHE_HOME:-$HOME/.cache}/mesecina/web}
mkdir -p "$cache"

(($# == 0)) || fail "unknown option '$1'; there are none"

is_new_enough() {
  local version
  version=$(emcc --version 2>/dev/null | sed -n '1s/.* \([0-9][0-9.]*\) .*/\1/p')
  [[ -n $version && $(printf '%s\n' 3.1.60 "$version" | sort -V | head -n 1) == 3.1.60 ]]
}

# The root is complete when its stamp is there.
make_root() {
  if [[ -e $cache/root.stamp ]]; then return; fi
  command -v mmdebstrap >/dev/null || fail "emscripten is not installed, nor is mmdebstrap, which installs it aside"
  ((EUID == 0)) || fail "emscripten is not installed, and only root can install it aside"
  say "Installing Debian 13 with emscripten into $cache/root ..."
  rm -rf "$cache/root"
  mmdebstrap --quiet --variant=apt \
    --include=emscripten,cmake,ninja-build,make,m4,gcc,libc6-dev,pkgconf,ccache \
    --aptopt='APT::Install-Recommends "false"' --dpkgopt='path-exclude=/usr/share/doc/*' \
    trixie "$cache/root" http://deb.debian.org/debian >"$cache/root.log" 2>&1 ||
    fail "the root could not be made; the log is $cache/root.log"
  touch "$cache/root.stamp"
}

# with_emscripten COMMAND...: runs the command where emcc is, with this tree and the cache at the same paths.
with_emscripten() {
  local variables=("HOME=$HOME" LANG=C.UTF-8 EM_FROZEN_CACHE=0 "EM_CACHE=$cache/emcache" EMCC_SKIP_SANITY_CHECK=1
    "CCACHE_DIR=$cache/ccache")
  if is_new_enough; then
    env "${variables[@]}" "$@"
    return
  fi
  # shellcheck disable=SC2016
  unshare --mount bash -c '
    inner=$1 tree=$2 cache=$3
    shift 3
    mount --make-rprivate / && mount -t proc proc "$inner/proc" && mount --rbind /dev "$inner/dev" || exit 1
    for folder in "$tree" "$cache"; do
      mkdir -p "$inner$folder" && mount --bind "$folder" "$inner$folder" || exit 1
    done
    exec chroot "$inner" /usr/bin/env -i PATH=/usr/bin:/bin "$@"' \
    _ "$cache/root" "$root" "$cache" "${variables[@]}" "$@"
}

# The source packages of Debian 12, whose versions the program is tested with; those of Debian 13 where a mirror lacks
# them.
fetch_sources() {
  if [[ -e $cache/sources.stamp ]]; then return; fi
  command -v apt-get >/dev/null || fail "the sources of libraries come through apt, which is not here"
  say "Fetching the sources of libraries ..."
  mkdir -p "$cache"/apt/{lists/partial,cache/archives/partial,files} "$cache/src" "$cache/prefix"
  local suite key='signed-by=/usr/share/keyrings/debian-archive-keyring.gpg'
  for suite in bookworm trixie; do
    printf 'deb-src [%s] http://deb.debian.org/debian %s main\n' "$key" "$suite"
  done >"$cache/apt/sources.list"
  printf 'deb [%s] http://deb.debian.org/debian bookworm main\n' "$key" >>"$cache/apt/sources.list"
  cat >"$cache/apt/apt.conf" <<CONFIGURATION
Dir::State::lists "$cache/apt/lists";
Dir::Cache "$cache/apt/cache";
Dir::Etc::sourcelist "$cache/apt/sources.list";
Dir::Etc::sourceparts "-";
Acquire::Languages "none";
CONFIGURATION
  local -x APT_CONFIG=$cache/apt/apt.conf
  apt-get --quiet update >"$cache/apt/log" 2>&1 || fail "apt-get update failed; its log is $cache/apt/log"
  cd "$cache/apt/files" || exit 1
  local package archive
  for package in cairo fmtlib freetype gmp harfbuzz imgui libdeflate libjpeg-turbo libpng1.6 libpolyclipping libstb \
    mpfi mpfr4 muparser pixman pugixml zlib; do
    for suite in bookworm trixie; do
      apt-get --quiet source --download-only --tar-only "$package/$suite" >>"$cache/apt/log" 2>&1
      # Some packages have a second archive, of examples, whose name is longer.
      archive=$(find . -name "${package}_*.orig.tar.*" ! -name '*.asc' | head -n 1)
      [[ -n $archive ]] && break
    done
    [[ -n $archive ]] || fail "the sources of $package could not be fetched; the log is $cache/apt/log"
    rm -rf "$cache/src/$package" && mkdir "$cache/src/$package" &&
      tar xf "$archive" -C "$cache/src/$package" --strip-components=1 || fail "$archive could not be unpacked"
  done
  # Libraries of headers alone.
  apt-get --quiet download libcgal-dev libboost1.74-dev nlohmann-json3-dev libcli11-dev libglm-dev \
    catch2 >>"$cache/apt/log" 2>&1 ||
    fail "the headers of libraries could not be fetched; the log is $cache/apt/log"
  for archive in ./*.deb; do
    dpkg -x "$archive" "$cache/headers" || exit 1
  done
  mkdir -p "$cache/prefix/include" && cp -r "$cache"/headers/usr/include/* "$cache/prefix/include/" || exit 1
  cd "$root" && touch "$cache/sources.stamp" || exit 1
}

is_new_enough || make_root
fetch_sources
with_emscripten bash "$root/packaging/web/libraries.sh" "$cache/src" "$cache/prefix" "$(job_count)" || exit 1

# build_web TARGET...: with -O1 the programs that CMake tries use the libraries that ours does, and emscripten compiles
# no others. The headers of libraries come after those that a target names.
build_web() {
  # shellcheck disable=SC2016
  with_emscripten bash -c '
    root=$1 prefix=$2 jobs=$3
    shift 3
    cd "$root" && PKG_CONFIG_LIBDIR=$prefix/lib/pkgconfig emcmake cmake -S . -B build/wasm -G Ninja \
      -DCMAKE_BUILD_TYPE=Release -DCMAKE_FIND_ROOT_PATH="$prefix" -DCMAKE_PREFIX_PATH="$prefix" \
      -DCMAKE_CXX_FLAGS="-pthread -fwasm-exceptions -fexperimental-library -sSUPPORT_LONGJMP=wasm \
-idirafter $prefix/include -D_LIBCPP_ENABLE_CXX17_REMOVED_UNARY_BINARY_FUNCTION" -DCMAKE_EXE_LINKER_FLAGS="-O1 -L$prefix/lib" \
      -DMESECINA_TESTS=OFF -DMESECINA_LIBRARY=OFF -DMESECINA_WERROR=OFF >build/wasm-configure.log 2>&1 ||
      { cat build/wasm-configure.log >&2; exit 1; }
    cmake --build build/wasm --parallel "$jobs" --target "$@"' \
    _ "$root" "$cache/prefix" "$(job_count)" "$@" >&2 || fail "the build failed"
}

build_web mesecina_test_kernel
say "Comparing predicates with exact integers ..."
with_emscripten node "$root/build/wasm/mesecina_test_kernel.js" || fail "the predicates are wrong in WebAssembly"
