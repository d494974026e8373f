# A NAO walks in Bullet and is recorded: the run is the contract's, the robot got ahead, the same seed gives the same
# bytes and another one other noise.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
walk=(record --robot nao_v5 --program walk_forward --truth)
gap "${walk[@]}" -o "$scratch/run"
gap "${walk[@]}" -o "$scratch/again"
gap "${walk[@]}" --seed 2 -o "$scratch/other"
cmp "$scratch/run/run.csv.gz" "$scratch/again/run.csv.gz" || fail "the same seed gives other bytes"
if cmp -s "$scratch/run/run.csv.gz" "$scratch/other/run.csv.gz"; then fail "another seed gives the same noise"; fi
grep -q '"base": "free"' "$scratch/run/run.json" || fail "its base is not free: $(cat "$scratch/run/run.json")"

# Column $1 in the last row that has one.
last() {
  zcat "$scratch/run/run.csv.gz" | awk -F, -v name="$1" '
    NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) at = i; next }
    at && $at != "" { value = $at }
    END { print value }'
}
expectEqual "$(zcat "$scratch/run/run.csv.gz" | wc -l)" 1201 "rows of 12 s at 100 Hz and one of names"
for column in cmd.LKneePitch pos.LKneePitch gyro.y acc.z fsr.LFoot.FrontLeft truth.x; do
  [[ -n $(last $column) ]] || fail "there is no $column"
done
# Ten seconds at a NAO's pace, and upright at the end.
awk -v x="$(last truth.x)" -v z="$(last truth.z)" 'BEGIN { exit !(x > 1 && x < 6 && z > 0.2) }' ||
  fail "it got to x = $(last truth.x) m with its torso at z = $(last truth.z) m"

# A walk has no secret: its motion would tell it.
expectError 2 "gap: walk_forward is walked by a robot simulated here, without --secret" \
  "$bin/gap" "${walk[@]}" --secret 3 -o "$scratch/x"
[[ ! -e $scratch/x ]] || fail "a refused command wrote something"

# Replayed from step to step, a walk with nothing wrong shows nothing.
gap record --robot nao_v5 --program walk_sideways -o "$scratch/sideways"
gap diagnose "$scratch/sideways" --json "$scratch/answer.json"
grep -q '"verdict": "none"' "$scratch/answer.json" || fail "not none: $(cat "$scratch/out")"
grep -q '"restarts": 11' "$scratch/answer.json" || fail "not from step to step: $(grep restarts "$scratch/answer.json")"
