# A distributed search that is killed with -9 and started again, with workers that are killed, has the same result as a
# single worker without interruption. A wrong token, a wrong file and a client that sends nonsense each give an error of
# one line.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
cat > "$scratch/study.yaml" << END
task: function
options: {function: rosenbrock, dimension: 4, sleep: 0.006, spread: 0.3}
population: 8
ahead: 3
runs: 1
runsOfBest: 2
generations: 25
END
"$bin/optserver" "$scratch/study.yaml" --folder "$scratch/alone" --workers 1 --port 0 > "$scratch/alone.out"
grep -q "over (maxGenerations)" "$scratch/alone.out" || fail "the search did not end: $(tail -3 "$scratch/alone.out")"

begin() { "$bin/optserver" "$scratch/study.yaml" --folder "$scratch/farmed" --port "${1-0}" --patience 5 > "$scratch/farmed.out" 2>&1 & server=$!; }
lines() { wc -l < "$scratch/farmed/evaluations.jsonl" 2> /dev/null || echo 0; }
atLeast() { (($(lines) >= $1)); }
begin
waitFor test -s "$scratch/farmed/port"
port=$(< "$scratch/farmed/port")
worker() { "$bin/optworker" --port "$port" --patience 20 2> /dev/null & }
worker; first=$!
worker; second=$!
waitFor atLeast 60
kill -STOP "$first" "$second" # or the search may be over before a slow client has asked for the status
"$bin/optserver" --status --port "$port" | grep -q '"task":"function"' || fail "no status"
echo nonsense > "/dev/tcp/127.0.0.1/$port" || fail "the port does not take a client"
kill -9 "$first"
kill -9 "$server"
wait "$server" 2> /dev/null || true
kill -CONT "$second"
begin "$port"
worker
waitFor grep -q "over (maxGenerations)" "$scratch/farmed.out"
wait "$server" || fail "the server ended with $?"
grep -q "continues from" "$scratch/farmed.out" || fail "it started again from the beginning"
# The heading names the folder's own counts of runs; what is below it is what was found.
cmp <(grep -v '^#' "$scratch/alone/found.yaml") <(grep -v '^#' "$scratch/farmed/found.yaml") ||
  fail "what was found depends on who evaluated when"
expectEqual "$(sed 1d "$scratch/farmed/evaluations.jsonl" | sed 's/.*"trial":\([0-9]*\).*/\1/' | sort | uniq -d | wc -l)" 0 "trials counted twice"

# Workers of the server's own find it at the address that it was given, with a token that no list of processes shows.
mkdir "$scratch/bound"
PLUMBLINE_TOKEN=secret-of-this-test "$bin/optserver" "$scratch/study.yaml" --folder "$scratch/bound" --bind 127.0.0.2 --port 0 --workers 1 \
  > "$scratch/bound.out" 2>&1 & server=$!
waitFor grep -qs "generation.:1" "$scratch/bound/evaluations.jsonl"
worker=$(pgrep -P "$server" -f '[o]ptworker') || fail "the server has no worker"
tr '\0' ' ' < "/proc/$worker/cmdline" | grep -q -- "--host 127.0.0.2 " || fail "the worker has another address"
tr '\0' ' ' < "/proc/$worker/cmdline" | grep -q secret-of-this-test && fail "the worker's arguments show the token"
wait "$server" || fail "the server ended with $?: $(tail -3 "$scratch/bound.out")"
grep -q "over (maxGenerations)" "$scratch/bound.out" || fail "the search did not end: $(tail -3 "$scratch/bound.out")"

expectError 2 "optserver: port 0.0.0.0:0 is open to others: that needs a token" \
  "$bin/optserver" "$scratch/study.yaml" --folder "$scratch/open" --port 0 --bind 0.0.0.0
sed 's/rosenbrock/rosenbroc/' "$scratch/study.yaml" > "$scratch/wrong.yaml"
expectError 2 "optserver: $scratch/wrong.yaml: option function: \"rosenbroc\" is not one of sphere, ellipsoid, rosenbrock, rastrigin" \
  "$bin/optserver" "$scratch/wrong.yaml" --port 0
sed 's/population/popluation/' "$scratch/study.yaml" > "$scratch/wrong.yaml"
expectError 2 "optserver: $scratch/wrong.yaml:3: unknown key \"popluation\"; did you mean \"population\"?" \
  "$bin/optserver" "$scratch/wrong.yaml" --port 0
sed 's/ahead: 3/ahead: 2/' "$scratch/study.yaml" > "$scratch/other.yaml"
expectError 2 "optserver: $scratch/farmed/evaluations.jsonl:1: the results of another search (its options, task or program differ); take another folder or remove this one" \
  "$bin/optserver" "$scratch/other.yaml" --folder "$scratch/farmed" --port 0
# Options and seed of the command line are in place of the study's, in a folder of their own.
(cd "$scratch" && "$bin/optserver" study.yaml --option dimension=3 --seed 7 --workers 1 --port 0 > changed.out)
changed=$scratch/study-dimension3-seed7.search
expectEqual "$(grep -c '^x' "$changed/found.yaml")" 3 "parameters of the changed study"
grep -q "^# Found by bin/optserver study.yaml --option dimension=3 --seed 7: " "$changed/found.yaml" || fail "the file does not say how it was found"
expectError 2 'optserver: --option: "dimension" is not KEY=VALUE; see optserver --help' "$bin/optserver" "$scratch/study.yaml" --option dimension --port 0
