# From a simulated robot with a secret effect to a correct report in three commands. Then the next steps: the motion to
# record next, the effects in a simulator, and a browser that shows the report.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
for program in node chromium; do
  command -v $program > /dev/null || fail "no $program: scripts/install_packages.sh scripts/packages-test.txt installs it"
done
mkdir -p build/e2e
scripts/build_page.sh || fail "the report's page could not be built"
arm=tests/e2e/gap/arm.json

# Two joints and two motions, so that it is quick; the three commands are those of the README.
gap record --robot $arm --program hang_sweep --program hang_multisine --secret 5 -o "$scratch/runs"
[[ $(find "$scratch/runs" -name run.json | wc -l) == 2 ]] || fail "there are not two runs: $(ls "$scratch/runs")"
if grep -rqi 'load_friction' "$scratch/runs" "$scratch/out"; then fail "the secret can be read"; fi
gap diagnose "$scratch/runs" --robot $arm --json "$scratch/answer.json"
gap report "$scratch/answer.json" --robot $arm -o "$scratch/report.html"

gap reveal "$scratch/runs"
secret=$(sed -n 's/.*effect: "\([a-z_]*\)", at: "\([^"]*\)".*/\1 \2/p' "$scratch/out")
expectEqual "$secret" "load_friction Elbow" "the secret"
answer=$(node -e 'const a = JSON.parse(require("fs").readFileSync(process.argv[1])); console.log(a.verdict, a.effects[0].effect, a.effects[0].at, a.effects[0].probability > 0.8, a.gap.closed > 0.9)' "$scratch/answer.json")
expectEqual "$answer" "effect $secret true true" "the answer"
timeout 900 node tests/e2e/gap/report.mjs "$scratch/report.html" "friction of Elbow grows with the load that the gear transmits" build/e2e/gap-report.png ||
  fail "the report in the browser; see above"

# Of long runs segments are looked at; they stand in the report like runs.
gap diagnose "$scratch/runs" --robot $arm --seconds 12 --json "$scratch/segments.json"
grep -q 'segments of these long runs' "$scratch/err" || fail "nothing is said of segments: $(cat "$scratch/err")"
answer=$(node -e 'const a = JSON.parse(require("fs").readFileSync(process.argv[1])); console.log(a.effects[0]?.effect, a.effects[0]?.at, a.runs.length === a.map.time.length, a.runs.every((r) => / \([0-9]+ s\)$/.test(r.motion)))' "$scratch/segments.json")
expectEqual "$answer" "$secret true true" "the answer from segments"

# Stopped at once (timeout sends two signals), nothing half-written; standard output that is full.
status=0
timeout -s INT --preserve-status 1 "$bin/gap" diagnose "$scratch/runs" --robot $arm --jobs 1 --json "$scratch/stopped.json" 2> "$scratch/err" ||
  status=$?
expectEqual $status 130 "the status of a diagnosis that was stopped"
grep -q '^gap: stopped; ' "$scratch/err" || fail "stopped: $(cat "$scratch/err")"
[[ ! -e $scratch/stopped.json && ! -e $scratch/stopped.json.part ]] || fail "a diagnosis that was stopped wrote an answer"
for command in "effects --robot $arm" "reveal $scratch/runs" "--help" "apply $scratch/answer.json -o $scratch/full.yaml"; do
  status=0
  "$bin/gap" $command > /dev/full 2> "$scratch/err" || status=$?
  expectEqual $status 2 "the status of gap $command on a full disk"
  grep -q '^gap: cannot write to standard output' "$scratch/err" || fail "gap $command on a full disk: $(cat "$scratch/err")"
done

# What was found goes into a simulator, and a robot with it is explained.
gap apply "$scratch/answer.json" -o "$scratch/effects.yaml"
gap record --robot $arm --program hang_sweep --effects "$scratch/effects.yaml" --seed 2 -o "$scratch/check"
gap next "$scratch/answer.json" --robot $arm -o "$scratch/next.yaml"
grep -q 'times the noise' "$scratch/out" || fail "gap next gives no figure: $(cat "$scratch/out")"
gap record --robot $arm --program "$scratch/next.yaml" -o "$scratch/next"
[[ -s $scratch/next/run.csv.gz ]] || fail "the next motion was not recorded"
# The same seed, the same bytes.
gap record --robot $arm --program hang_sweep --effects "$scratch/effects.yaml" --seed 2 -o "$scratch/again"
cmp "$scratch/check/run.csv.gz" "$scratch/again/run.csv.gz" || fail "the same seed gives other bytes"

