# The summary of a recorded game: counted right, one page that needs nothing else, in Chromium.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
for program in node chromium; do
  command -v $program > /dev/null || fail "no $program: scripts/install_packages.sh scripts/packages-test.txt installs it"
done
node --test tests/e2e/web/summary.test.mjs tests/e2e/web/decisions.test.mjs > "$scratch/parts.log" 2>&1 || fail "$(tail -30 "$scratch/parts.log")"
scripts/build_page.sh || fail "the page could not be built"
mkdir -p build/e2e
expectError 2 "webmonitor: $scratch/none.plm: cannot read it" "$bin/webmonitor" --summary "$scratch/none.plm"

mkdir "$scratch/empty"
expectError 2 "webmonitor: $scratch/empty: no decisions are in it; bin/agent --decisions $scratch/empty writes them" \
  "$bin/webmonitor" --summary "$scratch/none.plm" --decisions "$scratch/empty"
within 120 scripts/match.sh --left 2 --right 2 --seconds 40 --page 0 --seed 3 --record "$scratch/match.plm" --decisions "$scratch/decisions" > "$scratch/out" 2> "$scratch/err" ||
  fail "a short match: status $?, $(cat "$scratch/err")"
mkdir "$scratch/alone"
# What the players wrote: lines of numbers that come one after the other, none too soon.
for file in "$scratch"/decisions/{left,right}-2.csv; do
  awk -F, 'NR == 1 { columns = NF; next }
    NF != columns || $1 !~ /^[0-9.]+$/ || $4 == "" || $7 !~ /^-?[0-9.]+$/ || $8 !~ /^[0-9.]+$/ || (NR > 2 && $1 < before) { print FILENAME ":" NR ": " $0; bad = 1 }
    { before = $1 } END { exit bad || NR < 10 || NR > 400 }' "$file" || fail "decisions: $(wc -l "$file")"
done
expectError 2 "match.sh: $scratch/decisions holds decisions already; see match.sh --help" scripts/match.sh --decisions "$scratch/decisions"
"$bin/webmonitor" --summary "$scratch/match.plm" --decisions "$scratch/decisions" -o "$scratch/alone/match.html" | grep -qx "webmonitor: $scratch/alone/match.html" || fail "it does not say where the page is"
! grep -qE '<(script|link)[^>]* (src|href)="[^d]' "$scratch/alone/match.html" || fail "the page needs other files"

# Without decisions the page has no place for them; files that are broken are an error that says where.
"$bin/webmonitor" --summary "$scratch/match.plm" -o "$scratch/plain.html" > /dev/null
grep -q '"decisions":null' "$scratch/plain.html" || fail "decisions from nowhere"
sed -i '3s/,[^,]*/,1e999/' "$scratch/decisions/left-2.csv"
expectError 2 "webmonitor: $scratch/decisions/left-2.csv:3: \"1e999\" is no number from -1000 to 1000" \
  "$bin/webmonitor" --summary "$scratch/match.plm" --decisions "$scratch/decisions" -o "$scratch/broken.html"
[[ ! -e $scratch/broken.html ]] || fail "a page of broken files"

"$bin/webmonitor" --replay "$scratch/match.plm" --web-port 0 > "$scratch/replay.log" 2>&1 &
monitor=$!
waitFor grep -q 'webmonitor: http' "$scratch/replay.log"
timeout 900 node tests/e2e/web/summary.mjs "file://$scratch/alone/match.html" "$(sed -n 's#.*\(http://localhost:[0-9]*/\).*#\1#p' "$scratch/replay.log")" build/e2e/summary.png ||
  fail "see above"
kill -TERM $monitor
wait $monitor || fail "webmonitor ended with status $?"
