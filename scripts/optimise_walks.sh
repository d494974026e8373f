#!/usr/bin/env bash
# Finds walks of all robot types anew (the sprints of those in config/robots/ were then chosen by hand): type 0 in
# all directions, the other types from its result. Hours of CPU; the seeds are fixed. Arguments: generations of each
# search (150).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
generations=${1:-150}
search=(nice -n 10 bin/optimizewalk --tries 6 --seconds 5 --population 14)
"${search[@]}" --type 0 --anew --task forward backward sideways turn --generations "$generations"
"${search[@]}" --type 0 --task mixture --push 0.05 --tries 8 --seconds 60 --generations 30 --sigma 0.3
for type in 1 2 3 4; do
  "${search[@]}" --type "$type" --corners-of 0 --task forward backward sideways turn --sigma 0.3 --generations "$((generations / 3))"
  "${search[@]}" --type "$type" --task mixture --push 0.05 --tries 8 --seconds 60 --generations 30 --sigma 0.3
done
