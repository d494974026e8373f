# scripts/optimise_kick.sh: all stages in small, each from what the one before found; the same command again changes nothing.
source "$(dirname "$0")/assert.bash"
search() { EFFORT=0.001 TRIES=2 WORKERS=1 FOLDER=$scratch/kick BIN=$bin "scripts/optimise_kick.sh" "$@" > "$scratch/log" 2>&1 || fail "$(tail -3 "$scratch/log")"; }
search 3
for stage in 1 2 3 4 5; do [[ -s $scratch/kick/stage$stage/search/kick.yaml ]] || fail "no stage $stage: $(tail -3 "$scratch/log")"; done
grep -q '^kick: {distance: ' "$scratch/kick/kick.yaml" || fail "the kick does not say what it does: $(head -8 "$scratch/kick/kick.yaml")"
frames() { grep -c '^  - {time:' "$1"; }
expectEqual "$(frames "$scratch/kick/stage2/config/robots/simspark_type3/motions/kickStage.yaml")" \
  $(($(frames "$scratch/kick/stage1/search/kick.yaml") + 1)) "keyframes at the beginning of the second stage"
cp "$scratch/kick/kick.yaml" "$scratch/before.yaml"
search 3
cmp "$scratch/before.yaml" "$scratch/kick/kick.yaml" || fail "the same command found another kick"
expectError 2 "optimise_kick.sh: no robot type '7'; see optimise_kick.sh --help" scripts/optimise_kick.sh 7
expectError 2 "optimise_kick.sh: no motion 'kickFar' of type 2, and no file of that name; see optimise_kick.sh --help" scripts/optimise_kick.sh 2 kickFar
