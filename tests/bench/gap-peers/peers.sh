#!/usr/bin/env bash
# Head to head on recordings of real robots: bin/gap diagnose, and what bin/gap check measures of its answer on recordings
# of other motions. Beside it stands what other ways of fitting do there (PeersBench.cpp, which runs before this). Writes
# build/bench/gap-peers.json and .md.
# The recordings are not part of the project. Environment:
#   DATA     their folder [../shared/gap/real]
#   SPLIT    one split alone (splits.txt): xl330.kp100, say
#   METHODS  of bin/gap diagnose [sets]; blocks is the other
# A piece that is in build/gap-peers is taken as it is, so a run that was stopped goes on.
set -euo pipefail
data=${DATA:-../shared/gap/real} kept=build/gap-peers
[[ -d $data ]] || { echo "bench gap-peers: $data is not there: make bench-gap-peers DATA=FOLDER" >&2; exit 2; }
mkdir -p "$kept" build/bench
# shellcheck disable=SC2046
check() { bin/gap check "$piece.json" $(printf "$data/$robot/%s " $tests) --robot "$robot" "$@" < /dev/null; }
done=()
while IFS='|' read -r name robot fit tests; do
  [[ $name && $name != \#* ]] || continue
  for method in ${METHODS:-sets}; do
    piece=$kept/$name.$method
    if [[ ! -s $piece.check.json && (${SPLIT:-$name} == "$name") ]]; then
      # shellcheck disable=SC2046  # one word per recording
      bin/gap diagnose $(printf "$data/$robot/%s " $fit) --method "$method" --robot "$robot" --seconds 20 --json "$piece.json" \
        --timing "$piece.timing.json" < /dev/null
      ! grep -q '"model"' "$piece.json" || check --further --json "$piece.further.json"
      check --json "$piece.check.json"
    fi
    [[ ! -s $piece.check.json ]] || done+=("$piece")
  done
done < tests/bench/gap-peers/splits.txt
node tests/bench/gap-peers/page.mjs "$kept" "${done[@]}"
cat build/bench/gap-peers.md
