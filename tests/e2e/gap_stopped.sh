# A diagnosis by sets that is ended after each search that it has stored, and gone on with, comes to the same bytes.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
cat > "$scratch/short.yaml" << 'END'
about: "short swings"
base: fixed
posture: hang
lead_in: 0.4
lead_out: 0.2
segments:
  - {wave: triangle, duration: 3, share: 0.45}
END
printf 'effects:\n  - {effect: coulomb_friction, at: pendulum, value: 0.02}\n' > "$scratch/friction.yaml"
gap record --robot xl330_pendulum --program "$scratch/short.yaml" --effects "$scratch/friction.yaml" --seed 2 -o "$scratch/run"
# Four stretches of the one recording serve as groups: five searches.
diagnosis=("$bin/gap" diagnose "$scratch/run" --jobs 1 --max-causes 2)
memory=$scratch/ended.json.searches
within 240 "${diagnosis[@]}" --json "$scratch/whole.json" > "$scratch/whole.txt" 2> "$scratch/err" || fail "diagnose: $(cat "$scratch/err")"
[[ ! -e $scratch/whole.json.searches ]] || fail "the diagnosis left its memory behind"

# How many parts are stored: each has a count of its replays.
stored() { { grep -o '"replays":' "$memory" 2> /dev/null || true; } | wc -l; }
hasStored() { (($(stored) >= $1)) || ! kill -0 "$pid"; } # parts
ended=0 status=1
for signal in KILL TERM INT KILL KILL KILL KILL KILL; do
  before=$(stored)
  "${diagnosis[@]}" --json "$scratch/ended.json" > "$scratch/out" 2> "$scratch/err" &
  pid=$!
  waitFor hasStored $((before + 1))
  kill -s $signal $pid 2> /dev/null || true
  status=0
  wait $pid 2> /dev/null || status=$?
  ((before == 0)) || grep -q "^gap: continues from $memory ($before search[^)]* done)$" "$scratch/err" ||
    [[ $before -gt 5 ]] || fail "nothing is said of the $before that are stored: $(cat "$scratch/err")"
  if ((status == 0)); then break; fi
  ended=$((ended + 1))
  if [[ $signal == KILL ]]; then
    expectEqual $status 137 "the status of a diagnosis that was killed"
  else
    expectEqual $status 130 "the status of a diagnosis that was stopped"
    expectEqual "$(tail -1 "$scratch/err")" "gap: stopped; the same command continues from $memory" "what a stopped diagnosis says"
  fi
done
((ended >= 4)) || fail "it was ended $ended times only"
((status == 0)) ||
  within 240 "${diagnosis[@]}" --json "$scratch/ended.json" > "$scratch/out" 2> "$scratch/err" || fail "the last time: $(cat "$scratch/err")"
cmp "$scratch/whole.json" "$scratch/ended.json" || fail "ended $ended times, it comes to another answer"
cmp "$scratch/whole.txt" "$scratch/out" || fail "ended $ended times, it prints another answer"
[[ ! -e $memory ]] || fail "the diagnosis left its memory behind"

# A memory of other recordings, or one that is damaged, is replaced; one that cannot be written costs no answer.
again() { # line that is said
  gap diagnose "$scratch/run" --max-causes 2 --json "$scratch/ended.json"
  grep -qF "$1" "$scratch/err" || fail "expected '$1', got: $(cat "$scratch/err")"
  cmp "$scratch/whole.json" "$scratch/ended.json" || fail "where it says '$1' it comes to another answer"
}
echo '{"mark": "other", "sum": "", "content": {}}' > "$memory"
again "gap: $memory: is of other recordings, other options or another version of the program; the diagnosis begins anew"
echo '{"mark": "oth' > "$memory"
again "gap: $memory: is damaged; the diagnosis begins anew"
mkdir "$memory"
again "gap: cannot write $memory: Is a directory; a diagnosis that is stopped from now on repeats what follows"
