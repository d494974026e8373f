#!/usr/bin/env bash
# Has the n-th write, sync, rename, open and allocation of each program fail, n = 1, 2, ... until the program makes fewer.
# Each must end with an error line and a status that is not 0, or do all it was to do, and leave no file half written.
# Writes fail once, and from the n-th on as on a full disk. Of allocations, which are many, the first from each place in the
# program fails: a place is the five innermost return addresses of the call.
#   scripts/faults.sh [--quick] [--list] [JOB]...      jobs [all]; --quick: a few jobs, the first calls of each
# Variables: PLUMBLINE_BIN, where the programs are [bin]. MOST, calls of each kind [40]. ALLOCATIONS, places [24]. KINDS [all].
# JOBS, how many jobs at once [one per core]. MOST=9999 ALLOCATIONS=9999 tries every call and place.
# What was tried stands in build/faults/table.txt, what broke in build/faults/findings.txt.
# Example: scripts/faults.sh gap_record logtool_cut
set -uo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
fail() { echo "faults.sh: $*" >&2; exit 2; }
source tests/faults/helpers.bash
source tests/faults/jobs.bash
most=${MOST:-40} allocations=${ALLOCATIONS:-24} kinds=${KINDS:-$all} placesWanted=yes
if [[ " $* " == *" --quick "* ]]; then most=4 allocations=6; fi
chooseJobs "$@"
begin build/faults

faultJob() { # job; tries, broken and row are the caller's
  local name=$1 kind tried
  prepareJob "$name" || { finding "$name" "" "its preparation failed: $(tail -1 "$scratch/err")"; row=(- - - - - -); return; }
  for kind in $all; do
    [[ " $kinds " == *" $kind "* ]] || { row+=(-); continue; }
    tryKind "$name" "$kind"
    row+=("$tried$( (($(callsOf $kind) > most)) && [[ $kind != malloc ]] && echo "/$(callsOf $kind)")")
  done
  row+=("$(placesOf)")
}

playJobs faultJob "$out/table.txt" '%-20s %8s %6s %6s %6s %6s %6s %7s' job write sync rename open malloc places broken
echo "$tries faults in ${#chosen[@]} jobs, $broken broke something" | tee -a "$out/table.txt"
((broken == 0 && tries > 0)) || { cat "$out/findings.txt" >&2; exit 1; }
