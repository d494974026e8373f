#!/usr/bin/env bash
# Whether the tests notice wrong code: changes one place of src/ at a time, builds the tests of that folder and runs them.
# A change that no test fails at survives. Changed are the thresholds of src/walking and src/gap by 30 %, and OPERATORS
# random operators in the other folders that have tests (scripts/mutants.awk says what counts).
#   scripts/mutation.sh [--list | --report] [--survivors] [FOLDER]...     FOLDER is one of src/, as walking or gap/replay [all]
#   --list         says what would be changed, and changes nothing
#   --report       writes doc/results/mutation.md from what was tried
#   --survivors    tries again what has survived, after tests were mended
# Variables: SEED, of the choice and the order [1]; OPERATORS [200]; MOST, how many are tried in this run [all]; LONG=yes
# runs tests/diagnosis as well, minutes each, where src/gap is changed.
# It works in a copy of the tree, build/mutation/tree. What was tried stands in build/mutation/results.txt: a run that was
# ended goes on there. A test program may compute three times as long as it does without a change.
# Example: MOST=20 scripts/mutation.sh walking
set -uo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
fail() { echo "mutation.sh: $*" >&2; exit 2; }
mode=run survivors="" folders=()
while (($#)); do
  case $1 in
    --list | --report) mode=${1#--} ;;
    --survivors) survivors=yes ;;
    -*) fail "no option $1; see --help" ;;
    *) [[ -d src/${1%/} ]] || fail "no folder src/$1"
      folders+=("src/${1%/}/") ;;
  esac
  shift
done
seed=${SEED:-1} operators=${OPERATORS:-200} most=${MOST:-1000000}
[[ $seed$operators$most =~ ^[0-9]+$ ]] || fail "SEED, OPERATORS and MOST are whole numbers"
out=build/mutation tree=$PWD/build/mutation/tree tab=$'\t'
results=$out/results.txt
mkdir -p "$out"
touch "$results"
tested=$(find tests -mindepth 2 -name '*.cpp' | cut -d/ -f2 | LC_ALL=C sort -u | sed 's#.*#^src/&/#' | paste -sd'|')
# Lines in an order that the seed draws (Park and Miller's generator).
shuffled() {
  awk -v s="$seed" 'function next_() { return s = s * 48271 % 2147483647 }
    BEGIN { s = s % 2147483646 + 1; for (i = 0; i < 10; ++i) next_() } { printf "%d\t%s\n", next_(), $0 }' | LC_ALL=C sort -n | cut -f2-
}

