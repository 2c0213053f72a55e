#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The program as WebAssembly, for browsers.
#
#   scripts/web.sh           makes the page in build/web
#   scripts/web.sh --test    runs the tests of the predicates under node, compares what the program computes there with
#                            what it computes here, and uses the page in Chromium
#
# Emscripten 3.1.60 or later is taken where it is found. Otherwise Debian 13, which has 3.1.69, is installed into a
# folder (mmdebstrap, as root), which takes three minutes and 2.9 GB once. The sources of libraries come from Debian
# through apt. All of this is kept in MESECINA_WEB_CACHE, by default ~/.cache/mesecina/web.
set -uo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
cache=${MESECINA_WEB_CACHE:-${XDG_CACHE_HOME:-$HOME/.cache}/mesecina/web}
mkdir -p "$cache"

is_test=
case "$*" in
  "") ;;
  --test) is_test=1 ;;
  *) fail "unknown options '$*'; there is --test" ;;
esac

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
  local sources="cairo fmtlib freetype gmp harfbuzz imgui libdeflate libjpeg-turbo libpng1.6 libpolyclipping libstb \
mpfi mpfr4 muparser pixman pugixml zlib"
  local headers="libcgal-dev libboost1.74-dev nlohmann-json3-dev libcli11-dev libglm-dev catch2 libproj-dev"
  [[ $(cat "$cache/sources.stamp" 2>/dev/null) != "$sources $headers" ]] || return
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
  for package in $sources; do
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
  # shellcheck disable=SC2086
  apt-get --quiet download $headers >>"$cache/apt/log" 2>&1 ||
    fail "the headers of libraries could not be fetched; the log is $cache/apt/log"
  for archive in ./*.deb; do
    dpkg -x "$archive" "$cache/headers" || exit 1
  done
  mkdir -p "$cache/prefix/include" && cp -r "$cache"/headers/usr/include/* "$cache/prefix/include/" || exit 1
  cd "$root" && printf %s "$sources $headers" >"$cache/sources.stamp" || exit 1
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
    cd "$root" && mkdir -p build && PKG_CONFIG_LIBDIR=$prefix/lib/pkgconfig emcmake cmake -S . -B build/wasm -G Ninja \
      -DCMAKE_BUILD_TYPE=Release -DCMAKE_FIND_ROOT_PATH="$prefix" -DCMAKE_PREFIX_PATH="$prefix" \
      -DCMAKE_CXX_FLAGS="-pthread -fwasm-exceptions -fexperimental-library -sSUPPORT_LONGJMP=wasm \
-idirafter $prefix/include -D_LIBCPP_ENABLE_CXX17_REMOVED_UNARY_BINARY_FUNCTION" -DCMAKE_EXE_LINKER_FLAGS="-O1 -L$prefix/lib" \
      -DMESECINA_TESTS=OFF -DMESECINA_LIBRARY=OFF -DMESECINA_WERROR=OFF >build/wasm-configure.log 2>&1 ||
      { cat build/wasm-configure.log >&2; exit 1; }
    cmake --build build/wasm --parallel "$jobs" --target "$@"' \
    _ "$root" "$cache/prefix" "$(job_count)" "$@" >&2 || fail "the build failed"
}

# What the programs are told: every sample and session of the tree, in two number types. Positions of outline axes come
# from an iteration whose start differs in last bits (docs/features/web.md).
commands() {
  local file precision layers
  layers=$(build/release/mesecina list layers | awk '$1 !~ /^(outline-axis|axis-deviation)$/ { print $1 }' | paste -sd,)
  for file in tests/data/*.{poff,wpoff,csv,json} assets/shapes/*.poff assets/lessons/*.json; do
    for precision in fast exact; do
      echo "compute $file --precision $precision --layers $layers --digest --no-timing"
    done
    [[ $file != *.json ]] || echo "play $file"
  done
}

# answer_all FOLDER PROGRAM...: what the program writes for each command, in a file each.
answer_all() {
  local folder=$1 words number=0
  shift
  rm -rf "$folder" && mkdir -p "$folder" || return 1
  while read -r -a words; do
    MESECINA_ASSETS=assets "$@" "${words[@]}" >"$folder/$number" 2>/dev/null </dev/null
    echo "exit code $?" >>"$folder/$number"
    ((++number))
  done <build/wasm/commands
}

# Every line is compared: digests, counts, findings. Lengths of arcs are sums of angles by the C library.
compare_programs() {
  local number=0 equal=0 digests=0 command difference
  commands >build/wasm/commands
  say "Computing $(wc -l <build/wasm/commands) commands here and in WebAssembly ..."
  answer_all build/wasm/here build/release/mesecina
  with_emscripten bash -c "cd $(printf %q "$root"); $(declare -f answer_all); answer_all build/wasm/there \
    node build/wasm/mesecina_command.js" || return 1
  while read -r command; do
    digests=$((digests + $(grep -cE '"digest' "build/wasm/here/$number")))
    if difference=$(diff <(grep -vE '"(length|perimeter)"' "build/wasm/here/$number") \
      <(grep -vE '"(length|perimeter)"' "build/wasm/there/$number")); then
      ((++equal))
    else
      say "mesecina ${command/--layers */...} differs:"
      head -n 12 <<<"$difference" >&2
    fi
    ((++number))
  done <build/wasm/commands
  say "$equal of $number commands write the same in WebAssembly, with $digests lines of digests."
  ((equal == number))
}

# Uses the page in Chromium where that is installed.
use_page() {
  command -v chromium >/dev/null || {
    say "The page was not started: chromium is not installed."
    return 0
  }
  say "Using the page in Chromium ..."
  tests/web/check_page.py
}

if [[ -z $is_test ]]; then
  build_web mesecina_page
  say "The page is in build/web."
  exit 0
fi
build_web mesecina_test_kernel mesecina_command mesecina_page
configure_program
build release --target mesecina
say "Comparing predicates with exact integers ..."
with_emscripten node "$root/build/wasm/mesecina_test_kernel.js" || fail "the predicates are wrong in WebAssembly"
compare_programs || fail "the program computes something else in WebAssembly"
use_page || fail "the page does not do what it promises"
