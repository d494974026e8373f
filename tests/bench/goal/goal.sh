#!/usr/bin/env bash
# What `make run` plays, one robot alone on the embedded simulator until it scores, for many seeds and each robot type.
# How long until the goal, how often there is one and how often the robot falls. The same again with kickRight as the only kick, which was
# made by hand. BEFORE, the folder of an earlier state that is built (bin and config), plays the same seeds; BEFORE_NAME says what it
# is. Without it its runs come from before.tsv next to this script, so that the page keeps them; those of a new BEFORE are in
# build/bench/goal.work/before.tsv. Other settings by the environment: SEEDS of each type [25], SEED of the first [1],
# TYPES ["0 1 2 3 4"], LIMIT in simulated seconds [300], JOBS at once [cores]. Writes build/bench/goal.json, goal.md and goal.svg. `make bench-goal` builds what it needs and writes doc/results/goal.md.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
seeds=${SEEDS:-25} seed=${SEED:-1} types=${TYPES:-0 1 2 3 4} limit=${LIMIT:-300} jobs=${JOBS:-$(nproc)} out=build/bench/goal
for value in "$seeds" "$seed" "$limit" "$jobs"; do
  [[ $value =~ ^[1-9][0-9]{0,5}$ ]] || { echo "goal.sh: '$value' is no whole number from 1 to 999999" >&2; exit 2; }
done
[[ $types =~ ^[0-4](\ [0-4])*$ ]] || { echo "goal.sh: TYPES='$types' are no robot types from 0 to 4" >&2; exit 2; }
[[ ! ${BEFORE-} || -x $BEFORE/bin/game ]] || { echo "goal.sh: BEFORE=$BEFORE: no bin/game there" >&2; exit 2; }
work=$PWD/$out.work
rm -rf "$work"
mkdir -p "$work"

# One run as a line "type seed goal time falls". A run that did not come to its end is none, and ends all.
one() { # folder of the state, configuration of the agent or nothing, type, seed
  local folder status=0
  folder=$(mktemp -d -p "$work")
  "$1/bin/game" ${2:+--agent-option=--config "--agent-option=$2"} --type "$3" --seed "$4" --limit "$limit" --output "$folder" > "$folder.log" 2>&1 || status=$?
  if ((status > 1)) || [[ ! -s $folder/summary.json ]]; then
    echo "goal.sh: type $3, seed $4: $(tail -1 "$folder.log")" >&2
    return 255 # xargs starts no more
  fi
  awk -v type="$3" -v seed="$4" '
    function field(key,   found) {
      if (!match($0, "\"" key "\": *[^,}]*")) return ""
      found = substr($0, RSTART, RLENGTH); sub(/^[^:]*: */, "", found); return found
    }
    { all = all $0 } END { $0 = all; goal = field("goal") == "true"
      printf "%d\t%d\t%d\t%.2f\t%d\n", type, seed, goal, goal ? field("goal_time_s") : field("sim_time_s"), field("falls") }' "$folder/summary.json"
  rm -rf "$folder" "$folder.log"
}
export -f one
export work limit

play() { # folder of the state, file for the lines, configuration of the agent
  for type in $types; do seq -f "$type %.0f" "$seed" "$((seed + seeds - 1))"; done |
    xargs -P "$jobs" -L 1 bash -c 'one "$@"' one "$1" "${3-}" > "$2.part"
  LC_ALL=C sort -n -k1,1 -k2,2 "$2.part" > "$2"
  rm "$2.part"
}
# The state of a folder: its commit and that commit's day, where it has one.
stateOf() { git -C "$1" log -1 --format='commit %h of %cs' 2> /dev/null || echo "an earlier state"; }

echo "$seeds seeds from $seed on, types $types, at most $limit s, $jobs at once"
play "$PWD" "$work/now.tsv"
cp -r config "$work/config"
rm "$work"/config/robots/simspark_type*/motions/kick{Long,Shot}.yaml
play "$PWD" "$work/hand.tsv" "$work/config"
before=tests/bench/goal/before.tsv
if [[ ${BEFORE-} ]]; then
  before=$work/before.tsv
  play "$(realpath "$BEFORE")" "$work/played.tsv"
  { echo "# $(stateOf "$BEFORE")${BEFORE_NAME:+, $BEFORE_NAME}, played on $(date -u +%F), at most $limit s"; cat "$work/played.tsv"; } > "$before"
fi
[[ -f $before ]] || before=/dev/null
awk -v seeds="$seeds" -v first="$seed" -v types="$types" -v limit="$limit" -v json="$out.json" -v drawn="$work/drawn.tsv" \
  -f tests/support/interval.awk -f tests/bench/goal/table.awk "$before" "$work/hand.tsv" "$work/now.tsv" > "$out.md"
names=$(printf 'type %s|' $types)
awk -v title="One robot alone: time to the goal, median and its 95 % interval" -v xLabel="" -v yLabel="simulated seconds" -v marks=1 \
  -v xNames="${names%|}" -f tests/support/diagram.awk "$work/drawn.tsv" > "$out.svg"
printf '\n![Time to the goal by robot type](goal.svg)\n' >> "$out.md"
cat "$out.md"
