#!/usr/bin/env bash
# One of each is added by files alone. A copy of the tree is built with a folder outside of it, which holds what the pages
# of doc/how-to show, to the letter. They are module, representation, behaviour, skill, motion, effect (of the diagnosis and of the
# league's simulator). Also robot, physics engine, engine for servo robots, optimiser, platform, rule of the referee, kind of
# situation, and a robot that walks. Each has to be there then. ccache serves all that the tree was built from; without it the
# test fails. Without PLUMBLINE_SLOW only the agent is built: module, representation, behaviour, skill, motion and platform.
source "$(dirname "$0")/../e2e/assert.bash"
source tests/build/blocks.bash
if ! command -v ccache > /dev/null || [[ ${CCACHE-yes} == "" ]]; then
  echo "extend.sh: there is no ccache, and without it all of src/ would be compiled once more: install ccache, or do not set CCACHE empty" >&2
  exit 1
fi
unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES V
root=$PWD tree=$scratch/tree ours=$scratch/ours config=$scratch/config
mkdir -p "$tree/bin" "$ours"
cp -r configure.sh Makefile CMakeLists.txt CMakePresets.json cmake scripts src utils config "$tree/"

for page in "${extendedPages[@]}"; do takeBlocks "$page" "$ours"; done
expectEqual "$(cd "$ours" && find . -name '*.cpp' | wc -l)" 12 "sources in the pages"
awk '/^```text$/ { inside = 1; next } /^```$/ { inside = 0 } inside' doc/how-to/add-a-platform.md > "$scratch/still.cfg"
awk '/^```json$/ { inside = 1; next } /^```$/ { inside = 0 } inside' doc/how-to/add-a-robot.md > "$scratch/arm.json"
awk '/^```yaml$/ { inside = 1; next } /^```$/ { inside = 0 } inside' doc/how-to/add-a-kind-of-situation.md > "$scratch/press.yaml"

# A folder that is none of src/ would be left out: it is an error.
mkdir "$ours/modles"
echo 'int lost;' > "$ours/modles/Lost.cpp"
(cd "$tree" && ./configure.sh "-DPLUMBLINE_EXTRA=$ours") > "$scratch/log" 2>&1 && fail "a folder of a wrong name is taken"
tr -s ' \n' ' ' < "$scratch/log" | grep -qF "$ours/modles is no folder of src/" || fail "a folder of a wrong name: $(cat "$scratch/log")"
rm -r "$ours/modles"

(cd "$tree" && ./configure.sh "-DPLUMBLINE_EXTRA=$ours") > "$scratch/log" 2>&1 || fail "configure: $(cat "$scratch/log")"
programs=(agent)
[[ ! ${PLUMBLINE_SLOW-} ]] || programs+=(gap simulator optimizewalk situations)
(cd "$tree" && scripts/build.sh SimRelease "${programs[@]}") > "$scratch/log" 2>&1 || fail "build: $(tail -30 "$scratch/log")"
bin=$tree/bin
cd "$tree"

