#!/usr/bin/env bash
# Lets a whole game run for long and looks every half simulated minute at what simulator and agents hold and cost: resident
# memory of the simulator and of all agents, processor time per cycle. Says how both drift behind the first third.
#   scripts/soak.sh [MINUTES]     simulated minutes [10]
# The processor time of a cycle depends on what else the machine does: caches, the other thread of a core. Its counters of
# instructions would not, but virtual machines seldom have them. So the same game is played anew beside it in each window: its seconds
# 2 to 7, the same computing each time. A window's cost is the long game's over the new one's, of the same
# programs at the same time. Growth is the median of the last windows over that of as many before, with its standard error.
# Variables: AGENTS, in both teams together [22]; SEED of the simulator [1]; PLUMBLINE_BIN, where the programs are [bin].
# The samples stand in build/soak/AGENTS.csv, what it came to in AGENTS.txt. Status 1: an agent was lost, memory grew by more than
# LIMIT_KB [1024], or a cycle costs more than LIMIT_PERCENT [2] more than before, by at least two standard errors. "Not decided":
# the limit is within two standard errors; more MINUTES tell.
# Examples:
#   AGENTS=4 scripts/soak.sh 60
#   AGENTS=1 scripts/soak.sh 1440     a whole day of one agent
set -uo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
fail() { echo "soak.sh: $*" >&2; exit 2; }
minutes=${1:-10} number=${AGENTS:-22} seed=${SEED:-1} limit=${LIMIT_KB:-1024} percent=${LIMIT_PERCENT:-2}
bin=${PLUMBLINE_BIN:-$PWD/bin}
window=30 newFrom=2 newTo=7 patience=600 # [s]; the last one of silence
[[ $minutes =~ ^[0-9]+$ && $minutes -ge 3 ]] || fail "'$minutes' is no number of minutes from 3 on"
[[ $number =~ ^[0-9]+$ && $number -ge 1 && $number -le 22 ]] || fail "AGENTS is a number from 1 to 22"
for program in simulator agent; do [[ -x $bin/$program ]] || fail "no $bin/$program: make $program"; done
scratch=$(mktemp -d)
endJobs() { jobs -p | xargs -r kill 2> /dev/null; wait 2> /dev/null; }
trap 'status=$?; endJobs; rm -rf "$scratch"; exit $status' EXIT
trap 'exit 130' INT TERM
mkdir -p build/soak
samples=build/soak/$number.csv

# Leaves `simulator`, `agents` and file descriptor 3 with the status lines of the first agent. The game never ends.
startGame() { # folder
  local i port monitor
  mkdir "$1"
  mkfifo "$1/status"
  exec 3<> "$1/status"
  "$bin/simulator" --port 0 --monitor-port 0 --sync --seed "$seed" --wait-agents "$number" --half-time $((minutes * 60 + 600)) \
    --max-seconds $((minutes * 60 + 60)) --kickoff-after 1 --ports-file "$1/ports" > "$1/simulator.log" 2>&1 3>&- &
  simulator=$!
  for ((i = 0; i < 600; ++i)); do [[ -s $1/ports ]] && break; sleep 0.1; done
  port=$(sed -n 's/.*"agent": *\([0-9]*\).*/\1/p' "$1/ports")
  monitor=$(sed -n 's/.*"monitor": *\([0-9]*\).*/\1/p' "$1/ports")
  [[ $port ]] || fail "the simulator does not start: $(tail -1 "$1/simulator.log")"
  agents=()
  for ((i = 0; i < number; ++i)); do
    "$bin/agent" --port "$port" --monitor-port "$monitor" --team "$( ((i % 2)) && echo Right || echo Left)" --number $((i / 2 + 1)) \
      --type $((i % 5)) --crash-log "$1/crash$i.log" $( ((i)) || echo --status) \
      > "$( ((i)) && echo "$1/agent$i.log" || echo "$1/status")" 2> "$1/agent$i.err" 3>&- &
    agents+=($!)
  done
}
# Reads status lines up to a second of the game; leaves its time in `now`. Who reads each line when it comes knows the cycle.
playTo() { # seconds
  local word rest
  while read -r -t $patience word now rest <&3; do
    [[ $word == status && $now =~ ^[0-9]+[.][0-9]+$ ]] && ((${now%.*} >= $1)) && return
  done
  return 1
}
residentOf() { awk '/^VmRSS:/ { sum += $2 } END { print sum + 0 }' $(printf '/proc/%s/status ' "$@") 2> /dev/null; }
# Of that what they have allocated. The rest are pages of programs and libraries, which Linux brings in 64 kB at a time when
# a line of code runs for the first time.
allocatedOf() { awk '/^RssAnon:/ { sum += $2 } END { print sum + 0 }' $(printf '/proc/%s/status ' "$@") 2> /dev/null; }
# User and system time of all threads [us].
costOf() { awk '{ sum += $1 } END { printf "%.0f", sum / 1000 }' $(printf '/proc/%s/task/*/schedstat ' "$@") 2> /dev/null; }
costs() { echo "$(costOf $simulator),$(costOf "${agents[@]}")"; }

# What a cycle of simulator and agents costs when the game is new, for the window in which it is done. In a process of its own.
playAnew() {
  trap 'endJobs; rm -rf "$scratch/anew"' EXIT
  local now before
  startGame "$scratch/anew"
  playTo $newFrom || exit 1
  before=$(costs),$now
  playTo $newTo || exit 1
  echo "$before,$(costs),$now" | awk -F, '{ cycles = 50 * ($6 - $3); print ($4 - $1) / cycles "," ($5 - $2) / cycles }' > "$scratch/new"
}

startGame "$scratch/long"
echo "time,simulator_kb,agents_kb,simulator_us,agents_us,simulator_allocated_kb,agents_allocated_kb,new_simulator_us_per_cycle,new_agents_us_per_cycle" > "$samples"
anew=""
for ((next = window; next <= 60 * minutes; next += window)); do
  rm -f "$scratch/new"
  if [[ ! $anew ]] || ! kill -0 "$anew" 2> /dev/null; then
    playAnew &
    anew=$!
  fi
  playTo $next || fail "nothing moves any more: $(tail -1 "$scratch/long/simulator.log")"
  sample="$now,$(residentOf $simulator),$(residentOf "${agents[@]}"),$(costs),$(allocatedOf $simulator),$(allocatedOf "${agents[@]}")"
  echo "$sample,$(cat "$scratch/new" 2> /dev/null || echo ,)" >> "$samples"
  ((next % 60)) || echo "soak: minute $((next / 60)) of $minutes: simulator $(residentOf $simulator) kB, agents $(residentOf "${agents[@]}") kB"
done
alive=0
for agent in "${agents[@]}"; do kill -0 "$agent" 2> /dev/null && alive=$((alive + 1)); done
awk -F, -v limit="$limit" -v percent="$percent" -v number="$number" -v alive=$alive -f scripts/soak.awk "$samples" | tee "build/soak/$number.txt"
exit "${PIPESTATUS[0]}"
