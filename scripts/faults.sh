#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Puts small faults into a copy of the tree, switches them on one at a time, and runs the tests that are there to
# notice. A fault that survives means that a test is missing, or that a line is not needed. tests/mutations/README.md
# describes the tables.
#
#   scripts/faults.sh [NAME...]      all faults, or those named; the verdicts are added to build/faults/verdicts
#   scripts/faults.sh --check        only whether each fault still applies: its text occurs exactly once in its file
#   scripts/faults.sh --list         names, files and reasons
set -uo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

tables=$root/tests/mutations
scratch=$root/build/faults
tree=$scratch/tree
most_seconds=900 # for the tests of one fault; a fault may make a loop endless
most_kbytes=$((8 * 1024 * 1024))

names=()
declare -A file_of why_of tests_of before_of after_of
declare -A text_of # of each file with faults: with all of them in, each behind its switch

# Reads a table: `fault`, `why`, `in` and `tests`, then the lines that go (-) and those that come (+).
read_table() {
  local line name='' table=$1
  while IFS= read -r line || [[ $line ]]; do
    case $line in
      '' | '#'*) continue ;;
      'fault '*)
        name=${line#fault }
        [[ ${file_of[$name]+known} ]] && fail "$table: $name is listed twice"
        names+=("$name")
        file_of[$name]=''
        ;;
      'why '*) why_of[$name]=${line#why } ;;
      'in '*) file_of[$name]=${line#in } ;;
      'tests '*) tests_of[$name]=${line#tests } ;;
      '- '*) before_of[$name]+=${before_of[$name]+$'\n'}${line#- } ;;
      '+ '* | '+') after_of[$name]+=${after_of[$name]+$'\n'}${line:2} ;;
      *) fail "$table: not understood: $line" ;;
    esac
  done <"$table"
}

number_of() { cksum <<<"$1" | cut -d ' ' -f 1; }

# The text of a fault with its switch: statements become a block, anything else is an expression.
switched() {
  local is_on
  is_on="::mes::faults::chosen == $(number_of "$1")UL"
  case ${before_of[$1]} in
    *';' | *'}') echo "{ if ($is_on) { ${after_of[$1]} } else { ${before_of[$1]} } }" ;;
    *) echo "($is_on ? (${after_of[$1]}) : (${before_of[$1]}))" ;;
  esac
}

