# An agent with a simulator of its own tries kicks for an optimiser, with a tiny budget: behind TCP, then in the agent itself.
# What it cannot do is said in one line.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
cp -r config "$scratch/config"
echo 'rollSeconds: 2' > "$scratch/config/OptimizeMotion.yaml"
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
serve() { "$bin/optserver" "$scratch/${2-study}.yaml" --folder "$scratch/$1" --port 0 > "$scratch/$1.out" 2>&1 & server=$!; waitFor test -s "$scratch/$1/port"; }
serve farmed
agent "port: $(< "$scratch/farmed/port")" || fail "the agent ended with $?: $(< "$scratch/agent.err")"
wait "$server" || fail "the server ended with $?"
grep -q "over (maxGenerations)" "$scratch/farmed.out" || fail "the search did not end: $(tail -3 "$scratch/farmed.out")"
results=$(sed 1d "$scratch/farmed/evaluations.jsonl")
expectEqual "$(wc -l <<< "$results")" 4 "results"
expectEqual "$(grep -c '"distance"' <<< "$results")" 4 "results with the agent's figures"

# A kick that differs from the usual in all that a study may ask of it. An agent and a worker judge it by the same formula with
# these options, and play the same motions for as long.
cat > "$scratch/asked.yaml" << END
task: kick
options: {type: 0, motion: kickShot, direction: 30, walk: 0.8, steady: 3, weight: 0.03, spread: 0.015, still: 0.5, ceiling: 0.7}
population: 4
generations: 1
END
serve byAgent asked
agent "port: $(< "$scratch/byAgent/port")" || fail "the agent ended with $?: $(< "$scratch/agent.err")"
wait "$server" || fail "the server ended with $?"
"$bin/optserver" "$scratch/asked.yaml" --folder "$scratch/byWorker" --port 0 --workers 1 > "$scratch/byWorker.out" || fail "the server ended with $?"
figure() { sed -n "s/.*\"$1\":\[*\([-0-9.e+]*\).*/\1/p" <<< "$line"; }
judged() { # a line for each trial: its number, the motion's time, and whether the cost is that of its figures
  sed 1d "$scratch/$1/evaluations.jsonl" | while IFS= read -r line; do
    awk -v trial="$(figure trial)" -v cost="$(figure costs)" -v along="$(figure distance)" -v off="$(figure off)" \
      -v error="$(figure error)" -v time="$(figure time)" -v top="$(figure top)" 'BEGIN {
        off *= atan2(0, -1) / 180
        aside = along * sin(off) / cos(off)
        wanted = -30 * (along - (aside < 0 ? -aside : aside)) + 3 * error + 0.03 * time + (top > 0.7 ? 60 + 300 * (top - 0.7) : 0)
        difference = cost - wanted
        print trial, time, (difference < 0.01 && difference > -0.01 ? "agrees" : cost " is not " wanted) }'
  done | sort -n
}
expectEqual "$(judged byWorker | grep -c ' agrees$')" 4 "costs of the worker that are those of the figures"
expectEqual "$(judged byAgent)" "$(judged byWorker)" "what the agent judged and how"

