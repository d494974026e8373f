# An agent on a log in a browser: played, stopped, a cycle on and back, to a time by typing and by the slider; values, plots
# and field show that moment.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
for program in node chromium; do
  command -v $program > /dev/null || fail "no $program: scripts/install_packages.sh scripts/packages-test.txt installs it"
done
scripts/build_page.sh || fail "the page could not be built"
mkdir -p build/e2e
"$bin/game" --seed 8 --limit 8 --output "$scratch/out" --agent-option=--log --agent-option="$scratch/log" --agent-option=--log-wait > /dev/null || true
"$bin/agent" --replay "$scratch/log" --web 0 > "$scratch/agent.out" 2> "$scratch/agent.err" &
agent=$!
waitFor grep -q 'page http' "$scratch/agent.err"
address=$(sed -n 's#.*page \(http://localhost:[0-9]*/\)$#\1#p' "$scratch/agent.err")
timeout 900 node tests/e2e/web/log.mjs "$address" build/e2e/log.png || fail "see above; $(tail -2 "$scratch/agent.err")"
kill -INT $agent
wait $agent || true
! grep -qi 'crash\|error' "$scratch/agent.err" || fail "$(cat "$scratch/agent.err")"
