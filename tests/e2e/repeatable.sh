# The same seed gives the same run: the ways of robot and ball are the same to the byte.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
for run in a b; do "$bin/game" --seed 8 --limit 20 --output "$scratch/$run" > /dev/null || true; done
"$bin/game" --seed 9 --limit 20 --output "$scratch/other" > /dev/null || true
cmp "$scratch/a/track.svg" "$scratch/b/track.svg" || fail "two runs with one seed differ"
[[ $(wc -c < "$scratch/a/track.svg") -gt 2000 ]] || fail "nothing was recorded"
if cmp -s <(grep polyline "$scratch/a/track.svg") <(grep polyline "$scratch/other/track.svg"); then fail "another seed gives the same run"; fi
