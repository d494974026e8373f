#!/usr/bin/env bash
# Makes the walks of the league's robots, config/robots/simspark_type*/walking.yaml, from results of searches,
# config/walks/type*/walking.yaml. Reduces the omnidirectional speeds and each sprint until minutes of tries have no
# fall (doc/reference/walk.md, "Finding a walk"). Seeds are fixed: the same program writes the same files. Some minutes.
# Over what is cut goes config/walks/type*/over: the recovery from pushes. With SEARCH=GENERATIONS every sprint forward
# and sideways is searched on from there first, and the quicker one after cutting is taken: with 90 about 15 minutes per
# type and direction. Arguments: types (all of config/walks). Examples:
#   scripts/optimise_walks.sh 3
#   SEARCH=90 scripts/optimise_walks.sh
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
if (($# == 0)); then
  for folder in config/walks/type*/; do set -- "$@" "$(basename "${folder/type/}")"; done
fi
search=()
[ -z "${SEARCH:-}" ] || search=(--search forward sideways --generations "$SEARCH" --population 16 --tries 20 --seconds 8 --push 0.06 --sigma 0.5)
for type; do
  [[ $type =~ ^[0-9]$ && -d config/walks/type$type ]] || { echo "optimise_walks.sh: no robot type '$type'; see optimise_walks.sh --help" >&2; exit 2; }
done
for type; do
  nice -n 10 bin/optimizewalk --type "$type" --from "config/walks/type$type" --task forward backward sideways turn \
    --choose --over "config/walks/type$type/over" "${search[@]}"
done
