#!/usr/bin/env bash
# Kills every writer and server as by kill -9, in the midst of a write, before a rename, or anywhere in its work, at
# places that a seed draws: no file may be half written, what is a recording must be readable up to there, and what goes on
# where it was must come to the same bytes as if nobody had killed it.
#   scripts/kills.sh [--list] [JOB]...     jobs of tests/faults/jobs.bash [all]
# Variables: KILLS, how many in all [200]; SEED, of the places [1]; PLUMBLINE_BIN, where the programs are [bin].
# What was tried stands in build/faults/kills.txt, what broke in build/faults/findings.txt.
# Example: KILLS=1000 scripts/kills.sh
set -uo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
fail() { echo "kills.sh: $*" >&2; exit 2; }
source tests/faults/helpers.bash
source tests/faults/jobs.bash
kills=${KILLS:-200} seed=${SEED:-1}
[[ $kills =~ ^[0-9]+$ && $seed =~ ^[0-9]+$ ]] || fail "KILLS and SEED are whole numbers"
chooseJobs "$@"
begin kills

# Numbers below $1; the same row for the same seed.
state=$seed
drawn=0
below() {
  state=$(((state * 1103515245 + 12345) % 2147483648))
  drawn=$(((state >> 8) % $1))
}

# The place of the next kill among a job's calls: as often within file work as anywhere.
draw() {
  local kind calls kinds=()
  for kind in write sync rename open; do (($(callsOf $kind) > 0)) && kinds+=($kind); done
  below 2
  if ((drawn == 0 || ${#kinds[@]} == 0)); then kind=malloc; else below ${#kinds[@]}; kind=${kinds[drawn]}; fi
  calls=$(callsOf $kind)
  below $((calls > 0 ? calls : 1))
  place=$kind:$((drawn + 1))!
}

printf '%-20s %6s %8s %8s %7s\n' job kills readable resumed broken | tee "$out/kills.txt"
total=0 broken=0 done=0 each=$(((kills + ${#chosen[@]} - 1) / ${#chosen[@]}))
for name in "${chosen[@]}"; do
  prepareJob "$name" || { finding "$name" "" "its preparation failed: $(tail -1 "$scratch/err")"; continue; }
  struck=0 readable=0 resumed=0 before=$broken
  for ((i = 0; i < each; ++i)); do
    draw
    rm -rf "$scratch/work"
    cp -a "$scratch/template" "$scratch/work"
    playJob "$name" "$scratch/work" "$place"
    done=$((done + 1))
    [[ -t 1 ]] && printf '\r%d of %d %s   \r' $done $((each * ${#chosen[@]})) "$name" >&2
    [[ -s $scratch/told ]] || continue # it ended before it came there
    struck=$((struck + 1))
    ((status == 137)) || finding "$name" "$place" "ends with status $status, not by the kill"
    judgeAfterKill "$name" "$place"
  done
  total=$((total + struck))
  printf '%-20s %6s %8s %8s %7s\n' "$name" $struck "$(declare -F "$name"_check > /dev/null && echo $readable || echo -)" \
    "$(declare -F "$name"_resumes > /dev/null && echo $resumed || echo -)" $((broken - before)) | tee -a "$out/kills.txt"
done
echo "$total kills in ${#chosen[@]} jobs (seed $seed), $broken broke something" | tee -a "$out/kills.txt"
((broken == 0 && total > 0)) || { cat "$out/findings.txt" >&2; exit 1; }
