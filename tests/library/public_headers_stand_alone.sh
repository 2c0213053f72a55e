#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Checks that each public header compiles on its own as C++20, without a warning and without any other header of the
# program.
#
#   public_headers_stand_alone.sh FOLDER COMPILER...     the folder that has mesecina/*.h
set -uo pipefail
folder=$1
shift
scratch=$(mktemp -d -t mesecina-headers.XXXXXX) || exit 1
trap 'rm -rf "$scratch"' EXIT
# Nothing else can be included from there.
mkdir "$scratch/include" && cp -r "$folder/mesecina" "$scratch/include" || exit 1

problems=0
complain() {
  printf '%s\n' "$*"
  ((++problems))
}

headers=("$scratch"/include/mesecina/*.h)
((${#headers[@]} <= 8)) || complain "there are ${#headers[@]} public headers, more than eight"
for header in "${headers[@]}"; do
  name=$(basename "$header")
  while read -r included; do
    case $included in
      '<mesecina/'*) ;;
      *[./]*) complain "$name includes $included" ;;
    esac
  done < <(sed -n 's/^ *# *include *\([<"][^>"]*[>"]\).*/\1/p' "$header")
  # Twice, as every header may be.
  printf '#include <mesecina/%s>\n#include <mesecina/%s>\nint main() {}\n' "$name" "$name" >"$scratch/main.cpp"
  for compiler in "$@"; do
    "$compiler" -std=c++20 -fsyntax-only -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wold-style-cast \
      -Wshadow -Werror -I"$scratch/include" "$scratch/main.cpp" || complain "$name does not compile with $compiler"
  done
  for part in 'Guarantees' 'Smallest use' 'Threads:'; do
    # The header that includes all others has nothing of its own.
    [[ $name == mesecina.h && $part == 'Smallest use' ]] && continue
    grep -q "$part" "$header" || complain "$name does not say: $part"
  done
done
((problems == 0))