# A server that is killed and started again is waited for. Ctrl-C ends an agent that waits for one that does not come.
begin() { # options of the client; none: the same again. An agent in the background
  (($# == 0)) || printf '%s\n' "$@" > "$scratch/config/OptimizationClient.yaml"
  (cd "$scratch" && exec "$bin/agent" --config "$scratch/config" --crash-log "$scratch/crash.log" --start-simulator \
    --modules "$scratch/config/platforms/simspark/optimise.cfg" --simulator-option=--sync "${simulator[@]}" 2> agent.err > agent.out) & agent=$!
}
sed 's/^generations: 1/generations: 4/' "$scratch/study.yaml" > "$scratch/longer.yaml"
serve again longer
port=$(< "$scratch/again/port")
begin "port: $port"
someResults() { (($(wc -l < "$scratch/again/evaluations.jsonl") >= 4)); }
waitFor someResults
kill -9 "$server"
wait "$server" 2> /dev/null || true
sleep 1
kill -0 "$agent" 2> /dev/null || fail "the agent ended with its server: $(< "$scratch/agent.err")"
"$bin/optserver" "$scratch/longer.yaml" --folder "$scratch/again" --port "$port" > "$scratch/again.out" 2>&1 & server=$!
wait "$agent" || fail "the agent ended with $?: $(< "$scratch/agent.err")"
wait "$server" || fail "the server ended with $?"
grep -q "continues from" "$scratch/again.out" || fail "it started again from the beginning"
grep -q "over (maxGenerations)" "$scratch/again.out" || fail "the search did not end: $(tail -3 "$scratch/again.out")"
begin "port: $port" 'patience: 600'
sleep 2
kill -0 "$agent" 2> /dev/null || fail "the agent does not wait: $(< "$scratch/agent.err")"
asked=$(date +%s%N)
kill -INT "$agent"
wait "$agent" || fail "the agent ended with $? by Ctrl-C"
(($(date +%s%N) - asked < 2000000000)) || fail "Ctrl-C took longer than two seconds"

agent 'host: ""' 'population: 4' 'runs: 1' 'generations: 1' 'found: found.kick.yaml' ||
  fail "the agent ended with $?: $(< "$scratch/agent.err")"
grep -q "^ball: \[" "$scratch/found.kick.yaml" || fail "what was found is no kick"

simulator=()
status=0; agent 'host: ""' || status=$?
expectEqual "$status" 2 "status without ground truth"
grep -q "the simulator sends no ground truth: start it with --ground-truth" "$scratch/agent.err" || fail "not said: $(< "$scratch/agent.err")"
cp "$scratch/study.yaml" "$scratch/plain.yaml"
sed -i 's/^options: {/options: {engine: bullet, /' "$scratch/study.yaml"
serve low
status=0; agent "port: $(< "$scratch/low/port")" || status=$?
expectEqual "$status" 2 "status with an option that an agent does not heed"
grep -q "the server's task kick has the option engine; an agent cannot try that, bin/optworker can" "$scratch/agent.err" || fail "not said: $(< "$scratch/agent.err")"
sed 's/task: kick/task: dive/' "$scratch/plain.yaml" > "$scratch/study.yaml"
serve other
status=0; agent "port: $(< "$scratch/other/port")" || status=$?
expectEqual "$status" 2 "status with another task"
grep -q "the server's task is dive; an agent can try the tasks kick and standUp" "$scratch/agent.err" || fail "not said: $(< "$scratch/agent.err")"

# Two agents, each with a simulator of its own, stand up for one server. The tries are judged as a worker judges them.
cat > "$scratch/study.yaml" << END
task: standUp
options: {type: 0, direction: back, motion: standUpBackFast, weight: 0.03, still: 0.3}
population: 8
sigma: 0.0001
sameSeeds: false
generations: 3
END
simulator=(--simulator-option=--ground-truth)
serve standing
begin "port: $(< "$scratch/standing/port")"
first=$agent
begin
wait "$first" || fail "the first agent ended with $?: $(< "$scratch/agent.err")"
wait "$agent" || fail "the second agent ended with $?: $(< "$scratch/agent.err")"
wait "$server" || fail "the server ended with $?"
results=$(sed 1d "$scratch/standing/evaluations.jsonl")
expectEqual "$(wc -l <<< "$results")" 24 "results of standing up"
expectEqual "$(grep -o '"worker":"agent-[0-9]*' <<< "$results" | sort -u | wc -l)" 2 "agents that brought results"
while IFS= read -r line; do
  awk -v cost="$(figure costs)" -v error="$(figure error)" -v time="$(figure time)" 'BEGIN {
    difference = cost - error - 0.03 * time
    exit !(difference < 0.01 && difference > -0.01) }' || fail "not the cost of its figures: $line"
done <<< "$results"
(($(grep -c '"up":1' <<< "$results") >= 12)) || fail "a good motion brings fewer than half of the robots onto their feet"
