# The agent survives the death of the simulator that it has started: it starts another and plays on; Ctrl-C ends
# both and leaves nothing behind.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
export TMPDIR=$scratch
"$bin/agent" --start-simulator --simulator-option=--sync --simulator-option=--kickoff-after=1 --status \
  --stats "$scratch/stats.json" > "$scratch/out" 2>&1 &
agent=$!
statusLines() { (($(grep -c ^status "$scratch/out") > $1)); }
waitFor statusLines 5
simulator=$(pgrep -P $agent -x simulator) || fail "the agent has no simulator: $(tail -1 "$scratch/out")"
kill -9 "$simulator"
before=$(grep -c ^status "$scratch/out")
waitFor statusLines $((before + 5))
second=$(pgrep -P $agent -x simulator) || fail "no second simulator"
[[ $second != "$simulator" ]] || fail "the simulator is the one that was killed"
kill -INT $agent
wait $agent || fail "status $? after Ctrl-C"
if kill -0 "$second" 2> /dev/null; then fail "the simulator outlived its agent"; fi
[[ -s $scratch/stats.json ]] || fail "no statistics"
rm -f "$scratch/stats.json" "$scratch/out"

# A simulator that ends as it was asked to ends the agent, too.
"$bin/agent" --start-simulator --simulator-option=--sync --simulator-option=--max-seconds=3 2> "$scratch/out" ||
  fail "status $? when the simulator had ended: $(tail -1 "$scratch/out")"
grep -q 'the simulator has ended$' "$scratch/out" || fail "what the agent says: $(tail -1 "$scratch/out")"
rm -f "$scratch/out"
expectEqual "$(ls -A "$scratch")" "" "left behind"
