#!/usr/bin/env bash
# Searches the sprint of a robot type in one direction in two stages: first without pushes, then with pushes, from what the first found.
# A search with pushes from the beginning ends near the sprint that it began with (doc/reference/walk.md, "Finding a walk"). Then the rule
# of `bin/optimizewalk --choose` cuts the sprints until minutes of tries have no fall. The result is FOLDER/walking.yaml, a file for
# config/robots/simspark_typeTYPE/. About 15 minutes of two cores. Stopped or killed, the same command goes on.
#   scripts/optimise_sprint.sh TYPE [DIRECTION]     DIRECTION: forward, backward, sideways or turn [forward]
# Variables: SEED of the searches [1], WORKERS [2], FOLDER [sprintTYPE.search]. EFFORT multiplies the number of generations [1].
# Examples:
#   scripts/optimise_sprint.sh 1
#   SEED=7 scripts/optimise_sprint.sh 0 sideways
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
fail() { echo "optimise_sprint.sh: $*; see optimise_sprint.sh --help" >&2; exit 2; }
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
bin=${BIN:-$root/bin}
(($# == 1 || $# == 2)) || fail "needs a type"
type=$1 direction=${2:-forward} seed=${SEED:-1} workers=${WORKERS:-2} effort=${EFFORT:-1} folder=${FOLDER:-sprint$1.search}
[[ $type =~ ^[0-9]$ && -d $root/config/robots/simspark_type$type ]] || fail "no robot type '$type'"
[[ $direction =~ ^(forward|backward|sideways|turn)$ ]] || fail "no direction '$direction'; there are forward, backward, sideways, turn"
[[ $seed =~ ^[0-9]{1,9}$ ]] || fail "SEED is a whole number, not '$seed'"
[[ $effort =~ ^[0-9]+(\.[0-9]+)?$ ]] || fail "EFFORT is a number, not '$effort'"
mkdir -p "$folder"

# Largest push in m/s, seconds of a try, candidates of a generation, runs of each, generations, sigma.
stages=("0 6 40 3 200 1" "0.1 8 36 4 100 0.4")
from=$root/config/robots/simspark_type$type/walking.yaml
for ((i = 1; i <= ${#stages[@]}; ++i)); do
  read -r push seconds population runs generations sigma <<< "${stages[i - 1]}"
  stage=$folder/stage$i
  mkdir -p "$stage"
  if [[ ! -f $stage/study.yaml ]]; then
    rm -rf "$stage/config"
    cp -r "$root/config" "$stage/config"
    cp "$from" "$stage/config/robots/simspark_type$type/walking.yaml"
    cat > "$stage/study.new" << STUDY
task: walk
options: {type: $type, direction: $direction, push: $push, seconds: $seconds}
optimizer: cmaes
seed: $((seed + i - 1))
population: $population
sigma: $sigma
ahead: 1
runs: $runs
runsOfBest: 12
generations: $(awk "BEGIN { g = int($generations * $effort + 0.5); print g < 1 ? 1 : g }")
STUDY
    mv "$stage/study.new" "$stage/study.yaml"
  fi
  echo "optimise_sprint.sh: stage $i of ${#stages[@]}: pushes of up to $push m/s"
  [[ -f $stage/search/walk.yaml && -f $stage/done ]] ||
    "$bin/optserver" "$stage/study.yaml" --config "$stage/config" --folder "$stage/search" --workers "$workers" --port 0
  touch "$stage/done"
  from=$stage/search/walk.yaml
done
echo "optimise_sprint.sh: how much of it holds"
mkdir -p "$folder/found"
cp "$from" "$folder/found/walking.yaml"
"$bin/optimizewalk" --type "$type" --from "$folder/found" --task forward backward sideways turn --choose --config "$root/config" \
  --output "$folder/walking.yaml" --jobs "$workers"
echo "optimise_sprint.sh: $folder/walking.yaml"
