# A game ends by a signal within a second, also if its agent hangs, and then a file says where the agent was. If its simulator
# hangs as well, that takes no longer. A game that is killed takes its agent along, which leaves no file.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
begin() { # leaves `game` and `agent`
  rm -rf "$scratch/out" "$scratch/said"
  "$bin/game" --realtime --limit 600 --output "$scratch/out" --agent-option=--crash-log --agent-option="$scratch/crash.log" \
    > "$scratch/said" 2> "$scratch/err" &
  game=$!
  waitFor grep -q robot "$scratch/said"
  agent=$(pgrep -P $game -x agent) || fail "no agent: $(cat "$scratch/err")"
}
stopped() { # leaves `status` and `took` [us]
  local before=${EPOCHREALTIME/./}
  kill -TERM $game
  status=0
  wait $game || status=$?
  took=$((${EPOCHREALTIME/./} - before))
}
noChild() { ! pgrep -P $game > /dev/null; }

areStopped() { local pid; for pid in "$@"; do grep -q '^State:[[:space:]]*T' "/proc/$pid/status" || return; done; }

begin
kill -STOP "$agent"
waitFor areStopped "$agent"
stopped
expectEqual $status 130 "status of a game whose agent hangs"
expectEqual "$(cat "$scratch/err")" "game: the agent did not end and was killed; its crash log says where it was
game: interrupted" "what it says"
# A second, twice that beside other tests, more on a busy machine.
limit=$(awk -v cores="$(nproc)" '{ print int(1e6 * ($1 > 2 * cores ? $1 / cores : 2)) }' /proc/loadavg)
((took < limit)) || fail "the game took $took us to its end"
noChild || fail "a child outlives it"
waitFor test -s "$scratch/crash.log"
grep -q '^Process [0-9]* was killed by a signal that it cannot catch (SIGKILL), ' "$scratch/crash.log" || fail "crash.log: $(head -2 "$scratch/crash.log")"
rm "$scratch/crash.log"
[[ -s $scratch/out/summary.json ]] || fail "no summary of what was played"

begin
simulator=$(pgrep -P $game -x simulator) || fail "no simulator: $(cat "$scratch/err")"
kill -STOP "$agent" "$simulator"
waitFor areStopped "$agent" "$simulator"
one=$took
stopped
expectEqual $status 130 "status of a game whose agent and simulator hang"
((took < one + limit / 4)) || fail "the game took $took us to its end with two that hang, and $one us with one"
noChild || fail "a child outlives it"
waitFor test -s "$scratch/crash.log"
rm "$scratch/crash.log"

begin
writer=$(pgrep -P "$agent" -x crashlog) || fail "no second process of the agent"
kill -KILL $game
{ wait $game; } 2> /dev/null || true
gone() { ! kill -0 "$1" 2> /dev/null; }
waitFor gone "$agent"
waitFor gone "$writer"
[[ ! -e $scratch/crash.log ]] || fail "an agent that was taken along leaves a file: $(head -2 "$scratch/crash.log")"
