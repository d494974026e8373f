# scripts/optimise_sprint.sh: both stages in small, the second from what the first found, and then the choice; the same command again
# searches nothing. The choice takes half a minute, so a script that copies is called in its place.
source "$(dirname "$0")/assert.bash"
mkdir -p "$scratch/bin"
ln -s "$(realpath "$bin")/optserver" "$scratch/bin/optserver"
cat > "$scratch/bin/optimizewalk" << 'SCRIPT'
#!/bin/bash
while (($#)); do case $1 in --from) from=$2 ;; --output) output=$2 ;; esac; shift; done
cp "$from/walking.yaml" "$output"
SCRIPT
chmod +x "$scratch/bin/optimizewalk"
search() { EFFORT=0.001 WORKERS=1 FOLDER=$scratch/sprint BIN=$scratch/bin scripts/optimise_sprint.sh "$@" > "$scratch/log" 2>&1 || fail "$(tail -3 "$scratch/log")"; }
search 2 turn
for stage in 1 2; do [[ -s $scratch/sprint/stage$stage/search/walk.yaml ]] || fail "no stage $stage: $(tail -3 "$scratch/log")"; done
cmp "$scratch/sprint/stage1/search/walk.yaml" "$scratch/sprint/stage2/config/robots/simspark_type2/walking.yaml" || fail "the second stage begins elsewhere"
cmp "$scratch/sprint/stage2/search/walk.yaml" "$scratch/sprint/walking.yaml" || fail "the choice was of something else"
search 2 turn
! grep -q "optserver: port" "$scratch/log" || fail "it searched again"
expectError 2 "optimise_sprint.sh: no robot type '7'; see optimise_sprint.sh --help" scripts/optimise_sprint.sh 7
expectError 2 "optimise_sprint.sh: no direction 'up'; there are forward, backward, sideways, turn; see optimise_sprint.sh --help" scripts/optimise_sprint.sh 2 up
