# The same seed gives the same run: the ways of robot and ball and what is printed are the same to the byte.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
for run in a b; do
  "$bin/game" --seed 8 --limit 20 --output "$scratch/run" > "$scratch/$run.out" || true
  cp -r "$scratch/run" "$scratch/$run"
done
cmp "$scratch/a.out" "$scratch/b.out" || fail "two runs with one seed print different tables"
(($(wc -l < "$scratch/a.out") > 15)) || fail "nothing was printed"
"$bin/game" --seed 9 --limit 20 --output "$scratch/other" > /dev/null || true
# In real time as well: who is late does not change the run.
"$bin/game" --seed 8 --limit 8 --realtime --output "$scratch/run" > "$scratch/slow.out" || true
diff <(head -5 "$scratch/a.out") <(head -5 "$scratch/slow.out") || fail "a run in real time is another one"
cmp "$scratch/a/track.svg" "$scratch/b/track.svg" || fail "two runs with one seed differ"
[[ $(wc -c < "$scratch/a/track.svg") -gt 2000 ]] || fail "nothing was recorded"
if cmp -s <(grep polyline "$scratch/a/track.svg") <(grep polyline "$scratch/other/track.svg"); then fail "another seed gives the same run"; fi
