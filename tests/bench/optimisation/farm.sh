#!/usr/bin/env bash
# Thirty real workers whose evaluations sleep, 1 s with 30 % deviation, behind a real server: which share of their time they
# evaluate, with a barrier between generations and without: build/bench/optimisation_farm.json. SECONDS of an evaluation: SLEEP [1].
set -euo pipefail
workers=${WORKERS-30} sleep=${SLEEP-1}
scratch=$(mktemp -d)
server=""
trap '[[ -z $server ]] || kill "$server" 2> /dev/null || true; rm -rf "$scratch"' EXIT
lines=()
for kind in barrier asynchronous; do
  population=30 ahead=1
  [[ $kind == barrier ]] || population=18 ahead=3
  cat > "$scratch/$kind.yaml" << END
task: function
options: {function: sphere, dimension: 10, sleep: $sleep, spread: 0.3}
population: $population
ahead: $ahead
runs: 1
sameSeeds: false
target: 1e-8
evaluations: 20000
END
  bin/optserver "$scratch/$kind.yaml" --folder "$scratch/$kind" --workers "$workers" --port 0 --every 1000 > "$scratch/$kind.out" 2>&1 &
  server=$!
  until [[ -s $scratch/$kind/port ]]; do sleep 0.1; done
  port=$(< "$scratch/$kind/port")
  until bin/optserver --status --port "$port" 2> /dev/null | grep -q "\"workers\":$workers[,}]"; do
    kill -0 "$server" || { echo "farm.sh: the search ended before all workers were there" >&2; exit 1; }
    sleep 0.5
  done
  # From here on all are there: what they have slept by now does not count.
  before=$(wc -l < "$scratch/$kind/evaluations.jsonl") begin=$(date +%s.%N)
  wait "$server" || { echo "farm.sh: the server ended with $?" >&2; exit 1; }
  server="" end=$(date +%s.%N)
  grep -q "over (targetCost)" "$scratch/$kind.out" || { echo "farm.sh: the search did not arrive" >&2; exit 1; }
  read -r slept evaluations < <(sed 's/.*"slept":\([0-9.eE+-]*\).*/\1/' "$scratch/$kind/evaluations.jsonl" |
    awk -v before="$before" 'NR > before { sum += $1 } END { print sum, NR - 1 }')
  efficiency=$(awk -v s="$slept" -v b="$begin" -v e="$end" -v w="$workers" 'BEGIN { printf "%.2f", 100 * s / (w * (e - b)) }')
  target=""
  [[ $kind == barrier ]] || target=', "target": 95'
  lines+=("{\"name\": \"optimisation.real_farm$workers.$kind.efficiency\", \"value\": $efficiency, \"unit\": \"%\", \"better\": \"higher\"$target}"
    "{\"name\": \"optimisation.real_farm$workers.$kind.evaluations\", \"value\": $evaluations, \"unit\": \"evaluations\", \"better\": \"lower\"}")
  echo "$kind: efficiency $efficiency %, $evaluations evaluations"
done
mkdir -p build/bench
(IFS=,; printf '[%s]\n' "${lines[*]}") | sed 's/},{/},\n {/g' > build/bench/optimisation_farm.json.new
mv build/bench/optimisation_farm.json.new build/bench/optimisation_farm.json
