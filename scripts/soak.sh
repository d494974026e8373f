#!/usr/bin/env bash
# Lets a whole game run for long and looks every simulated minute at what simulator and agents hold and cost: resident
# memory of the simulator and of all agents, processor time per cycle. Says how both drift behind the first third.
#   scripts/soak.sh [MINUTES]     simulated minutes [10]
# Variables: AGENTS, in both teams together [22]; SEED of the simulator [1]; PLUMBLINE_BIN, where the programs are [bin].
# The samples stand in build/soak/AGENTS.csv, what it came to in AGENTS.txt. Status 1: an agent was lost, memory grew by more
# than LIMIT_KB [1024], or a cycle costs more than LIMIT_PERCENT [20] more than before.
# Examples:
#   AGENTS=4 scripts/soak.sh 60
#   AGENTS=1 scripts/soak.sh 1440     a whole day of one agent: 15 minutes of computing
set -uo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
fail() { echo "soak.sh: $*" >&2; exit 2; }
minutes=${1:-10} number=${AGENTS:-22} seed=${SEED:-1} limit=${LIMIT_KB:-1024} percent=${LIMIT_PERCENT:-20}
bin=${PLUMBLINE_BIN:-$PWD/bin}
[[ $minutes =~ ^[0-9]+$ && $minutes -ge 3 ]] || fail "'$minutes' is no number of minutes from 3 on"
[[ $number =~ ^[0-9]+$ && $number -ge 1 && $number -le 22 ]] || fail "AGENTS is a number from 1 to 22"
for program in simulator agent; do [[ -x $bin/$program ]] || fail "no $bin/$program: make $program"; done
scratch=$(mktemp -d)
trap 'status=$?; jobs -p | xargs -r kill 2> /dev/null; wait 2> /dev/null; rm -rf "$scratch"; exit $status' EXIT
trap 'exit 130' INT TERM
mkdir -p build/soak
samples=build/soak/$number.csv

# The game never ends: a half is longer than the run.
"$bin/simulator" --port 0 --monitor-port 0 --sync --seed "$seed" --wait-agents "$number" --half-time $((minutes * 60 + 600)) \
  --max-seconds $((minutes * 60 + 30)) --kickoff-after 1 --ports-file "$scratch/ports" > "$scratch/simulator.log" 2>&1 &
simulator=$!
for ((i = 0; i < 600; ++i)); do [[ -s $scratch/ports ]] && break; sleep 0.1; done
port=$(sed -n 's/.*"agent": *\([0-9]*\).*/\1/p' "$scratch/ports")
monitor=$(sed -n 's/.*"monitor": *\([0-9]*\).*/\1/p' "$scratch/ports")
[[ $port ]] || fail "the simulator does not start: $(tail -1 "$scratch/simulator.log")"
agents=()
for ((i = 0; i < number; ++i)); do
  "$bin/agent" --port "$port" --monitor-port "$monitor" --team "$( ((i % 2)) && echo Right || echo Left)" --number $((i / 2 + 1)) \
    --type $((i % 5)) --crash-log "$scratch/crash$i.log" $( ((i)) || echo --status) > "$scratch/agent$i.log" 2>&1 &
  agents+=($!)
done

residentOf() { awk '/^VmRSS:/ { sum += $2 } END { print sum + 0 }' $(printf '/proc/%s/status ' "$@") 2> /dev/null; }
# Of that what they have allocated. The rest are pages of programs and libraries, which Linux brings in 64 kB at a time when
# a line of code runs for the first time.
allocatedOf() { awk '/^RssAnon:/ { sum += $2 } END { print sum + 0 }' $(printf '/proc/%s/status ' "$@") 2> /dev/null; }
# User and system time [ticks of 10 ms].
costOf() { awk '{ sub(/^.*\) /, ""); sum += $12 + $13 } END { print sum + 0 }' $(printf '/proc/%s/stat ' "$@") 2> /dev/null; }
timeNow() { tail -c 4000 "$scratch/agent0.log" 2> /dev/null | grep -a '^status' | tail -1 | awk '{ printf "%d", $2 }'; }

echo "minute,simulator_kb,agents_kb,simulator_ticks,agents_ticks,simulator_allocated_kb,agents_allocated_kb" > "$samples"
minute=1 last=0 silent=0
while kill -0 $simulator 2> /dev/null && ((minute <= minutes)); do
  now=$(timeNow)
  now=${now:-0}
  if ((now >= 60 * minute)); then
    echo "$minute,$(residentOf $simulator),$(residentOf "${agents[@]}"),$(costOf $simulator),$(costOf "${agents[@]}"),$(allocatedOf $simulator),$(allocatedOf "${agents[@]}")" >> "$samples"
    echo "soak: minute $minute of $minutes: simulator $(residentOf $simulator) kB, agents $(residentOf "${agents[@]}") kB"
    minute=$((minute + 1))
  else
    sleep 0.2
  fi
  if ((now == last)); then silent=$((silent + 1)); else silent=0 last=$now; fi
  ((silent < 3000)) || fail "nothing moves any more: $(tail -1 "$scratch/simulator.log")"
done
alive=0
for agent in "${agents[@]}"; do kill -0 "$agent" 2> /dev/null && alive=$((alive + 1)); done
awk -F, -v limit="$limit" -v percent="$percent" -v number="$number" -v alive=$alive '
  NR == 1 { next }
  { n = NR - 1; t[n] = $1; s[n] = $2; a[n] = $3; cs[n] = $4; ca[n] = $5; ms[n] = $6; ma[n] = $7 }
  END {
    from = int(n / 3) + 1 # before it caches and pools fill
    middle = from + int((n - from) / 2)
    if (n < 3) { print "too few samples"; exit 1 }
    grownS = s[n] - s[from]; grownA = a[n] - a[from]
    us = 1e4 / 3000 # ticks of 10 ms in a minute of 3000 cycles
    early = middle > from ? (cs[middle] - cs[from]) / (t[middle] - t[from]) * us : 0
    late = n > middle ? (cs[n] - cs[middle]) / (t[n] - t[middle]) * us : 0
    earlyA = middle > from ? (ca[middle] - ca[from]) / (t[middle] - t[from]) * us / number : 0
    lateA = n > middle ? (ca[n] - ca[middle]) / (t[n] - t[middle]) * us / number : 0
    printf "%d agents, %d simulated minutes: simulator %+d kB (now %d, allocated %+d), agents together %+d kB (now %d, allocated %+d) since minute %d; CPU per cycle simulator %.0f then %.0f us, an agent %.0f then %.0f us; %d agents at the end\n",
      number, t[n], grownS, s[n], ms[n] - ms[from], grownA, a[n], ma[n] - ma[from], t[from], early, late, earlyA, lateA, alive
    bad = grownS > limit || grownA > limit * number || alive < number || (early > 0 && late > early * (1 + percent / 100))
    exit bad
  }' "$samples" | tee "build/soak/$number.txt"
exit "${PIPESTATUS[0]}"
