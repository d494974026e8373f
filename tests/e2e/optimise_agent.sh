# An agent with a simulator of its own tries kicks for an optimiser, with a tiny budget: behind TCP, then in the agent itself.
# What it cannot do is said in one line.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
cp -r config "$scratch/config"
echo 'rollSeconds: 2' > "$scratch/config/OptimizeKick.yaml"
agent() { # options of the client
  printf '%s\n' "$@" > "$scratch/config/OptimizationClient.yaml"
  (cd "$scratch" && within 240 "$bin/agent" --config "$scratch/config" --crash-log "$scratch/crash.log" --start-simulator \
    --modules "$scratch/config/platforms/simspark/optimise.cfg" --simulator-option=--sync "${simulator[@]}" 2> agent.err > agent.out)
}
simulator=(--simulator-option=--ground-truth)

cat > "$scratch/study.yaml" << END
task: kick
options: {type: 0}
population: 4
generations: 1
END
serve() { "$bin/optserver" "$scratch/study.yaml" --folder "$scratch/$1" --port 0 > "$scratch/$1.out" 2>&1 & server=$!; waitFor test -s "$scratch/$1/port"; }
serve farmed
agent "port: $(< "$scratch/farmed/port")" || fail "the agent ended with $?: $(< "$scratch/agent.err")"
wait "$server" || fail "the server ended with $?"
grep -q "over (maxGenerations)" "$scratch/farmed.out" || fail "the search did not end: $(tail -3 "$scratch/farmed.out")"
results=$(sed 1d "$scratch/farmed/evaluations.jsonl")
expectEqual "$(wc -l <<< "$results")" 4 "results"
expectEqual "$(grep -c '"distance"' <<< "$results")" 4 "results with the agent's figures"

agent 'host: ""' 'population: 4' 'runs: 1' 'generations: 1' 'found: found.kick.yaml' ||
  fail "the agent ended with $?: $(< "$scratch/agent.err")"
grep -q "^ball: \[" "$scratch/found.kick.yaml" || fail "what was found is no kick"

simulator=()
status=0; agent 'host: ""' || status=$?
expectEqual "$status" 2 "status without ground truth"
grep -q "the simulator sends no ground truth: start it with --ground-truth" "$scratch/agent.err" || fail "not said: $(< "$scratch/agent.err")"
cp "$scratch/study.yaml" "$scratch/plain.yaml"
sed -i 's/^options: {/options: {ceiling: 0.7, /' "$scratch/study.yaml"
serve low
status=0; agent "port: $(< "$scratch/low/port")" || status=$?
expectEqual "$status" 2 "status with an option that an agent cannot try"
grep -q "the server's kick has the option ceiling; an agent cannot try that, bin/optworker can" "$scratch/agent.err" || fail "not said: $(< "$scratch/agent.err")"
sed 's/task: kick/task: standUp/' "$scratch/plain.yaml" > "$scratch/study.yaml"
serve other
status=0; agent "port: $(< "$scratch/other/port")" || status=$?
expectEqual "$status" 2 "status with another task"
grep -q "the server's task is standUp; an agent can try kicks (task kick)" "$scratch/agent.err" || fail "not said: $(< "$scratch/agent.err")"