# All that there is to try, in an order that the seed draws: kind, file, line, column, from, to.
mutants() {
  local all
  all=$(find src -name '*.cpp' -o -name '*.h' | grep -E "$tested" | LC_ALL=C sort | xargs awk -v thresholds='^src/(walking|gap)/' -f scripts/mutants.awk)
  { grep '^threshold' <<< "$all"; grep '^operator' <<< "$all" | shuffled | sed "${operators}q"; } | shuffled |
    if ((${#folders[@]})); then grep -E "$tab($(IFS='|'; echo "${folders[*]}"))"; else cat; fi
}

report() {
  local page=doc/results/mutation.md machine
  machine=$(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo | sed -n 1p)
  [[ -s $results ]] || fail "nothing was tried yet: make mutation"
  {
    echo "# Measured: what the tests notice"
    echo
    echo "\`make mutation\` (\`scripts/mutation.sh\`) changes one place of the code at a time, a threshold by 30 % or an operator, and"
    echo "runs the tests of its folder. A change survives when no test fails. Not every survivor is a gap: some changes have no"
    echo "effect that anybody could see, and some thresholds may well be others."
    echo
    echo "Seed $seed, $(date -u -r "$results" +%Y-%m-%d), $(nproc) cores of ${machine:-an unknown CPU}: $(wc -l < "$results") of $(folders=(); mutants | wc -l) changes were tried."
    echo
    echo "| folder | kind | tried | noticed | survived | did not compile |"
    echo "|---|---|---|---|---|---|"
    awk -F'\t' '{ split($4, p, "/"); k = "`src/" p[2] (p[2] == "gap" && p[4] != "" ? "/" p[3] : "") "` | " $3; ++n[k]; ++r[k, $1] }
      END { for (k in n) printf "| %s | %d | %d | %d | %d |\n", k, n[k], r[k, "noticed"], r[k, "survived"], r[k, "invalid"] }' "$results" | LC_ALL=C sort
    printf '\n## Survivors\n\n| place | from | to |\n|---|---|---|\n'
    awk -F'\t' '$1 == "survived" { for (i = 7; i <= 8; ++i) { gsub(/^ | $/, "", $i); gsub(/\|/, "\\|", $i) }; printf "| `%s:%s` | `%s` | `%s` |\n", $4, $5, $7, $8 }' "$results" |
      LC_ALL=C sort -t: -k1,1 -k2n
  } > "$page.new" && mv "$page.new" "$page" && echo "$page"
}

case $mode in
  list) mutants; exit ;;
  report) report; exit ;;
esac
exec 9> "$out/lock"
flock -n 9 || fail "it runs already here"
trap 'echo; echo "mutation.sh: ended; the same command goes on"; exit 130' INT TERM

# The copy, as the tree is now: only what differs is written, so that little is built anew.
refresh() {
  local file
  mkdir -p "$tree/bin"
  find configure.sh CMakeLists.txt CMakePresets.json cmake scripts src utils config tests -type f ! -path 'tests/data/*' | while read -r file; do
    cmp -s "$file" "$tree/$file" || { mkdir -p "$(dirname "$tree/$file")" && cp "$file" "$tree/$file"; }
  done
  (cd "$tree" && find src tests -type f ! -path 'tests/data/*') | while read -r file; do [[ -e $file ]] || rm "$tree/$file"; done
  ln -sfn "$PWD/tests/data" "$tree/tests/data"
}

mapfile -t todo < <(
  if [[ $survivors ]]; then
    sed -n 's/^survived\t[^\t]*\t//p' "$results" | if ((${#folders[@]})); then grep -E "$tab($(IFS='|'; echo "${folders[*]}"))"; else cat; fi
  else
    mutants | grep -vxFf <(cut -f3- "$results")
  fi | head -n "$most"
)
((${#todo[@]})) || { echo "Nothing is left to try."; exit 0; }
echo "${#todo[@]} changes to try"
refresh
# The folders that are changed are compiled source by source, so that one change costs one source.
alone=$(printf '%s\n' "${todo[@]}" | cut -f2 | cut -d/ -f2 | LC_ALL=C sort -u | sed 's/$/:1/' | paste -sd';')
(cd "$tree" && ./configure.sh --target SimRelease "-DPLUMBLINE_BUNDLES_OF=modules:4;$alone") > "$out/log" 2>&1 || fail "configure: see $out/log"

build() { (cd "$tree" && scripts/build.sh SimRelease "$@") > "$out/log" 2>&1; }
declare -A limit=()
# Runs a test program until its first failure; $2: which tests.
play() {
  (
    cd "$tree" || exit
    export TMPDIR=$out/tmp PLUMBLINE_TARGET=SimRelease PLUMBLINE_BIN=$PWD/bin
    ulimit -S -t "${limit[$1]:-3600}"
    timeout -k 5 3600 "build/SimRelease/tests/$1" --gtest_brief=1 --gtest_fail_fast "--gtest_filter=${2:-*}"
  ) > "$out/log" 2>&1 < /dev/null
}
out=$PWD/$out
mkdir -p "$out/tmp"

# Builds an area's tests as they are, and measures them; they have to pass.
prepare() {
  local TIMEFORMAT=%U used
  [[ ${limit[$1]-} ]] && return
  echo "builds the tests of $1 as they are"
  build "test-$1" || fail "tests/$1 do not build: see $out/log"
  used=$({ time play "$1" 2> /dev/null; } 2>&1) || fail "tests/$1 fail without any change: see $out/log"
  limit[$1]=$((${used%.*} * 3 + 20))
}

# One change: its result in $result.
try() { # kind file line column from to
  local area=${2#src/} areas name
  area=${area%%/*} areas=("$area")
  [[ ${LONG-} == yes && $2 == src/gap/* ]] && areas+=(diagnosis)
  for area in "${areas[@]}"; do prepare "$area"; done
  awk -v row="$3" -v at="$4" -v from="$5" -v to="$6" 'FNR == row {
    if (substr($0, at, length(from)) != from) exit 1
    $0 = substr($0, 1, at - 1) to substr($0, at + length(from)) }
    { print }' "$2" > "$tree/$2" || fail "$2:$3 is not what it was; remove $results"
  result=survived
  name=${2##*/} name=${name%.*}
  for area in "${areas[@]}"; do
    if ! build "test-$area"; then result=invalid
    # The tests that are named like the file are asked first.
    elif ! { play "$area" "*$name*" && play "$area"; }; then result=noticed; fi
    [[ $result == survived ]] || break
  done
  cp "$2" "$tree/$2"
}

tried=0
for mutant in "${todo[@]}"; do
  IFS=$tab read -r kind file row column _ <<< "$mutant"
  from=$(cut -f5 <<< "$mutant") to=$(cut -f6 <<< "$mutant")
  start=$SECONDS
  try "$kind" "$file" "$row" "$column" "$from" "$to"
  grep -vF "$tab$mutant" "$results" > "$results.new"
  printf '%s\t%s\t%s\n' "$result" "$((SECONDS - start))" "$mutant" >> "$results.new"
  mv "$results.new" "$results"
  tried=$((tried + 1))
  printf '[%d/%d] %-8s %s:%s  %s → %s  (%d s)\n' $tried ${#todo[@]} "$result" "$file" "$row" "$from" "$to" $((SECONDS - start))
done
rm -rf "$out/tmp"
echo "$(grep -c '^survived' "$results") survivors of $(wc -l < "$results") so far; scripts/mutation.sh --report writes doc/results/mutation.md"
