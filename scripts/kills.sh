#!/usr/bin/env bash
# Kills every writer and server as by kill -9: within a write, before a rename, or anywhere in its work, at places that
# a seed draws. No file may be half written, and a recording must be readable up to there. A program that continues its
# work must give the same bytes as without the kill.
#   scripts/kills.sh [--list] [JOB]...     jobs of tests/faults/jobs.bash [all]
# Variables: KILLS, of each job [8]; SEED, of the places [1]; JOBS, how many jobs at once [one per core]; PLUMBLINE_BIN, where
# the programs are [bin]. A kill takes some 0.15 s, and 1000 of each job over an hour.
# What was tried stands in build/faults/kills.txt (folders: how many different ones the kills left, each gone on with once),
# what broke in build/faults/findings.txt.
# Example: KILLS=1000 scripts/kills.sh
set -uo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
fail() { echo "kills.sh: $*" >&2; exit 2; }
source tests/faults/helpers.bash
source tests/faults/jobs.bash
source tests/faults/draw.bash
kills=${KILLS:-8}
takeSeed "$kills" KILLS
chooseJobs "$@"
begin build/faults

killJob() { # job; tries, broken and row are the caller's
  local name=$1 i readable=0 resumed=0 state drawn place fileKinds=()
  local -A callsBefore states=()
  prepareJob "$name" || { finding "$name" "" "its preparation failed: $(tail -1 "$scratch/err")"; row=(0 - - -); return; }
  beginDraws "$name"
  for ((i = 0; i < kills; ++i)); do
    drawPlace
    place+=!
    freshWork
    playJob "$name" "$scratch/work" "$place"
    ((i % 20 == 19)) && [[ -t 2 ]] && printf '\r%-20s %d of %d \r' "$name" $i "$kills" >&2
    [[ -s $scratch/faults ]] || continue # it ended before it came there
    tries=$((tries + 1))
    # Or a process that it made of itself was killed, and it went on without or says so.
    ((status == 137 || status == goodStatus)) || grep -aq "^${programOf[$name]}: " "$scratch/err" ||
      finding "$name" "$place" "ends with status $status, not by the kill"
    judgeAfterKill "$name" "$place"
  done
  serverStands || finding "$name" "" "the server that it is a client of is gone"
  row=("$tries" "$(declare -F "$name"_check > /dev/null && echo $readable || echo -)"
    $(declare -F "$name"_resumes > /dev/null && echo $resumed ${#states[@]} || echo - -))
}

playJobs killJob "$out/kills.txt" '%-20s %6s %8s %8s %7s %7s' job kills readable resumed folders broken
echo "$tries kills in ${#chosen[@]} jobs (seed $seed), $broken broke something" | tee -a "$out/kills.txt"
((broken == 0 && tries > 0)) || { cat "$out/findings.txt" >&2; exit 1; }
