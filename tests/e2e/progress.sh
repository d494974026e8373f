# Long work without a terminal says at least every ten seconds how far it is, so that nobody takes it for hung.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
seconds=12
"$bin/gap" record --robot so101 --program hang_sweep --secret 2 -o "$scratch/runs" > /dev/null
# On a busy machine who prints is late, as is who reads.
longest=$(awk -v cores="$(nproc)" '{ print int(1e6 * (10 + ($1 > cores ? $1 / cores : 1))) }' /proc/loadavg)

begin() { # name, command...: notes when each line comes
  local name=$1
  shift
  {
    echo ${EPOCHREALTIME/./}
    (echo $BASHPID > "$scratch/$name.pid"; exec nice "$@" 2>&1 < /dev/null) | while IFS= read -r line; do echo "${EPOCHREALTIME/./} $line"; done
    echo ${EPOCHREALTIME/./}
  } > "$scratch/$name.lines" &
}
begin diagnose "$bin/gap" diagnose "$scratch/runs" --jobs 1 --json "$scratch/answer.json"
begin blind "$bin/gap" blind make --robot xl330_pendulum --engine replay --cases 1000 --jobs 1 --seed 4 -o "$scratch/set"
begin walk "$bin/optimizewalk" --type 0 --generations 1000 --jobs 1 --output "$scratch/walking.yaml"
sleep $seconds
for name in diagnose blind walk; do kill -INT "$(< "$scratch/$name.pid")" || fail "$name was over after $seconds s: $(cat "$scratch/$name.lines")"; done
wait
for name in diagnose blind walk; do
  grep -qE '^[0-9]+ (gap|optimizewalk): .*[0-9] %' "$scratch/$name.lines" || fail "$name says nothing of its progress: $(cat "$scratch/$name.lines")"
  silence=$(awk 'NR > 1 && $1 - last > most { most = $1 - last } { last = $1 } END { print most }' "$scratch/$name.lines")
  ((silence <= longest)) || fail "$name is silent for $((silence / 1000)) ms: $(cat "$scratch/$name.lines")"
done
