#!/usr/bin/env bash
# Stops every program as by Ctrl-C and as by kill: within file work, at an allocation, or at any moment of its work, at places
# that a seed draws. Each must end within a second with status 130 and a line that says so, or as usual. Nothing may be half
# written, no temporary file and no process may be left. A program that continues its work must come to the same bytes.
#   scripts/stops.sh [--quick] [--list] [JOB]...     jobs of tests/faults/jobs.bash [all]; --quick: a few jobs, four stops of each
# Variables: STOPS, of each job [8]. SEED, of the places [1]. JOBS, how many jobs at once [one per core]. PLUMBLINE_BIN, where
# the programs are [bin]. Signals are SIGINT and SIGTERM in turn. On a busy machine a second is as much longer as the load average
# is above the number of cores; more than a second of CPU never passes.
# What broke is in build/stops/findings.txt, the results in build/stops/table.txt. Its columns: uncaught: before or after the program's
# work, where the signal itself ends it. longest: from the signal to the end. slow: took over a second once, but not again.
# Example: STOPS=100 scripts/stops.sh gap_diagnose game
set -uo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
fail() { echo "stops.sh: $*" >&2; exit 2; }
source tests/faults/helpers.bash
source tests/faults/jobs.bash
source tests/faults/draw.bash
source tests/faults/stops.bash
patience=120 stopped=yes
stops=${STOPS:-8}
takeSeed "$stops" STOPS
if [[ " $* " == *" --quick "* ]]; then stops=4; fi
chooseJobs "$@"
begin build/stops

stopJob() { # job; tries, broken and row are the caller's
  local name=$1 i readable=0 resumed=0 state drawn place took signal=TERM most=0 slow=0 uncaught=0 fileKinds=()
  local -A callsBefore states=()
  prepareJob "$name" || { finding "$name" "" "its preparation failed: $(tail -1 "$scratch/err")"; row=(0 - - - -); return; }
  beginDraws "$name"
  for ((i = 0; i < stops; ++i)); do
    drawPlace moment
    if [[ $signal == TERM ]]; then signal=INT; else signal=TERM; fi
    ((i % 20 == 19)) && [[ -t 2 ]] && printf '\r%-20s %d of %d \r' "$name" $i "$stops" >&2
    playStop "$name" "$place" $signal || continue
    tries=$((tries + 1))
    ((took <= most)) || most=$took
    judgeStop "$name" "$place" $signal
    ((took <= $(longest))) || playStopAgain "$name" "$place" $signal
  done
  serverStands || finding "$name" "" "the server that it is a client of is gone"
  row=("$tries" $uncaught "$(awk "BEGIN { printf \"%.3f\", $most / 1e6 }")" $slow "$(declare -F "$name"_resumes > /dev/null && echo $resumed || echo -)")
}

playJobs stopJob "$out/table.txt" '%-20s %6s %9s %8s %5s %8s %7s' job stops uncaught longest slow resumed broken
echo "$tries stops in ${#chosen[@]} jobs (seed $seed), $broken broke something" | tee -a "$out/table.txt"
((broken == 0 && tries > 0)) || { cat "$out/findings.txt" >&2; exit 1; }
