# A sealed set made of recordings of a real robot (here of a simulated one that has a cause of its own). Causes are
# planted in it, and the score counts what answers say beyond the recordings' own.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
arm=tests/e2e/gap/arm.json
printf 'effects:\n  - {effect: coulomb_friction, at: Elbow, value: 0.06}\n' > "$scratch/own.yaml"
for program in hang_sweep hang_multisine; do
  gap record --robot $arm --program $program --effects "$scratch/own.yaml" --seed 4 -o "$scratch/runs/$program"
done
gap blind make --from "$scratch/runs" --robot $arm --cases 4 --seed 6 -o "$scratch/planted"
grep -q '^4 cases written' "$scratch/out" || fail "no cases: $(cat "$scratch/out")"
cases=("$scratch"/planted/*/)
expectEqual ${#cases[@]} 4 "the number of cases"
if grep -rqE 'planted|servo_gain|com_offset' "$scratch/planted"; then fail "the answers can be read"; fi

# The same seed, the same bytes; another seed, another set.
gap blind make --from "$scratch/runs" --robot $arm --cases 4 --seed 6 --jobs 1 -o "$scratch/again"
diff -r "$scratch/planted" "$scratch/again" > /dev/null || fail "the same seed gives other bytes"

# Each case is diagnosed with its own model.
mkdir "$scratch/answers"
for case in "${cases[@]}"; do
  gap diagnose "$case" --robot "$case/robot.json" --json "$scratch/answers/$(basename "$case").json"
done
gap blind score "$scratch/planted" "$scratch/answers" --list all
grep -q '^4 cases' "$scratch/out" || fail "no score: $(cat "$scratch/out")"
expectEqual "$(grep -c '^case ' "$scratch/out")" 4 "the cases in the list"
gap blind score "$scratch/planted" "$scratch/answers" --json
grep -q '"top1"' "$scratch/out" || fail "no figures: $(cat "$scratch/out")"

# What cannot be is refused in one line.
expectError 2 "gap: --from excludes --engine: the reality is in the recordings" \
  "$bin/gap" blind make --from "$scratch/runs" --engine bullet -o "$scratch/x"
expectError 2 "gap: $scratch/none: is no folder; a run is a folder with run.json and run.csv" \
  "$bin/gap" blind make --from "$scratch/none" --robot $arm -o "$scratch/x"
[[ ! -e $scratch/x && ! -e $scratch/x.part ]] || fail "a refused command wrote something"
