#!/usr/bin/env bash
# What each constant of the diagnosis changes in its answers. One constant of src/gap/inference at a time is changed by 30 %, in a
# copy of the tree (scripts/mutation.sh --program). Then recordings of a real servo are diagnosed again. How much of the gap the answer
# closes in recordings of other motions, and which causes it names, is compared with the answer without the change. Writes
# build/bench/gap-sensitivity.json and .md; `make bench-gap-sensitivity` the page.
# The recordings are not part of the project. Environment:
#   DATA   their folder [../shared/gap/real/xl330_pendulum]
#   FIT    recordings that are diagnosed [kp100_sin_sin kp100_up_and_down]
#   TESTS  those that answers are checked on [kp100_lift_and_drop kp100_sin_time_square]
#   JOBS   changes tried at a time [2]
# What was tried is in build/gap-sensitivity, so a run that was stopped goes on.
set -euo pipefail
cd "$(dirname "$0")/../../.."
data=${DATA:-../shared/gap/real/xl330_pendulum} fit=${FIT:-kp100_sin_sin kp100_up_and_down} tests=${TESTS:-kp100_lift_and_drop kp100_sin_time_square}
[[ -d $data ]] || { echo "gap-sensitivity: $data is not there: make bench-gap-sensitivity DATA=FOLDER" >&2; exit 2; }
kept=build/gap-sensitivity plan=build/mutation/plan.txt
mkdir -p "$kept" build/bench
scripts/mutation.sh --program
# number, file, line, column, from, to
awk -F'\t' -v OFS='\t' '$3 == "threshold" && $2 == "plain" && $4 ~ /^src\/gap\/inference\// { print $1, $4, $5, $6, $7, $8 }' "$plan" > "$kept/changes.tsv"
name=$(tr ' ' '+' <<< "$fit")
try() { # number, 0: no change
  local gap=build/mutation/tree/bin/gap piece=$kept/$name.$1 status=0
  [[ -s $piece.txt ]] && return
  export PLUMBLINE_MUTANT=$1
  # shellcheck disable=SC2046,SC2086
  { "$gap" diagnose $(printf "$data/%s " $fit) --json "$piece.json" --jobs 1 --quiet &&
    "$gap" check "$piece.json" $(printf "$data/%s " $tests); } > "$piece.new" 2>&1 < /dev/null || status=$?
  # What was stopped is tried again; a change that breaks the program has no answer.
  ((status != 130 && status != 143)) || exit 255
  ((status == 0)) || echo "no answer" > "$piece.new"
  mv "$piece.new" "$piece.txt"
  echo "$(find "$kept" -name "$name.*.txt" | wc -l) of $all"
}
export -f try
all=$(($(wc -l < "$kept/changes.tsv") + 1))
export data fit tests kept name all
{ echo 0; cut -f1 "$kept/changes.tsv"; } | xargs -P "${JOBS:-2}" -I{} bash -c 'try {}'
# The first figures of "Closed on average X %; the answer claims Y %", and the names of the causes.
awk -F'\t' -v kept="$kept" -v name="$name" -v json=build/bench/gap-sensitivity.json -v fit="$fit" -v tests="$tests" '
  function read(number,   line, file) {
    file = kept "/" name "." number ".txt"; closed = "none"; causes = ""
    while ((getline line < file) > 0) {
      if (line !~ /is supported by/ && match(line, /^  [a-z_]+ (at|in) [^=]*=/)) { sub(/^  /, "", line); sub(/ =.*/, "", line); causes = causes (causes == "" ? "" : ", ") line }
      if (match(line, /[Cc]losed on average -?[0-9.]+/)) { closed = substr(line, RSTART, RLENGTH); sub(/.* /, "", closed) }
    }
    close(file)
  }
  { ++n; file[n] = $2; row[n] = $3; from[n] = $5; to[n] = $6; number[n] = $1 }
  END {
    read(0); base = closed; baseCauses = causes
    print "Fitted to " fit "; checked on " tests ". Without a change the answer closes " base " % there and names " baseCauses "."
    print "Changed one at a time: " n " constants of `src/gap/inference`, each by 30 %, upward or downward as a hash of its place says, whole numbers by one at least.\n"
    for (i = 1; i <= n; ++i) {
      read(number[i]); change = closed == "none" ? -1000 : closed - base
      size[i] = change < 0 ? -change : change
      text[i] = "| `" substr(file[i], 5) "` " row[i] " | " from[i] " → " to[i] " | " (closed == "none" ? "no answer" : closed) " | " (causes == baseCauses ? "the same" : causes) " |"
      same += causes == baseCauses; within += size[i] <= 5
    }
    printf "The causes stay the same in %d, and what is closed changes by at most 5 points in %d. Those that change most first:\n\n", same, within
    print "| constant | changed | closed [%] | causes named |\n|---|---|---|---|"
    for (k = 1; k <= n; ++k) {
      best = 0
      for (i = 1; i <= n; ++i) if (!done[i] && (!best || size[i] > size[best])) best = i
      done[best] = 1; print text[best]
    }
    printf "[\n  {\"name\": \"gap-sensitivity.constants\", \"value\": %d, \"unit\": \"\", \"better\": \"lower\", \"target\": 25},\n", n > json
    printf "  {\"name\": \"gap-sensitivity.same_causes\", \"value\": %.3f, \"unit\": \"1\", \"better\": \"higher\"},\n", same / n > json
    printf "  {\"name\": \"gap-sensitivity.within_5_points\", \"value\": %.3f, \"unit\": \"1\", \"better\": \"higher\"}\n]\n", within / n > json
  }' "$kept/changes.tsv" > build/bench/gap-sensitivity.md
sed 20q build/bench/gap-sensitivity.md
