#!/usr/bin/env bash
# The search of a stand-up from the front against the clock, from the motion made by hand: config/optimisation/standUpFront.yaml
# with two workers. It is stopped every SLICE minutes [3] to try what it has found TRIES times [1000], until that is as fast and as sure as
# the thesis's (table 3.1), or for MINUTES [30]. The tries do not count; stopping and going on do. Writes
# build/bench/optimisation-standup.json, .md and .svg; the search stays in the folder optimisation-standup there. TYPE [0], WORKERS [2].
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
minutes=${MINUTES:-30} slice=${SLICE:-3} tries=${TRIES:-1000} type=${TYPE:-0} workers=${WORKERS:-2} out=build/bench/optimisation-standup
for value in "$minutes" "$slice" "$tries" "$workers"; do
  [[ $value =~ ^[1-9][0-9]{0,5}$ ]] || { echo "standup.sh: '$value' is no whole number from 1 to 999999" >&2; exit 2; }
done
thesis=("620 86.4" "960 90.0" "720 91.6" "1060 93.7" "680 81.8")
[[ $type =~ ^[0-4]$ ]] || { echo "standup.sh: TYPE='$type' is no robot type from 0 to 4" >&2; exit 2; }
read -r wantedTime wantedUpright <<< "${thesis[type]}"
rm -rf "$out" "$out.tsv"
search=(bin/optserver config/optimisation/standUpFront.yaml --option "type=$type" --option motion=standUpFront --folder "$out")
server=""
trap '[[ -z $server ]] || { kill "$server" 2> /dev/null && wait "$server"; } || true' EXIT

# The line of --measure that begins with $1 as "minutes processor-minutes runs time error upright error".
try() {
  "${search[@]}" --measure "$tries" --first-seed 1000000 2> "$out.log" | awk -v what="$1" -v at="$2" -v used="$3" -v runs="$4" '
    $1 == what { for (i = 2; i + 3 <= NF; i += 4) { mean[$i] = $(i + 1); error[$i] = $(i + 3) }
      printf "%.1f\t%.1f\t%d\t%.0f\t%.1f\t%.1f\t%.1f\n", at, used, runs, mean["time"], error["time"], 100 * mean["up"], 100 * error["up"] }' | tee -a "$out.tsv"
}
# Minutes of the processor that this script's programs have used, into $used. A subshell would know its own only.
use() {
  times > "$out/times"
  used=$(awk 'NR == 2 { gsub(/[ms]/, " "); print $1 + $2 / 60 + $3 + $4 / 60 }' "$out/times")
}

mkdir -p "$out"
seconds=0 processor=0 reached=""
try start 0 0 0
while ((seconds < 60 * minutes)); do
  use
  begin=$(date +%s.%N) usedBefore=$used most=$((60 * slice < 60 * minutes - seconds ? 60 * slice : 60 * minutes - seconds))
  "${search[@]}" --workers "$workers" --port 0 --every 60 >> "$out/table.log" 2>&1 &
  server=$!
  for ((i = 0; i < 2 * most; ++i)); do kill -0 "$server" 2> /dev/null || break; sleep 0.5; done
  stopped=""
  kill -INT "$server" 2> /dev/null && stopped=yes
  status=0
  wait "$server" || status=$?
  server=""
  ((status == 0 || status == 130)) || { echo "standup.sh: the search ended with $status" >&2; tail -3 "$out/table.log" >&2; exit 1; }
  seconds=$(awk -v s="$seconds" -v b="$begin" -v e="$(date +%s.%N)" 'BEGIN { printf "%d", s + e - b + 0.5 }')
  use
  processor=$(awk -v p="$processor" -v b="$usedBefore" -v e="$used" 'BEGIN { print p + e - b }')
  runs=$(awk 'match($0, /"costs":\[[^]]*/) { n += split(substr($0, RSTART, RLENGTH), c, ",") } END { print n + 0 }' "$out/evaluations.jsonl")
  read -r _ _ _ time _ upright _ <<< "$(try found "$(awk -v s="$seconds" 'BEGIN { print s / 60 }')" "$processor" "$runs")"
  echo "after $((seconds / 60)) min: $time ms, $upright % upright"
  if awk -v t="$time" -v u="$upright" -v wt="$wantedTime" -v wu="$wantedUpright" 'BEGIN { exit !(t <= wt && u >= wu) }'; then reached=$seconds; break; fi
  [[ $stopped ]] || break # the search is over by its own rule
done
awk -v title="Stand-up from the front, type $type: what the search has found" -v xLabel="minutes with $workers workers" \
  -v yLabel="time of the motion [ms]" -f tests/support/diagram.awk <(awk -F'\t' -v wanted="$wantedTime" '
    { printf "found\t%s\t%s\t%s\t%s\n", $1, $4, $4 - $5, $4 + $5; last = $1 }
    END { printf "thesis\t0\t%s\nthesis\t%s\t%s\n", wanted, last, wanted }' "$out.tsv") > "$out.svg"
awk -F'\t' -v OFS='\t' -v type="$type" -v wt="$wantedTime" -v wu="$wantedUpright" -v reached="$reached" -v minutes="$minutes" -v workers="$workers" \
  -v tries="$tries" -v day="$(date -u +%F)" -v json="$out.json.new" '
  { at[NR] = $1; line[NR] = sprintf("| %s | %s | %s | %s ± %s | %s ± %s |", $1, $2, $3, $4, $5, $6, $7); time = $4; upright = $6; last = $1; used = $2 }
  END {
    print "## A stand-up against the clock\n"
    printf "The search `config/optimisation/standUpFront.yaml`, type %d, %d workers, from the motion made by hand, measured on %s. Every few minutes it was\n", type, workers, day
    printf "stopped, what it had found was tried %d times with seeds that it never had (mean and standard error), and it went on. The tries do not count.\n", tries
    printf "Thesis: %s ms, %s %% upright, more than 40 hours on six cores. ", wt, wu
    if (reached != "") printf "As fast and as sure after %.1f minutes.\n\n", reached / 60
    else printf "It was not as fast and as sure as that within %s minutes of the clock (%s of the processor, of %s that two free cores have).\n\n", last, used, 2 * last
    print "| minutes | of the processor | runs | time [ms] | upright [%] |\n|---|---|---|---|---|"
    for (i = 1; i <= NR; ++i) print line[i]
    print "\n![Time of the motion found](optimisation-standup.svg)"
    printf "[\n  {\"name\": \"optimisation-standup.type%d.minutes\", \"value\": %s, \"unit\": \"min\", \"better\": \"lower\"%s},\n", type, last, (reached != "" ? ", \"target\": 30" : "") > json
    printf "  {\"name\": \"optimisation-standup.type%d.time\", \"value\": %s, \"unit\": \"ms\", \"better\": \"lower\", \"target\": %s, \"peer\": \"thesis\", \"peer_value\": %s},\n", type, time, wt, wt > json
    printf "  {\"name\": \"optimisation-standup.type%d.upright\", \"value\": %s, \"unit\": \"%%\", \"better\": \"higher\", \"target\": %s, \"peer\": \"thesis\", \"peer_value\": %s}\n]\n", type, upright, wu, wu > json
  }' "$out.tsv" > "$out.md"
mv "$out.json.new" "$out.json"
cat "$out.md"
