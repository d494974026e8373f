# bin/situations: a situation is taken from an agent's log, is drawn, and is on the page of a folder. A log, time or file that
# cannot be is an error of one line, and no file is left.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
"$bin/game" --seed 8 --limit 10 --output "$scratch/out" --agent-option=--log --agent-option="$scratch/game" --agent-option=--log-wait > /dev/null || true
cd "$scratch"
mkdir -p folder/striker
taken=folder/striker/here.yaml
situations() { within 120 "$bin/situations" "$@" > said 2>&1 || fail "situations $*: $(cat said)"; }

# What the player believed at that time: its place is the log's.
situations take game --time 8 --decides striker -o $taken
"$bin/logtool" export game --csv places.csv --only RobotPose.position > /dev/null
place=$(awk -F, '$1 <= 8 { x = $3; y = $4 } END { printf "%.1f %.1f", x, y }' places.csv)
expectEqual "$(sed -n 's/^robot: \[\([-0-9.]*\), \([-0-9.]*\),.*/\1 \2/p' $taken | xargs printf '%.1f %.1f')" "$place" "the player's place"
grep -q '^decides: striker$' $taken || fail "another decider: $(cat $taken)"
grep -q 'at 8.00 s of the log game' $taken || fail "does not say where it is from: $(cat $taken)"
for decider in goalie formation supporter block setPiece passCall; do situations take game --time 8 --decides $decider -o $decider.yaml; done

situations draw $taken
[[ $(head -c 4 here.svg) == '<svg' && $(tail -1 here.svg) == '</svg>' ]] || fail "no picture: $(head -c 100 here.svg)"
situations page folder --pictures pictures -o page.md
grep -q '](pictures/striker-here.svg)' page.md || fail "the page does not show it: $(cat page.md)"
[[ -s pictures/striker-here.svg ]] || fail "no picture for the page"

echo old > kept.yaml
take=("$bin/situations" take game -o kept.yaml --decides striker)
expectError 2 "situations: game: its times are $(awk -F, 'NR == 2 { a = $1 } { b = $1 } END { print a " to " b }' places.csv) s, not 99" "${take[@]}" --time 99
expectError 2 "situations: --time is required; see situations take --help" "${take[@]}"
expectError 2 "situations: game has no thread moon; it has default" "${take[@]}" --time 8 --thread moon
expectError 2 "situations: none: there is no such log" "$bin/situations" take none --time 8 --decides striker -o kept.yaml
expectError 2 "situations: cannot write none/here.yaml: No such file or directory" "$bin/situations" take game --time 8 --decides striker -o none/here.yaml
expectError 2 "situations: cannot write kept.yaml: File too large" bash -c 'trap "" XFSZ; ulimit -f 0; exec "$@"' full "${take[@]}" --time 8
expectEqual "$(cat kept.yaml)" old "a file that could not be written anew"
sed 's/^robot/robto/' $taken > wrong.yaml
expectError 2 'situations: wrong.yaml:1: missing key "robot"; is it "robto" in line 4?' "$bin/situations" draw wrong.yaml
[[ ! -e wrong.svg && ! $(find . -name '*.part') ]] || fail "files are left: $(find . -name '*.part' -o -name wrong.svg)"
