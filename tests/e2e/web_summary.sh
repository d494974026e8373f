# The summary of a recorded game: counted right, one page that needs nothing else, in Chromium.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
for program in node chromium; do
  command -v $program > /dev/null || fail "no $program: scripts/install_packages.sh scripts/packages-test.txt installs it"
done
node --test tests/e2e/web/summary.test.mjs > "$scratch/parts.log" 2>&1 || fail "$(tail -30 "$scratch/parts.log")"
scripts/build_page.sh || fail "the page could not be built"
mkdir -p build/e2e
expectError 2 "webmonitor: $scratch/none.plm: cannot read it" "$bin/webmonitor" --summary "$scratch/none.plm"

within 120 scripts/match.sh --left 2 --right 2 --seconds 40 --page 0 --seed 3 --record "$scratch/match.plm" > "$scratch/out" 2> "$scratch/err" ||
  fail "a short match: status $?, $(cat "$scratch/err")"
mkdir "$scratch/alone"
"$bin/webmonitor" --summary "$scratch/match.plm" -o "$scratch/alone/match.html" | grep -qx "webmonitor: $scratch/alone/match.html" || fail "it does not say where the page is"
! grep -qE '<(script|link)[^>]* (src|href)="[^d]' "$scratch/alone/match.html" || fail "the page needs other files"

"$bin/webmonitor" --replay "$scratch/match.plm" --web-port 0 > "$scratch/replay.log" 2>&1 &
monitor=$!
waitFor grep -q 'webmonitor: http' "$scratch/replay.log"
timeout 900 node tests/e2e/web/summary.mjs "file://$scratch/alone/match.html" "$(sed -n 's#.*\(http://localhost:[0-9]*/\).*#\1#p' "$scratch/replay.log")" build/e2e/summary.png ||
  fail "see above"
kill -TERM $monitor
wait $monitor || fail "webmonitor ended with status $?"