# What is there is replaced where that is asked for.
gap record --robot $arm --program hang_sweep --force -o "$scratch/again"
cmp -s "$scratch/check/run.csv.gz" "$scratch/again/run.csv.gz" && fail "--force replaced nothing"
mkdir "$scratch/home" && touch "$scratch/home/thesis.tex"
expectError 2 "gap: $scratch/home/thesis.tex is not a recording; --force replaces only folders of recordings" \
  "$bin/gap" record --robot $arm --program hang_sweep --force -o "$scratch/home"

# What cannot be is refused in one line.
expectError 2 "gap: there is no command diagnos; did you mean \"diagnose\"?; see gap --help" "$bin/gap" diagnos runs
expectError 2 "gap: $scratch/check exists already; --force replaces it, or name a new folder with -o" \
  "$bin/gap" record --robot $arm --program hang_sweep -o "$scratch/check"
expectError 2 "gap: record needs --program or --battery, one of them" "$bin/gap" record --robot $arm -o "$scratch/x"
printf 'effects:\n  - {effect: backlsh, at: Elbow, value: 0.1}\n' > "$scratch/bad.yaml"
expectError 2 "gap: $scratch/bad.yaml:2: effects[0].effect is \"backlsh\"; the library has no such effect; did you mean \"backlash\"?" \
  "$bin/gap" record --robot $arm --program hang_sweep --effects "$scratch/bad.yaml" -o "$scratch/x"
printf 'effects:\n  - {effect: backlash, at: Elbow, value: 7}\n' > "$scratch/bad.yaml"
expectError 2 "gap: $scratch/bad.yaml:2: effects[0].value is 7; backlash goes from 0 to 0.4 rad" \
  "$bin/gap" record --robot $arm --program hang_sweep --effects "$scratch/bad.yaml" -o "$scratch/x"
echo '{"verdict": "perhaps"}' > "$scratch/bad.json"
expectError 2 "gap: $scratch/bad.json: has the verdict 'perhaps'; it must be none, effect or unknown; bin/gap diagnose RUNS --json FILE writes an answer" \
  "$bin/gap" report "$scratch/bad.json" -o "$scratch/x.html"
expectError 2 "gap: $scratch/none.json: there is no such file" "$bin/gap" next "$scratch/none.json"
expectError 2 "gap: $scratch: no secret there; bin/gap record --secret writes one" "$bin/gap" reveal "$scratch"
[[ ! -e $scratch/x && ! -e $scratch/x.html ]] || fail "a refused command wrote something"

# How far values go on a robot.
gap effects --robot $arm
head -1 "$scratch/out" | grep -q 'Values looked for on ' || fail "no head line: $(head -1 "$scratch/out")"
expectEqual "$(grep -A2 '^link_mass ' "$scratch/out" | tail -1 | sed 's/^ *//')" "Looked for: -0.4 to 1.5" "masses"
grep -A2 '^fsr_gain ' "$scratch/out" | grep -q 'no place on this robot' || fail "an arm has force sensors"

# A benchmark on a robot of one's own.
gap blind make --robot $arm --engine replay --cases 3 --seed 4 -o "$scratch/blind"
[[ $(find "$scratch/blind" -mindepth 1 -maxdepth 1 -type d | wc -l) == 3 ]] || fail "there are not three cases"
case=$(find "$scratch/blind" -mindepth 1 -maxdepth 1 -type d | sort | head -1)
gap diagnose "$case" --robot $arm --json "$scratch/answers/$(basename "$case").json"
gap blind score "$scratch/blind" "$scratch/answers"
grep -q '^3 cases' "$scratch/out" || fail "no score: $(cat "$scratch/out")"
gap blind score "$scratch/blind" "$scratch/answers" --list all
expectEqual "$(grep -c '^case ' "$scratch/out")" 3 "the cases in the list"
expectEqual "$(grep -c '^  said:   no answer$' "$scratch/out")" 2 "the cases without an answer"
