#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the library, moves what was installed, and builds and runs the example against it, outside the tree.
#
#   an_example_uses_the_installed_library.sh CMAKE BUILD SOURCES COMPILER...
set -uo pipefail
cmake=$1 build=$2 sources=$3
shift 3
scratch=$(mktemp -d -t mesecina-example.XXXXXX) || exit 1
trap 'rm -rf "$scratch"' EXIT
fail() {
  printf '%s\n' "$*"
  exit 1
}

for component in library development; do
  "$cmake" --install "$build" --component $component --prefix "$scratch/first" >"$scratch/log" 2>&1 ||
    fail "$component is not installed: $(cat "$scratch/log")"
done
mv "$scratch/first" "$scratch/prefix"
cp -r "$sources/examples/library" "$scratch/example"
shape=$sources/assets/shapes/lizard.poff
library=$(find "$scratch/prefix" -name libmesecina.so)
[[ -n $library ]] || fail "there is no libmesecina.so"

# Nothing but the public names is visible, and nothing says where it was built.
nm --dynamic --defined-only --extern-only --demangle "$library" >"$scratch/names"
grep -q 'mesecina::v1::Workbench::run()' "$scratch/names" || fail "Workbench::run is not visible"
others=$(grep -vE ' (typeinfo for |typeinfo name for |vtable for )?mesecina::v1::| A MESECINA_1' "$scratch/names")
[[ -z $others ]] || fail "these are visible, too: $(head -n 20 <<<"$others")"
if grep -qF "$sources" "$library"; then fail "the library says where it was built"; fi
readelf --dynamic "$library" | grep -q 'SONAME.*\[libmesecina\.so\.1\]' || fail "its name has no number of the ABI"

# The program says the same of the same file.
"$build/mesecina" export "$shape" --layer medial-axis --format csv -o "$scratch/expected.csv" || fail "export fails"
expected=$(($(wc -l <"$scratch/expected.csv") - 1))

number=0
for compiler in "$@"; do
  folder=$scratch/build$((++number))
  {
    "$cmake" -G Ninja -S "$scratch/example" -B "$folder" -DCMAKE_PREFIX_PATH="$scratch/prefix" \
      -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS='-Wall -Wextra -Wpedantic -Wconversion -Werror' &&
      "$cmake" --build "$folder"
  } >"$scratch/log" 2>&1 || fail "the example does not build with $compiler: $(cat "$scratch/log")"
  "$folder/axis_edges" "$shape" >"$scratch/edges.csv" 2>"$scratch/said" || fail "it fails: $(cat "$scratch/said")"
  grep -qE '^length [0-9.]+$' "$scratch/said" || fail "it says no length: $(cat "$scratch/said")"
  edges=$(($(wc -l <"$scratch/edges.csv") - 1))
  ((edges == expected)) || fail "with $compiler it writes $edges edges; the program writes $expected"
  if "$folder/axis_edges" "$scratch/missing.poff" 2>"$scratch/said"; then fail "it reads a file that is not there"; fi
  grep -q 'missing.poff' "$scratch/said" || fail "the error does not name the file"
done

# Without CMake.
if command -v pkg-config >/dev/null; then
  export PKG_CONFIG_PATH=$(dirname "$library")/pkgconfig
  # shellcheck disable=SC2046
  "$1" -std=c++20 $(pkg-config --cflags mesecina) "$scratch/example/main.cpp" $(pkg-config --libs mesecina) \
    -o "$scratch/by_hand" || fail "pkg-config does not say how to compile"
  LD_LIBRARY_PATH=$(dirname "$library") "$scratch/by_hand" "$shape" 2>/dev/null | cmp - "$scratch/edges.csv" ||
    fail "compiled by hand it writes something else"
fi