# Puts the fault into the text of its file; says what is wrong when it does not apply.
put_in() {
  local name=$1 file=${file_of[$1]} before=${before_of[$1]-} part text start rest
  for part in why_of tests_of before_of after_of; do
    local -n values=$part
    [[ ${values[$name]+given} ]] || { say "$name: ${part%_of} is missing"; return 1; }
  done
  [[ -f $root/$file ]] || { say "$name: there is no file $file"; return 1; }
  [[ ${text_of[$file]+read} ]] || text_of[$file]="#include \"tests/mutations/chosen.h\""$'\n'$(<"$root/$file")
  text=${text_of[$file]}
  start=${text%%"$before"*}
  [[ $start != "$text" ]] || { say "$name: $file does not hold: $before"; return 1; }
  rest=${text:${#start}+${#before}}
  [[ $rest != *"$before"* ]] || { say "$name: $file holds more than once: $before"; return 1; }
  [[ $before != "${after_of[$name]}" ]] || { say "$name: nothing is changed"; return 1; }
  text_of[$file]=$start$(switched "$name")$rest
}

# The files of a folder, from a list that ends each name with a zero byte, as lines "SUM  NAME".
sums_in() { (cd "$1" && xargs -0r sha256sum -- 2>/dev/null | sort); }

# Files that are the same keep their times, so that nothing is compiled without need.
copy_tree() {
  local ours theirs file
  mkdir -p "$tree"
  ours=$(git ls-files -z --cached --others --exclude-standard | sums_in "$root")
  theirs=$(cd "$tree" && find . -path ./build -prune -o -type f -printf '%P\0' | sums_in "$tree")
  comm -13 <(cut -c 67- <<<"$ours" | sort) <(cut -c 67- <<<"$theirs" | sort) |
    while IFS= read -r file; do [[ $file ]] && rm "$tree/$file"; done
  comm -23 <(echo "$ours") <(echo "$theirs") | cut -c 67- | grep -vxF -f <(printf '%s\n' "${!text_of[@]}") |
    (cd "$root" && xargs -d '\n' -r cp --parents -t "$tree")
  for file in "${!text_of[@]}"; do
    cmp -s <(echo "${text_of[$file]}") "$tree/$file" && continue
    mkdir -p "$tree/$(dirname "$file")"
    echo "${text_of[$file]}" >"$tree/$file"
  done
}

# The tests of one fault or several, each TARGET or TARGET.TEST, as CTest wants them.
pattern_of() {
  local test out=''
  for test in "$@"; do
    [[ $test == *.* ]] || test=$test.
    out+="${out:+|}${test/./\\.}"
  done
  echo "^($out)"
}

build_copy() {
  local -A targets=()
  local test
  for test in "$@"; do targets[${test%%.*}]=1; done
  nice -n 10 cmake --build "$tree/build/release" --parallel "$(job_count)" --target "${!targets[@]}" >"$scratch/log" 2>&1
}

# run_tests LOG TEST...
run_tests() {
  local log=$1
  shift
  (
    ulimit -v "$most_kbytes"
    nice -n 10 timeout "$most_seconds" ctest --test-dir "$tree/build/release" -R "$(pattern_of "$@")" --no-tests=error \
      --stop-on-failure --output-on-failure >"$log" 2>&1
  )
}

failed_tests() {
  sed -n '/^The following tests FAILED:/,$ s/^[[:space:]]*[0-9]* - \([^ ]*\).*/\1/p' "$1" | paste -sd ' '
}

list() {
  local name
  for name in "${names[@]}"; do printf '%-36s %-44s %s\n' "$name" "${file_of[$name]}" "${why_of[$name]}"; done
}

# Builds the copy and tests it with no fault on: what fails there would kill them all.
prepare() {
  local name tests
  "$root/scripts/install_packages.sh" test || exit 1
  mkdir -p "$scratch/logs"
  exec 9>"$scratch/lock"
  flock -n 9 || fail "it is running already"
  copy_tree
  (cd "$tree" && cmake --preset release -DMESECINA_TESTS=ON) >"$scratch/log" 2>&1 ||
    { cat "$scratch/log" >&2; fail "cmake could not configure the copy"; }
  mapfile -t tests < <(for name in "${names[@]}"; do tr ' ' '\n' <<<"${tests_of[$name]}"; done | sort -u)
  build_copy "${tests[@]}" || { tail -40 "$scratch/log" >&2; fail "the copy does not build"; }
  run_tests "$scratch/log" "${tests[@]}" || { tail -40 "$scratch/log" >&2; fail "tests fail with no fault on"; }
}

run_all() {
  local name tests verdict survivors=0
  for name in "${names[@]}"; do
    read -ra tests <<<"${tests_of[$name]}"
    if MESECINA_FAULT=$(number_of "$name") run_tests "$scratch/logs/$name" "${tests[@]}"; then
      verdict=survived
      survivors=$((survivors + 1))
    else
      verdict="killed by $(failed_tests "$scratch/logs/$name")"
    fi
    printf '%-36s %s\n' "$name" "$verdict" | tee -a "$scratch/verdicts"
  done
  say "${#names[@]} faults, $survivors survived"
  ((survivors == 0))
}

main() {
  local task=run name table wrong=0
  for table in "$tables"/*.faults; do read_table "$table"; done
  case ${1:-} in
    --check) task=check && shift ;;
    --list) task=list && shift ;;
    -*) fail "unknown option '$1'; there are --check and --list" ;;
  esac
  for name in "$@"; do [[ ${file_of[$name]+known} ]] || fail "there is no fault '$name'; see --list"; done
  for name in "${names[@]}"; do put_in "$name" || wrong=1; done
  if (($# > 0)); then names=("$@"); fi
  if [[ $task == list ]]; then list && return; fi
  ((wrong == 0)) || fail "the tables do not fit the tree"
  if [[ $task == check ]]; then return; fi
  prepare
  run_all
}

main "$@"
exit
