# bin/agent --decisions: a folder that cannot be is an error at the start. On a full disk (here: files that may not grow) the
# player plays on to its end, says once that the file ends early, and ends with status 2; the file holds whole lines.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
# Modules that evaluate where modules.cfg names them write as well; the last one as the agent ends.
cp -r config "$scratch/config"
printf 'Parser GroundTruth\nOthersEvaluation\nLocalizationEvaluation\n' >> "$scratch/config/platforms/simspark/modules.cfg"
echo "folder: $scratch/believed" > "$scratch/config/OthersEvaluation.yaml"
echo "file: $scratch/errors/report.json" > "$scratch/config/LocalizationEvaluation.yaml"
"$bin/game" --seed 8 --limit 12 --output "$scratch/game" --simulator-option=--ground-truth --agent-option=--config \
  --agent-option="$scratch/config" --agent-option=--log --agent-option="$scratch/log" --agent-option=--log-wait > /dev/null || true
agent=("$bin/agent" --replay "$scratch/log" --crash-log "$scratch/crash.log")
file=left-1.csv

within 120 "${agent[@]}" --decisions "$scratch/good" || fail "decisions of a replay: status $?"
(($(wc -l < "$scratch/good/$file") > 10)) || fail "few decisions: $(cat "$scratch/good/$file")"

touch "$scratch/taken"
mkdir -p "$scratch/blocked/right-11.csv"
todo="choose another folder"
expectError 2 "agent: --decisions: /proc/nope: cannot be written: No such file or directory; $todo" "${agent[@]}" --decisions /proc/nope
expectError 2 "agent: --decisions: $scratch/taken: cannot be written: Not a directory; $todo" "${agent[@]}" --decisions "$scratch/taken"
expectError 2 "agent: --decisions: $scratch/blocked/right-11.csv: cannot be written: Is a directory; $todo" \
  "${agent[@]}" --decisions "$scratch/blocked"

full=(bash -c 'trap "" XFSZ; ulimit -f "$0"; exec "$@"')
expectError 2 "agent: the decisions end here: $scratch/full/$file: cannot be written: File too large; make room, or $todo" \
  "${full[@]}" 1 "${agent[@]}" --decisions "$scratch/full"
lines=$(wc -l < "$scratch/full/$file")
((lines > 2)) || fail "$lines lines before the disk was full"
cmp "$scratch/full/$file" <(head -"$lines" "$scratch/good/$file") || fail "not the first lines of what is written on an empty disk"

# The same of the other modules: at the start, on the way, at the end.
evaluating=("${agent[@]}" --config "$scratch/config")
within 120 "${evaluating[@]}" || fail "evaluation of a replay: status $?"
[[ -s $scratch/believed/$file && -s $scratch/errors/report.json ]] || fail "no evaluation: $(ls "$scratch/believed" "$scratch/errors")"
rm -r "$scratch/believed" "$scratch/errors"
touch "$scratch/errors"
expectError 2 "agent: $scratch/config/LocalizationEvaluation.yaml:1: file $scratch/errors/report.json: cannot be written: Not a directory; choose another file" \
  "${evaluating[@]}"
rm "$scratch/errors"
status=0
said=$(within 120 "${full[@]}" 0 "${evaluating[@]}" 2>&1 > /dev/null) || status=$?
expectEqual "$status" 2 "status of an agent whose evaluation cannot be written"
grep -qx "agent: the estimates end here: $scratch/believed/$file: cannot be written: File too large; make room, or $todo" <<< "$said" ||
  fail "of the estimates: $said"
grep -qx "agent: LocalizationEvaluation: cannot write $scratch/errors/report.json: File too large; make room, or choose another file" <<< "$said" ||
  fail "of the localization: $said"
[[ ! $(ls -A "$scratch/believed" "$scratch/errors" | grep -v :) ]] || fail "left over: $(ls -A "$scratch/believed" "$scratch/errors")"
