#!/usr/bin/env bash
# What the simulator's time goes to in a game of 22 bin/agent's in step: shares of its CPU time by sampling its
# stack (perf, which need not be there: then there are no such figures). Writes build/bench/simulator_profile.json.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
out=build/bench/simulator_profile
rm -f "$out".*
if ! perf stat -e cpu-clock true > /dev/null 2>&1; then
  echo "profile.sh: no perf, or it may not count: no profile" >&2
  exit 0
fi

agents=()
cleanUp() {
  for pid in "${agents[@]}"; do kill "$pid" 2> /dev/null || true; done
  wait 2> /dev/null || true
  rm -f "$out".data "$out".ports
}
trap cleanUp EXIT
timeout 120 perf record -e cpu-clock -F 997 --call-graph dwarf,4096 -o "$out.data" -- bin/simulator --sync --seed 1 --port 0 --monitor-port 0 \
  --ports-file "$out.ports" --wait-agents 22 --kickoff-after 2 --max-seconds 30 --die-with-parent > "$out.log" 2>&1 &
game=$!
for ((i = 0; i < 100; ++i)); do [[ -s $out.ports ]] && break; sleep 0.1; done
agentPort=$(sed 's/.*"agent": \([0-9]*\).*/\1/' "$out.ports")
monitorPort=$(sed 's/.*"monitor": \([0-9]*\).*/\1/' "$out.ports")
types=(0 4 4 1 4 0 3 1 3 4 0)
for team in Red Blue; do
  for ((i = 0; i < 11; ++i)); do
    bin/agent --team "$team" --number $((i + 1)) --type "${types[i]}" --port "$agentPort" --monitor-port "$monitorPort" \
      --crash-log "$out.crash" > /dev/null 2>&1 &
    agents+=($!)
  done
done
wait "$game"

# Share of all samples with the function on the stack.
timeout 300 perf report -i "$out.data" --children --stdio -g none --percent-limit 0.05 2> /dev/null | awk '
  BEGIN {
    of["physics"] = "SoccerWorld::step$"; of["physics_factor"] = "TreeSystem::factor$"
    of["physics_contacts_and_stops"] = "OdeTreeStep::solveRows$"; of["physics_finding_contacts"] = "OdeContacts::find$"
    of["referee"] = "Referee::update$"; of["referee_self_collisions"] = "judgeSelfCollisions$"
    of["senses"] = "Simulation::makeSenses$"; of["senses_vision"] = "Vision::see$"
    of["sending_senses"] = "AgentPort::sendSenses$"; of["receiving_commands"] = "Server::listen$"
    of["obeying_commands"] = "Simulation::act(\\[abi:cxx11\\])?$"; of["monitors"] = "MonitorPort::tell$"
  }
  /^#/ { next }
  { share = $1; sub("%", "", share); for (what in of) if ($0 ~ of[what] && share > most[what]) most[what] = share + 0 }
  END {
    order = "physics physics_factor physics_contacts_and_stops physics_finding_contacts senses senses_vision referee referee_self_collisions receiving_commands obeying_commands sending_senses monitors"
    count = split(order, names, " ")
    for (i = 1; i <= count; ++i) if (names[i] in most)
      printf "%s{\"name\": \"simulator.profile_22_%s\", \"value\": %s, \"unit\": \"%% of CPU\", \"better\": \"lower\"}", (written++ ? ",\n " : "[\n "), names[i], most[names[i]]
    if (!written) exit 1
    print "\n]"
  }' > "$out.new"
mv "$out.new" "$out.json"
