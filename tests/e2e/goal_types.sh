# Every robot type scores.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
for type in 0 1 2 3 4; do
  "$bin/game" --type $type --seed 11 --output "$scratch/$type" > "$scratch/out" || fail "type $type: $(tail -1 "$scratch/out")"
  expectEqual "$(value "$scratch/$type/summary.json" goal)" true "goal of type $type"
done
