#!/usr/bin/env bash
# Whether the tests notice wrong code: changes one place of src/ at a time and runs the tests of that folder which reach
# the place. A change that no test fails at survives. Changed are the thresholds of src/walking and src/gap by 30 %, and
# OPERATORS random operators in the other folders that have tests (scripts/mutation/list.awk says what counts).
#   scripts/mutation.sh [--list | --report] [--survivors] [FOLDER]...     FOLDER is one of src/, as walking or gap/replay [all]
#   --list         says what would be changed, and changes nothing
#   --report       writes doc/results/mutation.md from what was tried
#   --survivors    tries again what has survived, after tests were mended
#   --program      builds build/mutation/tree/bin/gap alone: PLUMBLINE_MUTANT=N has the N-th change of build/mutation/plan.txt
# Variables: SEED, of the choice and the order [1]. OPERATORS [200]. MOST, how many are tried in this run [all]. LONG=yes
# runs tests/diagnosis as well, minutes each, where src/gap is changed. QUICK=yes leaves out what has to be compiled by
# itself. JOBS for builds [one per core].
# It works in a copy of the tree, build/mutation/tree, where all changes stand at once behind switches; what cannot is
# compiled by itself. What was tried is in build/mutation/results.txt: a run that was ended goes on there. Tests may
# compute three times as long as they do without a change.
# Example: MOST=20 scripts/mutation.sh walking
set -uo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
fail() { echo "mutation.sh: $*" >&2; exit 2; }
mode=run survivors="" folders=()
while (($#)); do
  case $1 in
    --list | --report | --program) mode=${1#--} ;;
    --survivors) survivors=yes ;;
    -*) fail "no option $1; see --help" ;;
    *) [[ -d src/${1%/} ]] || fail "no folder src/$1"
      folders+=("src/${1%/}/") ;;
  esac
  shift
done
seed=${SEED:-1} operators=${OPERATORS:-200} most=${MOST:-1000000}
[[ $seed$operators$most =~ ^[0-9]+$ ]] || fail "SEED, OPERATORS and MOST are whole numbers"
root=$PWD tab=$'\t'
out=$root/build/mutation tree=$root/build/mutation/tree
results=$out/results.txt
mkdir -p "$out"
touch "$results"
mapfile -t testAreas < <(find tests -mindepth 2 -name '*.cpp' | cut -d/ -f2 | LC_ALL=C sort -u)
tested=$(printf '^src/%s/\n' "${testAreas[@]}" | paste -sd'|')
# Lines in an order that the seed draws (Park and Miller's generator).
shuffled() {
  awk -v s="$seed" 'function next_() { return s = s * 48271 % 2147483647 }
    BEGIN { s = s % 2147483646 + 1; for (i = 0; i < 10; ++i) next_() } { printf "%d\t%s\n", next_(), $0 }' | LC_ALL=C sort -n | cut -f2-
}
ofFolders() { if ((${#folders[@]})); then grep -E "$tab($(IFS='|'; echo "${folders[*]}"))"; else cat; fi; }

# All that there is to try, in an order that the seed draws: kind, file, line, column, from, to.
mutants() {
  local all
  all=$(find src -name '*.cpp' -o -name '*.h' | grep -E "$tested" | LC_ALL=C sort |
    xargs awk -v thresholds='^src/(walking|gap)/' -f scripts/mutation/code.awk -f scripts/mutation/list.awk)
  { grep '^threshold' <<< "$all"; grep '^operator' <<< "$all" | shuffled | sed "${operators}q"; } | shuffled
}

source scripts/mutation/report.bash
case $mode in
  list) mutants | ofFolders; exit ;;
  report) report; exit ;;
esac
exec 9> "$out/lock"
flock -n 9 || fail "it runs already here"
trap 'echo; echo "mutation.sh: ended; the same command goes on"; exit 130' INT TERM
source scripts/mutation/tree.bash
source scripts/mutation/tests.bash

if [[ $mode == program ]]; then
  echo "builds bin/gap with all changes behind switches, in some minutes (how far it is: tail -f build/mutation/log)"
  refresh
  (cd "$tree" && ./configure.sh --target SimRelease) > "$out/log" 2>&1 || fail "configure: see $out/log"
  buildSwitched gap || fail "bin/gap does not build: see $out/log"
  exit
fi

mapfile -t todo < <(
  if [[ $survivors ]]; then
    sed -n -E 's/^(survived|unreached)\t[^\t]*\t//p' "$results" | ofFolders
  else
    mutants | ofFolders | grep -vxFf <(cut -f3- "$results")
  fi | head -n "$most"
)
((${#todo[@]})) || { echo "Nothing is left to try."; exit 0; }
echo "${#todo[@]} changes to try"
mkdir -p "$out/tmp"
refresh
(cd "$tree" && ./configure.sh --target SimRelease) > "$out/log" 2>&1 || fail "configure: see $out/log"

# Those of an area, $1, with number and state before them: switched ones first, then others, file by file.
inOrder() {
  printf '%s\n' "${todo[@]}" | grep "${tab}src/$1/" |
    awk -F'\t' -v OFS='\t' -v quick="${QUICK-}" 'NR == FNR { line = $0; sub(/^[^\t]*\t[^\t]*\t/, "", line); of[line] = $1 "\t" $2; state[line] = $2; next }
      $0 in of && !(quick && state[$0] == "own") { print (state[$0] == "own" ? $2 : ""), of[$0], $0 }' "$plan" - | LC_ALL=C sort -s -t"$tab" -k1,1 | cut -f2-
}

tried=0
for area in $(printf '%s\n' "${todo[@]}" | cut -d/ -f2 | LC_ALL=C sort -u); do
  prepare "$area"
  while IFS= read -r change; do
    IFS=$tab read -r number state kind file row column from to <<< "$change"
    start=$SECONDS
    try "$number" "$file"
    mutant=$(cut -f3- <<< "$change")
    grep -vF "$tab$mutant" "$results" > "$results.new"
    printf '%s\t%s\t%s\n' "$result" "$((SECONDS - start))" "$mutant" >> "$results.new"
    mv "$results.new" "$results"
    tried=$((tried + 1))
    printf '[%d/%d] %-9s %s:%s  %s → %s  (%d s)\n' $tried ${#todo[@]} "$result" "$file" "$row" "$from" "$to" $((SECONDS - start))
  done < <(inOrder "$area")
done
rm -rf "$out/tmp"
echo "$(grep -cE '^(survived|unreached)' "$results") survivors of $(wc -l < "$results") so far; scripts/mutation.sh --report writes doc/results/mutation.md"
