# Running tests against a change; sourced by scripts/mutation.sh, after tree.bash.

# Runs a test program until its first failure. $1: area, $2: CPU seconds, $3: which tests; $number: of the change.
play() {
  (
    cd "$tree" || exit
    export TMPDIR=$out/tmp PLUMBLINE_TARGET=SimRelease PLUMBLINE_BIN=$PWD/bin PLUMBLINE_MUTANT=${number:-0}
    ulimit -S -t "$2"
    timeout -k 5 "$(($2 * 3 + 60))" "build/SimRelease/tests/$1" --gtest_brief=1 --gtest_fail_fast "--gtest_filter=$3"
  ) > "$out/log" 2>&1 < /dev/null 9>&-
}

# Builds an area's tests and notes what each reaches and takes, each in a process of its own: what tests leave to each
# other in a program's memory must not hide anything. They have to pass.
declare -A prepared=()
prepare() {
  local record=$out/record-$1.txt test number=0
  [[ ${prepared[$1]-} ]] && return
  echo "builds the tests of $1"
  buildSwitched "test-$1" || fail "tests/$1 do not build: see $out/log"
  prepared[$1]=yes
  [[ -s $record && ! $tree/build/SimRelease/tests/$1 -nt $record ]] && return
  echo "notes what each of them reaches"
  rm -f "$record" "$record.new"
  while read -r test; do
    PLUMBLINE_RECORD=$record.new play "$1" 3600 "$test" || fail "tests/$1: $test fails without any change: see $out/log"
  done < <("$tree/build/SimRelease/tests/$1" --gtest_list_tests | awk '/^[^ ].*\./ { suite = $1 } /^  / && !/DISABLED_/ { print suite $1 }')
  LC_ALL=C sort -u "$record.new" > "$record"
}

# Tries the change $number with an area's tests; $state and $file are its own. The result is in $result.
judge() {
  local area=$1 ms filter name=${file##*/} near=""
  [[ $state == own ]] && near=$(awk -F'\t' -v file="$file" '$4 == file { print $1 }' "$plan" | paste -sd' ')
  while IFS=$tab read -r ms filter; do
    result=survived
    play "$area" "$((ms * 3 / 1000 + 5))" "$filter" || { (($? == 97)) && result=invalid || result=noticed; return; }
  done < <(awk -v number="$number" -v name="${name%.*}" -v own="${near:+yes}" -v near="$near" -f scripts/mutation/select.awk "$out/record-$area.txt")
}

# One change: its result in $result.
try() { # number file
  local number=$1 file=$2 state areas area
  areas=("${file#src/}")
  areas=("${areas[0]%%/*}")
  [[ ${LONG-} == yes && $file == src/gap/* ]] && areas+=(diagnosis)
  for area in "${areas[@]}"; do prepare "$area"; done
  state=$(awk -F'\t' -v n="$number" '$1 == n { print $2 }' "$plan") # which a build may have changed
  result=unreached
  [[ $state == own ]] && place "$file" "$number"
  for area in "${areas[@]}"; do
    if [[ $state == own ]] && ! build "test-$area"; then result=invalid; else judge "$area"; fi
    [[ $result == noticed || $result == invalid ]] && break
  done
  [[ $state == own ]] && place "$file"
}
