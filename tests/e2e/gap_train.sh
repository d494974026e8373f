# What a diagnosis found is trained with: walk training, simulator and a study take its answer as it stands; what a robot
# cannot have is refused before anything is tried.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
cat > "$scratch/answer.json" << 'END'
{"verdict": "effect", "effects": [
  {"effect": "link_mass", "at": "torso", "axis": null, "value": 0.4, "unit": "kg", "probability": 0.9, "interval": [0.3, 0.5]},
  {"effect": "coulomb_friction", "at": "LKneePitch", "axis": null, "value": 0.3, "unit": "N m", "probability": 0.8}],
 "gap": {"closed": 0.9}}
END
# Limits are of what it computes: a busy machine is no failure.
walk() { (ulimit -S -t 240; exec "$bin/optimizewalk" "$@") > "$scratch/out" 2> "$scratch/err" || fail "optimizewalk $*: $(cat "$scratch/err")"; }
few=(--task forward --tries 1 --seconds 2 --jobs 2)

# A robot with position servos: the answer changes what a walk does, the same one to the same.
walk --robot nao_v5 "${few[@]}" --try
nominal=$(< "$scratch/out")
walk --robot nao_v5 "${few[@]}" --try --effects "$scratch/answer.json"
found=$(< "$scratch/out")
[[ $nominal == "forward, nao_v5: speed "* ]] || fail "the nominal robot: $nominal"
[[ $found == "forward, nao_v5: speed "* && $found != "$nominal" ]] || fail "with the effects as without: $found"
"$bin/gap" apply "$scratch/answer.json" -o "$scratch/effects.yaml" > /dev/null || fail "apply"
walk --robot nao_v5 "${few[@]}" --try --effects "$scratch/effects.yaml"
expectEqual "$(< "$scratch/out")" "$found" "the same effects as a file of bin/gap apply"

# A search on that robot writes a walk, twice the same.
for folder in one two; do
  mkdir "$scratch/$folder"
  walk --robot nao_v5 "${few[@]}" --effects "$scratch/answer.json" --generations 1 --population 4 \
    --output "$scratch/$folder/walking.yaml"
done
cmp "$scratch/one/walking.yaml" "$scratch/two/walking.yaml" || fail "the same search finds another walk"
walk --robot nao_v5 "${few[@]}" --try --effects "$scratch/answer.json" --from "$scratch/one"

# The league's robots have velocity motors.
cat > "$scratch/league.json" << 'END'
{"verdict": "effect", "effects": [{"effect": "profile_speed", "at": "LKneePitch", "axis": null, "value": 1.0}]}
END
walk --type 0 "${few[@]}" --try
nominal=$(< "$scratch/out")
walk --type 0 "${few[@]}" --try --effects "$scratch/league.json"
[[ $(< "$scratch/out") != "$nominal" ]] || fail "the league's robot walks with the effect as without: $nominal"

# A study's task reads the file itself.
cat > "$scratch/study.yaml" << END
task: standUp
options: {type: 0, direction: front, effects: "$scratch/league.json"}
population: 4
runs: 1
runsOfBest: 1
generations: 1
END
(ulimit -S -t 240; exec "$bin/optserver" "$scratch/study.yaml" --folder "$scratch/study" --workers 1 --port 0) \
  > "$scratch/out" 2>&1 || fail "the study: $(tail -3 "$scratch/out")"
grep -q "over (maxGenerations)" "$scratch/out" || fail "the study did not end: $(tail -3 "$scratch/out")"

# What cannot be is refused in one line, and nothing is written.
sed 's/"verdict": "effect"/"verdict": "unknown"/' "$scratch/answer.json" > "$scratch/unknown.json"
expectError 2 "optimizewalk: $scratch/unknown.json: the verdict is unknown, its effects are not the cause; bin/gap apply writes the nearest with --anyway, the values of all joints with --further" \
  "$bin/optimizewalk" --robot nao_v5 --try --effects "$scratch/unknown.json"
cat > "$scratch/late.yaml" << 'END'
effects:
  - {effect: command_delay, at: "*", value: 0.01}
END
expectError 2 "optimizewalk: a simulated walk can have effects of drives, links and ground only; command_delay is not one of these; record another program with it" \
  "$bin/optimizewalk" --robot nao_v5 --try --effects "$scratch/late.yaml"