# Module, representation, behaviour, skill and motion are in the agent's graph once a modules.cfg names them.
mkdir -p "$scratch"/config/{modules,platforms/simspark}
for file in platforms/simspark/modules.cfg $(cd config && echo modules/*.cfg); do
  awk '{ print } /^SimpleHeadMotion/ { print "Bow BowOutput" } /^BeliefCombinator +BallPos/ { print "BallSpeedEstimator BallSpeed" }
    /^SkillMoveToPos/ { print "SkillWave SkillWaveOutput" } /^BeforeKickOff/ { print "Cheer CheerOutput" }' "config/$file" > "$scratch/config/$file"
done
"$bin/agent" --modules "$scratch/config/platforms/simspark/modules.cfg" --graph "$scratch/graph.dot" > "$scratch/log" 2>&1 || fail "agent: $(cat "$scratch/log")"
for name in BallSpeedEstimator BallSpeed Cheer CheerOutput SkillWave SkillWaveOutput Bow BowOutput; do
  grep -qw "$name" "$scratch/graph.dot" || fail "the agent's graph has no $name"
done
"$bin/agent" --parameters > "$scratch/parameters" || fail "agent --parameters"
grep -q 'that a bow takes' "$scratch/parameters" || fail "the motion's parameter is not on the page of parameters"

# The platform runs an agent: a motion is played to its end.
mkdir "$tree/config/platforms/still"
cp "$scratch/still.cfg" "$tree/config/platforms/still/modules.cfg"
within 300 "$bin/agent" --platform still --cycle 0.04 --motion wave --once --stats "$scratch/stats.json" > "$scratch/log" 2>&1 || fail "the platform: $(cat "$scratch/log")"
(($(sed -n 's/.*"cycles": *\([0-9]*\).*/\1/p' "$scratch/stats.json") > 50)) || fail "the platform's agent: $(cat "$scratch/stats.json")"
expectError 2 'agent: --platform stil: unknown platform; did you mean "still"?' "$bin/agent" --platform stil

[[ ${PLUMBLINE_SLOW-} ]] || { echo "left out: effect, robot, engines, optimiser, rule and kind of situation; make check builds their programs, too"; exit 0; }
# The effect is listed, and found in a recording of the robot that has it.
"$bin/gap" effects --robot "$scratch/arm.json" > "$scratch/effects" || fail "gap effects"
grep -q '^gear_ripple .*The gear of {at} cogs' "$scratch/effects" || fail "gap effects: $(cat "$scratch/effects")"
printf 'effects:\n  - {effect: gear_ripple, at: Elbow, value: 2}\n' > "$scratch/ripple.yaml"
"$bin/gap" record --robot "$scratch/arm.json" --program hang_sweep --effects "$scratch/ripple.yaml" -o "$scratch/runs" > "$scratch/log" 2>&1 || fail "record: $(cat "$scratch/log")"
"$bin/gap" diagnose "$scratch/runs" --robot "$scratch/arm.json" --quiet --json "$scratch/answer.json" > "$scratch/log" 2>&1 || fail "diagnose: $(cat "$scratch/log")"
grep -q '"effect": "gear_ripple"' "$scratch/answer.json" || fail "the effect is not found: $(cat "$scratch/answer.json")"
grep -q '"verdict": "effect"' "$scratch/answer.json" || fail "the verdict: $(cat "$scratch/answer.json")"
# In Bullet too, which takes the same torque.
"$bin/gap" record --robot "$scratch/arm.json" --program hang_sweep --engine bullet --effects "$scratch/ripple.yaml" -o "$scratch/bullet" > "$scratch/log" 2>&1 || fail "record in Bullet: $(cat "$scratch/log")"

# A robot with legs is a file in config/robots/; it gets a walk, and walks with it in the engine for servo robots.
robots=$tree/config/robots
sed 's/"name": "nao_v5"/"name": "walker"/; /^  "Head": {/,/}/ s/"mass": [0-9.]*/"mass": 0.5/' "$robots/nao_v5.json" > "$robots/walker.json"
cmp -s "$robots/walker.json" "$robots/nao_v5.json" && fail "the robot is not another one"
within 300 "$bin/optimizewalk" --robot walker --task forward --generations 2 --population 4 --tries 1 --seconds 2 > "$scratch/log" 2>&1 ||
  fail "optimizewalk of a new robot: $(cat "$scratch/log")"
[[ -s $robots/walker/walking.yaml ]] || fail "the robot has no walk"
printf 'about: a second\nbase: free\nlead_in: 1\nwalk: {forward: 0.1, duration: 1}\nlead_out: 1\n' > "$scratch/second.yaml"
expectError 2 'gap: there is no engine bullet-fin; did you mean "bullet-fine"?' \
  "$bin/gap" record --robot walker --program "$scratch/second.yaml" --engine bullet-fin -o "$scratch/walk"
for engine in bullet bullet-fine; do
  within 300 "$bin/gap" record --robot walker --program "$scratch/second.yaml" --engine $engine -o "$scratch/walk-$engine" > "$scratch/log" 2>&1 ||
    fail "a walk in $engine: $(cat "$scratch/log")"
done
cmp -s "$scratch"/walk-{bullet,bullet-fine}/run.csv.gz && fail "the engine's own steps do not show"

# The engine steps a world; the optimiser searches a walk.
expectError 2 'simulator: unknown physics engine "foo"; there are: ode, ode-dense, bullet, ode-soft' "$bin/simulator" --engine foo
within 60 "$bin/simulator" --engine ode-soft --no-realtime --wait-agents 0 --max-seconds 1 --port 0 --monitor-port 0 > "$scratch/log" 2>&1 < /dev/null || fail "simulator: $(cat "$scratch/log")"
# The league's effect acts on its robots, and what there is names it.
printf 'effects:\n  - {effect: gyro_gain, at: imu, value: 1.5}\n' > "$scratch/gyro.yaml"
within 60 "$bin/simulator" --effects "$scratch/gyro.yaml" --no-realtime --wait-agents 0 --max-seconds 1 --port 0 --monitor-port 0 > "$scratch/log" 2>&1 < /dev/null ||
  fail "the league's effect: $(cat "$scratch/log")"
printf 'effects:\n  - {effect: gyro_gain, at: imu, value: 3}\n' > "$scratch/gyro.yaml"
expectError 2 "simulator: $scratch/gyro.yaml:2: effects[0].value is 3; gyro_gain goes from 0.5 to 2" "$bin/simulator" --effects "$scratch/gyro.yaml"
# The rule has its place, its section in a file of rules, and errors of its own.
"$bin/simulator" --print-rules > "$scratch/rules.yaml" || fail "simulator --print-rules"
grep -A 3 '^ballHolding:$' "$scratch/rules.yaml" | grep -q 'longest: 5  # s; that it may hold the ball' || fail "the rule: $(cat "$scratch/rules.yaml")"
[[ $(grep -nE '^(goals|ballHolding):' "$scratch/rules.yaml" | cut -d: -f2 | tr '\n' ' ') == 'ballHolding goals ' ]] || fail "the rule's place: $(cat "$scratch/rules.yaml")"
printf 'ballHolding: {on: true, longst: 2}\n' > "$scratch/wrong.yaml"
expectError 2 "simulator: $scratch/wrong.yaml:1: unknown key \"ballHolding.longst\"; did you mean \"longest\"?" "$bin/simulator" --rules "$scratch/wrong.yaml"
# The kind of situation has its place and its own keys; it is drawn with what is expected.
"$bin/situations" draw "$scratch/press.yaml" -o "$scratch" > "$scratch/log" 2>&1 || fail "the situation: $(cat "$scratch/log")"
grep -q '>expected: presses</text>' "$scratch/press.svg" || fail "the situation's picture: $(cat "$scratch/press.svg")"
sed 's/^time:/tme:/' "$scratch/press.yaml" > "$scratch/wrong.yaml"
expectError 2 "situations: $scratch/wrong.yaml:1: missing key \"time\"; is it \"tme\" in line 5?" "$bin/situations" draw "$scratch/wrong.yaml" -o "$scratch"
sed 's/^decides: press/decides: pres/' "$scratch/press.yaml" > "$scratch/wrong.yaml"
expectError 2 "situations: $scratch/wrong.yaml:2: decides must be striker, goalie, formation, supporter, press, block, setPiece or passCall, not \"pres\"" \
  "$bin/situations" draw "$scratch/wrong.yaml" -o "$scratch"
"$bin/optimizewalk" --help | tr -s ' \n' ' ' | grep -q 'cmaes, sep-cmaes, xnes, pso, ipop-cmaes, bipop-cmaes, random' || fail "optimizewalk lists: $("$bin/optimizewalk" --help)"
"$bin/optimizewalk" --type 0 --task forward --generations 2 --population 4 --tries 1 --seconds 2 --optimizer random --output "$scratch/walk.yaml" > "$scratch/log" 2>&1 ||
  fail "optimizewalk: $(cat "$scratch/log")"
[[ -s $scratch/walk.yaml ]] || fail "no walk was written"
cd "$root"
