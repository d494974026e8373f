# The page of a search: while it runs, when it is over, and of a folder alone; loopback only without a token.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
for program in node chromium; do
  command -v $program > /dev/null || fail "no $program: scripts/install_packages.sh scripts/packages-test.txt installs it"
done
node --test tests/e2e/web/search.test.mjs > "$scratch/parts.log" 2>&1 || fail "$(tail -30 "$scratch/parts.log")"
scripts/build_page.sh || fail "the page could not be built"
mkdir -p build/e2e
cat > "$scratch/study.yaml" << END
task: standUp
options: {type: 0, direction: front}
population: 6
runs: 1
generations: 8
END
expectError 2 'optserver: --web-address 0.0.0.0 opens the page to others: set a --web-token' \
  "$bin/optserver" "$scratch/study.yaml" --folder "$scratch/open" --port 0 --web 0 --web-address 0.0.0.0
expectError 2 "optserver: $scratch/none: has no evaluations.jsonl, so there is nothing to show" \
  "$bin/optserver" "$scratch/study.yaml" --folder "$scratch/none" --web 0 --show
[[ ! -e $scratch/none ]] || fail "to look makes a folder"

address() { sed -n 's#.*page \(http://localhost:[0-9]*/\)$#\1#p' "$1"; }
"$bin/optserver" "$scratch/study.yaml" --folder "$scratch/run" --workers 1 --port 0 --web 0 > "$scratch/server.out" 2>&1 &
server=$!
waitFor grep -q 'page http' "$scratch/server.out"
timeout 900 node tests/e2e/web/search.mjs "$(address "$scratch/server.out")" live build/e2e/search.png || fail "see above; $(tail -3 "$scratch/server.out")"
kill -INT $server
wait $server || fail "optserver ended with status $?"
grep -q 'over (maxGenerations)' "$scratch/server.out" || fail "$(tail -3 "$scratch/server.out")"

cp "$scratch/run/evaluations.jsonl" "$scratch/before.jsonl"
"$bin/optserver" "$scratch/study.yaml" --folder "$scratch/run" --web 0 --show > "$scratch/show.out" 2>&1 &
server=$!
waitFor grep -q 'page http' "$scratch/show.out"
timeout 900 node tests/e2e/web/search.mjs "$(address "$scratch/show.out")" shown build/e2e/search-shown.png || fail "see above; $(tail -3 "$scratch/show.out")"
kill -INT $server
wait $server || fail "optserver --show ended with status $?"
cmp "$scratch/before.jsonl" "$scratch/run/evaluations.jsonl" || fail "to look has changed the results"
