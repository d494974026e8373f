# The page in a browser, with 22 robots: all are shown, the trainer's buttons work, dragging beams a robot, drawings
# appear, and the recorded match can be looked at again.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
for program in node chromium; do
  command -v $program > /dev/null || fail "no $program: scripts/install_packages.sh scripts/packages-test.txt installs it"
done
scripts/build_page.sh || fail "the page could not be built"
mkdir -p build/e2e

# Waits for a line in a log and prints what stands in place of the number.
address() { sed -n 's#.*\(http://localhost:[0-9]*/\).*#\1#p' "$1"; }

"$bin/simulator" --web 0 --port 0 --monitor-port 0 --ports-file "$scratch/ports.json" --record "$scratch/match.plm" \
  --seed 1 > "$scratch/simulator.log" 2>&1 &
simulator=$!
waitFor test -s "$scratch/ports.json"
head -1 "$scratch/simulator.log" | grep -q '^simulator: watch at http://localhost:[0-9]*/$' ||
  fail "the address is not the first line: $(head -1 "$scratch/simulator.log")"

# A second monitor takes part of the same game, as on any server, and takes the drawings.
read -r agentPort monitorPort _ < <(tr -cs '0-9\n' ' ' < "$scratch/ports.json")
"$bin/webmonitor" --port "$monitorPort" --web-port 0 --drawing-port 0 > "$scratch/webmonitor.log" 2>&1 &
monitor=$!
waitFor grep -q 'drawings on UDP port' "$scratch/webmonitor.log"
drawingPort=$(sed -n 's/.*UDP port //p' "$scratch/webmonitor.log")

timeout 900 node tests/e2e/web/match.mjs "$(address "$scratch/simulator.log")" "$(address "$scratch/webmonitor.log")" \
  "$agentPort" "$monitorPort" "$drawingPort" "$simulator" build/e2e/web.png || fail "see above; $(tail -1 "$scratch/simulator.log")"
kill -TERM $monitor
wait $monitor || fail "webmonitor ended with status $?"
wait $simulator || fail "simulator ended with status $?"

[[ -s $scratch/match.plm ]] || fail "nothing is recorded"
"$bin/webmonitor" --replay "$scratch/match.plm" --web-port 0 > "$scratch/replay.log" 2>&1 &
monitor=$!
waitFor grep -q 'webmonitor: http' "$scratch/replay.log"
timeout 900 node tests/e2e/web/replay.mjs "$(address "$scratch/replay.log")" || fail "the replay; see above"
kill -TERM $monitor
wait $monitor || fail "webmonitor ended with status $?"
