#!/usr/bin/env bash
# What clients that behave badly cost an agent's cycle: build/bench/live_clients.json. Two agents play at the same time
# for SECONDS [20] of real time, one without clients and one with clients at its debug port. There are 200 silent
# clients, one that sends lines of a megabyte, one that sends wrong values, and one that watches all representations in
# each cycle and reads nothing. Processor time of the agent's thread is compared, for both share the machine.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
scratch=$(mktemp -d)
agents=()
trap 'status=$?; ((${#agents[@]})) && kill "${agents[@]}" 2> /dev/null; wait 2> /dev/null; rm -rf "$scratch"; exit $status' EXIT
fail() { echo "clients.sh: $*" >&2; exit 1; }
ports=()
for name in quiet pestered; do
  bin/agent --start-simulator --simulator-option=--seed --simulator-option=1 --simulator-option=--realtime \
    --simulator-option=--kickoff-after --simulator-option=1 --debug 0 --crash-log "$scratch/$name.crash" > "$scratch/$name.out" 2> "$scratch/$name.err" &
  agents+=($!)
  for ((i = 0; i < 600; ++i)); do grep -qs 'debug port' "$scratch/$name.err" && break; sleep 0.05; done
  port=$(sed -n 's/.*debug port 127.0.0.1:\([0-9]*\):.*/\1/p' "$scratch/$name.err")
  [[ $port ]] || fail "no debug port: $(tail -1 "$scratch/$name.err")"
  ports+=("$port")
done
mkdir -p build/bench
python3 tests/bench/live/clients.py "${SECONDS_EACH:-20}" "${ports[@]}" > build/bench/live_clients.json.new
for agent in "${agents[@]}"; do kill -0 "$agent" 2> /dev/null || fail "an agent has ended"; done
mv build/bench/live_clients.json.new build/bench/live_clients.json
