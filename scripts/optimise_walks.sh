#!/usr/bin/env bash
# Finds the walks of the league's robots anew, those in config/robots/type*/: from config/walks/ searches for a
# quicker sprint forward, and cuts what is found to what goes through minutes of tries without a fall
# (doc/reference/walk.md, "Finding a walk"). The seeds are fixed: the same program writes the same files.
# Arguments: types (0 1 2 3 4). Environment: GENERATIONS of a search (30).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
for type in "${@:-0 1 2 3 4}"; do
  for t in $type; do
    nice -n 10 bin/optimizewalk --type "$t" --from "config/walks/type$t" --task forward backward sideways turn \
      --choose --search forward --generations "${GENERATIONS:-30}" --population 12 --tries 4 --seconds 8 --push 0.03 \
      --sigma 0.3 --seed 1
  done
done
