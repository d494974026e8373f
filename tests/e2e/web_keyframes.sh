# A motion is edited in a browser: sliders, time, undo. An impossible motion is refused. A saved motion is in the file
# with its comments and is played. Unsaved changes survive the page and the agent.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
for program in node chromium; do
  command -v $program > /dev/null || fail "no $program: scripts/install_packages.sh scripts/packages-test.txt installs it"
done
node --test tests/e2e/web/{keyframes,trial}.test.mjs > "$scratch/parts.log" 2>&1 || fail "$(tail -30 "$scratch/parts.log")"
scripts/build_page.sh || fail "the page could not be built"
mkdir -p build/e2e
cp -r config "$scratch/config"

"$bin/simulator" --port 0 --monitor-port 0 --ports-file "$scratch/ports.json" --seed 1 --realtime > "$scratch/simulator.log" 2>&1 &
waitFor test -s "$scratch/ports.json"
agentPort=$(sed -n 's/.*"agent": \([0-9]*\).*/\1/p' "$scratch/ports.json")
"$bin/agent" --config "$scratch/config" --motion wave --port "$agentPort" --web 0 > "$scratch/agent.out" 2> "$scratch/agent.err" &
agent=$!
waitFor grep -q 'page http' "$scratch/agent.err"
address=$(sed -n 's#.*page \(http://localhost:[0-9]*/\)$#\1#p' "$scratch/agent.err")

timeout 900 node tests/e2e/web/keyframes.mjs "$address" "$scratch/config/motions" build/e2e/keyframes.png ||
  fail "see above; $(tail -2 "$scratch/agent.err")"
kill -INT $agent
wait $agent || fail "agent ended with status $?"
[[ $(find "$scratch/config/motions" -name '*.part') == "" ]] || fail "half a file is left"
