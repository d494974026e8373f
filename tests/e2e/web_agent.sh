# A running agent in a browser: modules, values, parameters, motions and drawings, with the robot that does what the page
# asks; and the same drawings as datagrams for a viewer.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
for program in node chromium; do
  command -v $program > /dev/null || fail "no $program: scripts/install_packages.sh scripts/packages-test.txt installs it"
done
scripts/build_page.sh || fail "the page could not be built"
mkdir -p build/e2e

"$bin/simulator" --port 0 --monitor-port 0 --ports-file "$scratch/ports.json" --seed 1 --realtime > "$scratch/simulator.log" 2>&1 &
waitFor test -s "$scratch/ports.json"
agentPort=$(sed -n 's/.*"agent": \([0-9]*\).*/\1/p' "$scratch/ports.json")
expectError 2 'agent: --web-address 0.0.0.0 opens the page to others: set a --web-token' \
  "$bin/agent" --port "$agentPort" --web 0 --web-address 0.0.0.0

# A port for drawings that nobody has.
drawingPort=$(python3 -c 'import socket; s = socket.socket(socket.AF_INET, socket.SOCK_DGRAM); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])')
"$bin/agent" --port "$agentPort" --web 0 --drawing-port "$drawingPort" > "$scratch/agent.out" 2> "$scratch/agent.err" &
agent=$!
waitFor grep -q 'page http' "$scratch/agent.err"
address=$(sed -n 's#.*page \(http://localhost:[0-9]*/\)$#\1#p' "$scratch/agent.err")
! grep -q 'debug port' "$scratch/agent.err" || fail "a debug port that nobody asked for"

timeout 900 node tests/e2e/web/agent.mjs "$address" "$drawingPort" "$agent" build/e2e/agent.png || fail "see above; $(tail -2 "$scratch/agent.err")"
wait $agent || fail "agent ended with status $?"
