#!/usr/bin/env bash
# Searches the sprint of a robot type in one direction in two stages: first without pushes, then with pushes, from what the first found.
# Then the rule of `bin/optimizewalk --choose` cuts the sprints until minutes of tries have no fall (doc/reference/walk.md, "Finding a
# walk"). The result is FOLDER/walking.yaml, a file for config/robots/simspark_typeTYPE/. About 16 minutes of two free cores. Stopped or
# killed, the same command goes on.
#   scripts/optimise_sprint.sh TYPE [DIRECTION]     DIRECTION: forward, backward, sideways or turn [forward]
# Variables: SEED of the first search [1]; the second has the next. WORKERS [2], FOLDER [sprintTYPE.search]. EFFORT multiplies the number
# of generations [1].
# Examples:
#   scripts/optimise_sprint.sh 1
#   SEED=7 scripts/optimise_sprint.sh 0 sideways
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
source "$(dirname "${BASH_SOURCE[0]}")/search_stages.bash"
direction=${2:-forward} folder=${FOLDER:-sprint$type.search}
[[ $direction =~ ^(forward|backward|sideways|turn)$ ]] || fail "no direction '$direction'; there are forward, backward, sideways, turn"

# Largest push in m/s, seconds of a try, candidates of a generation, runs of each, generations, sigma.
stages=("0 6 40 3 120 0.8" "0.05 8 40 4 120 0.35")
runsOfBest=12
from=$root/config/robots/simspark_type$type/walking.yaml
for ((i = 1; i <= ${#stages[@]}; ++i, ++seed)); do
  read -r push seconds population runs generations sigma <<< "${stages[i - 1]}"
  beginStage "$i" walking.yaml < "$from"
  writeStudy <<< "task: walk
options: {type: $type, direction: $direction, push: $push, seconds: $seconds}"
  echo "$name: stage $i of ${#stages[@]}: pushes of up to $push m/s"
  [[ -f $stage/done ]] || serveStage --workers "$workers" --port 0
  touch "$stage/done"
  from=$stage/search/walk.yaml
done
echo "$name: how much of it holds"
mkdir -p "$folder/found"
cp "$from" "$folder/found/walking.yaml"
"$bin/optimizewalk" --type "$type" --from "$folder/found" --task forward backward sideways turn --choose --config "$root/config" \
  --output "$folder/walking.yaml" --jobs "$workers"
echo "$name: $folder/walking.yaml"
