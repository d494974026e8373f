# Diagnosis by sets of causes, which is how robots with a held base are diagnosed: what it claims of recordings left out is what bin/gap check measures on others.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
command -v node > /dev/null || fail "no node: scripts/install_packages.sh scripts/packages-test.txt installs it"
arm=tests/e2e/gap/arm.json
ask() { node -e "const a = JSON.parse(require('fs').readFileSync(process.argv[1])); console.log($2)" "$1"; }

printf 'effects:\n  - {effect: coulomb_friction, at: Elbow, value: 0.15}\n' > "$scratch/friction.yaml"
for program in hang_sweep hang_small; do
  gap record --robot $arm --program $program --effects "$scratch/friction.yaml" --seed 2 -o "$scratch/seen/$program"
done
gap record --robot $arm --program hang_multisine --effects "$scratch/friction.yaml" --seed 3 -o "$scratch/unseen"

gap diagnose "$scratch/seen" --robot $arm --max-causes 2 --jobs 1 --json "$scratch/answer.json"
expectEqual "$(ask "$scratch/answer.json" 'a.verdict, a.effects.length, a.effects[0].effect, a.effects[0].at, a.gap.runs.length, a.gap.left_out')" \
  "effect 1 coulomb_friction Elbow 2 recordings" "the answer"
grep -q '^Left out of search and fit, each in turn:$' "$scratch/out" || fail "no table: $(cat "$scratch/out")"
grep -q 'pos.Elbow' "$scratch/out" || fail "no line per joint: $(cat "$scratch/out")"

# What is claimed and what is closed on a recording that the answer never saw.
gap check "$scratch/answer.json" "$scratch/unseen" --robot $arm --json "$scratch/check.json"
grep -q '^Closed on average [0-9]* %; the answer claims [0-9]* % (90 %: -\?[0-9]* to [0-9]* %)\.$' "$scratch/out" || fail "check: $(cat "$scratch/out")"
expectEqual "$(ask "$scratch/check.json" 'a.runs.length, a.verdict, a.closed > a.claimed_interval[0], a.closed > 0.6, a.runs[0].signals["pos.Elbow"].unit')" \
  "1 effect true true rad" "the check"

# Where more is missing than is named, all values of all joints are fitted beside, to be checked and applied by themselves.
printf '  - {effect: viscous_friction, at: Shoulder, value: 0.3}\n' | cat "$scratch/friction.yaml" - > "$scratch/two.yaml"
for program in hang_sweep hang_small; do
  gap record --robot $arm --program $program --effects "$scratch/two.yaml" --seed 2 -o "$scratch/two/$program"
done
gap record --robot $arm --program hang_multisine --effects "$scratch/two.yaml" --seed 3 -o "$scratch/two_unseen"
gap diagnose "$scratch/two" --robot $arm --max-causes 1 --jobs 1 --json "$scratch/two.json"
cp "$scratch/out" "$scratch/diagnosed"
grep -q '^A further [0-9]* % closes by fitting [0-9]* values of all joints at once; not attributable\.$' "$scratch/out" ||
  fail "nothing further: $(cat "$scratch/out")"
gap check "$scratch/two.json" "$scratch/two_unseen" --robot $arm --json "$scratch/named.json"
gap check "$scratch/two.json" "$scratch/two_unseen" --robot $arm --further --json "$scratch/further.json"
grep -q '^The values of all joints are checked, not the causes named\.$' "$scratch/out" || fail "check: $(cat "$scratch/out")"
closed() { ask "$1" 'a.closed'; }
expectEqual "$(node -e "console.log($(closed "$scratch/further.json") > $(closed "$scratch/named.json"))")" true "all values close more"
expectEqual "$(ask "$scratch/two.json" 'a.verdict, a.gap.further.attributable, a.gap.further.claimed')" \
  "unknown false $(ask "$scratch/further.json" 'a.claimed')" "what is further"
expectError 2 "gap: $scratch/two.json: the verdict is unknown, its effects are not the cause; --anyway writes the nearest, --further the values of all joints" \
  "$bin/gap" apply "$scratch/two.json" -o "$scratch/none.yaml"
gap apply "$scratch/two.json" --further -o "$scratch/model.yaml"
# The kind found has a value in each joint, and those are what is applied.
expectEqual "$(ask "$scratch/two.json" 'new Set(a.gap.model.map((c) => c.effect)).size, a.gap.model.length > a.effects.length')" "1 true" \
  "values in each joint"
grep -q '^  [a-z_]* in [0-9] joints: [-0-9.e]* to [-0-9.e]* ' "$scratch/diagnosed" || fail "no values in each joint: $(cat "$scratch/diagnosed")"
gap apply "$scratch/two.json" --anyway -o "$scratch/nearest.yaml"
expectEqual "$(grep -c '^ *- ' "$scratch/nearest.yaml")" "$(ask "$scratch/two.json" 'a.gap.model.length')" "what is applied"
gap record --robot $arm --program hang_multisine --effects "$scratch/model.yaml" --seed 3 -o "$scratch/model"
expectError 2 "gap: $scratch/answer.json: has no values of all joints (gap.further.model); answers with the verdict unknown about robots whose base is fixed have them" \
  "$bin/gap" check "$scratch/answer.json" "$scratch/unseen" --robot $arm --further

# The report shows both, recording by recording, when it is given the check.
if [[ -s build/report/page.html ]]; then
  gap report "$scratch/answer.json" --check "$scratch/check.json" --robot $arm -o "$scratch/report.html"
  grep -q '"claimed_interval"' "$scratch/report.html" || fail "the report does not hold the check"
  expectError 2 "gap: $scratch/answer.json: has no number 'closed' or no list 'runs'; bin/gap check ANSWER RUNS --json FILE writes one" \
    "$bin/gap" report "$scratch/answer.json" --check "$scratch/answer.json" -o "$scratch/none.html"
fi

# Another number of threads, the same bytes; nothing where nothing is.
gap diagnose "$scratch/seen" --robot $arm --max-causes 2 --jobs 2 --json "$scratch/again.json"
cmp "$scratch/answer.json" "$scratch/again.json" || fail "two threads give another answer"
gap record --robot $arm --program hang_sweep --program hang_small --seed 4 -o "$scratch/clean"
gap diagnose "$scratch/clean" --robot $arm --json "$scratch/clean.json"
expectEqual "$(ask "$scratch/clean.json" 'a.verdict, a.effects.length')" "none 0" "the answer to a clean robot"

# Stopped within a second, and nothing is written.
status=0
timeout -s INT --preserve-status 0.3 "$bin/gap" diagnose "$scratch/seen" --robot $arm --jobs 1 \
  --json "$scratch/stopped.json" 2> "$scratch/err" || status=$?
expectEqual $status 130 "the status of a diagnosis that was stopped"
expectEqual "$(cat "$scratch/err")" "gap: stopped; nothing was written" "what a stopped diagnosis says"
[[ ! -e $scratch/stopped.json ]] || fail "a diagnosis that was stopped wrote an answer"

expectError 2 "gap: $scratch/nothing.json: there is no such file" "$bin/gap" check "$scratch/nothing.json" "$scratch/unseen" --robot $arm
