#!/usr/bin/env bash
# bin/simulator as a program: its options, its exit status, and that nothing of it is left behind.
set -uo pipefail
source "$(dirname "$0")/../support/far-off.bash"
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
simulator=bin/simulator
work=$(mktemp -d)
started=()
trap 'for p in "${started[@]}"; do kill "$p" 2>/dev/null; done; rm -rf "$work"' EXIT
failures=0
expect() { # what, got, wanted
  [[ $2 == "$3" ]] && return
  failures=$((failures + 1))
  printf 'FAIL %s\n  got    %s\n  wanted %s\n' "$1" "$2" "$3"
}
free=(--port 0 --monitor-port 0)

# Bad input: one line on standard error, exit 2, nothing started.
refuses() { # wanted line, arguments...
  local wanted=$1 output status
  shift
  output=$(within 60 "$simulator" "$@" 2>&1 > "$work/out")
  status=$?
  expect "text of: $*" "$output" "simulator: $wanted"
  expect "status of: $*" "$status" 2
  expect "standard output of: $*" "$(cat "$work/out")" ""
}
refuses "there is no option --foo; see simulator --help" --foo
refuses "unexpected argument \"stray\"; see simulator --help" stray
refuses "--port: 'x' is not a port, 0 to 65535; see simulator --help" --port x
refuses "--port: '70000' is not a port, 0 to 65535; see simulator --help" --port 70000
refuses "--seed: '-1' is not a whole number, 0 to 2^53; see simulator --help" --seed -1
refuses "--max-seconds: '0' is not a time above 0 s; see simulator --help" --max-seconds 0
refuses "--max-seconds takes one value, once; see simulator --help" --max-seconds
refuses "--wait-agents: '23' is not a number of agents, 0 to 22; see simulator --help" --wait-agents 23
refuses "--monitor-step: '0' is not a time of 0.02 to 10 s; see simulator --help" --monitor-step 0
refuses 'unknown physics engine "foo"; there are: ode, ode-dense, bullet' --engine foo
refuses "--bind 0.0.0.0 opens the ports to others: set a --token" --bind 0.0.0.0
refuses "cannot write $work/no/ports: No such file or directory" "${free[@]}" --ports-file "$work/no/ports"
refuses "$work/none.csv: cannot be read; give a trace as .csv or .csv.gz" --replay "$work/none.csv"
refuses "$work/none.yaml: cannot be read: No such file or directory" --rules "$work/none.yaml"
printf 'time:\n  half: -3\n' > "$work/bad.yaml"
refuses "$work/bad.yaml:2: time.half must be within [0.02, 1e+06], not -3" --rules "$work/bad.yaml"

# Each accident of the league's server has a switch; those that a recording shows change its replay.
report() { within 60 "$simulator" --replay "tests/data/traces/$1.csv.gz" "${@:2}" 2>&1; }
for switch in bouncing-stops sleeping-robots frozen-limbs action-delay endless-friction lasting-commands; do
  expect "help names --no-$switch" "$("$simulator" --help | grep -c -e "--no-$switch")" 1
done
kick=$(report ut_kick_t3)
for switch in bouncing-stops endless-friction; do
  expect "--$switch is the default" "$(report ut_kick_t3 "--$switch")" "$kick"
  [[ $(report ut_kick_t3 "--no-$switch") != "$kick" ]] || expect "--no-$switch changes a kick" "nothing" "something"
done
[[ $(report fallF_t0 --no-sleeping-robots) != "$(report fallF_t0)" ]] ||
  expect "--no-sleeping-robots changes a fall" "nothing" "something"
[[ $(report ut_kick_t3 --engine bullet) != "$kick" ]] || expect "--engine bullet changes a kick" "nothing" "something"

# Starts one with the arguments; its ports are in $agent and $monitor, its process in $pid.
start() {
  rm -f "$work/ports"
  "$simulator" "${free[@]}" --ports-file "$work/ports" "$@" > "$work/out" 2> "$work/err" &
  pid=$!
  started+=("$pid")
  comesTrue test -s "$work/ports"
  agent=$(sed -n 's/.*"agent": \([0-9]*\).*/\1/p' "$work/ports")
  monitor=$(sed -n 's/.*"monitor": \([0-9]*\).*/\1/p' "$work/ports")
}
# Waits for a process; leaves its status in $status.
hasEnded() { ! kill -0 "$1"; }
finish() {
  comesTrue hasEnded "$1" || { expect "process $1" "does not end" "ends"; kill -9 "$1"; }
  wait "$1"
  status=$?
}
# What a client reads first after it sent these bytes (printf's format).
talk() { # port, bytes
  exec 3<> "/dev/tcp/127.0.0.1/$1" || return
  [[ -n $2 ]] && printf "$2" >&3
  timeout "$farOff" head -c "${3:-24}" <&3 | tail -c +5
  exec 3>&-
}

# Ports, the line that tells them, an agent, a monitor, Ctrl-C.
start --seed 5 --no-realtime --stats "$work/stats" -v
expect "what it prints" "$(head -1 "$work/out")" "simulator: agent port $agent, monitor port $monitor, seed 5"
scene='(scene rsg/agent/nao/nao_hetero.rsg 0)(syn)'
expect "an agent is answered" "$(talk "$agent" "\\0\\0\\0\\x2b$scene")" "(time (now 0.04))(GS"
expect "a monitor gets the scene" "$(talk "$monitor" "")" "((FieldLength 30)(Fi"
expect "a second one on the same port" \
  "$("$simulator" --port "$agent" --monitor-port 0 2>&1 > /dev/null) $?" \
  "simulator: port $agent of 127.0.0.1 is in use; choose another or 0 2"
kill -INT "$pid"
finish "$pid"
expect "status after Ctrl-C" "$status" 0
expect "statistics" "$(grep -cE '^\{"cycles": [0-9]+, "cpu_us_per_cycle": [0-9.]+, "sim_s": [0-9.]+, "wall_s": [0-9.]+, "x_real_time": [0-9.]+\}$' "$work/stats")" 1
expect "what it says at the end" "$(grep -c 'cycles, .* us of CPU each' "$work/out")" 1
expect "no half-written file" "$(find "$work" -name '*.part')" ""

# A field of its own, and one that cannot be.
printf 'length: 9\nwidth: 6\n' > "$work/field.yaml"
start --no-realtime --field "$work/field.yaml"
expect "the field is sent" "$(talk "$monitor" "" 36)" "((FieldLength 9)(FieldWidth 6)(F"
kill -INT "$pid"
finish "$pid"
printf 'length: 9\nwidht: 6\n' > "$work/field.yaml"
expect "a field with a wrong key" "$("$simulator" --field "$work/field.yaml" 2>&1 > /dev/null) $?" \
  "simulator: $work/field.yaml:2: unknown key \"widht\"; did you mean \"width\"? 2"

# The rules' file is the one that is written, so it names all there is.
expect "doc/reference/rules.yaml is what --print-rules writes" "$("$simulator" --print-rules | cmp - doc/reference/rules.yaml 2>&1)" ""

# In step with its agents, in simulated time.
start --sync --wait-agents 0 --max-seconds 2
finish "$pid"
expect "status after its time" "$status" 0

# It ends with its parent.
rm -f "$work/ports"
bash -c '"$0" --port 0 --monitor-port 0 --ports-file "$1/ports" --die-with-parent > /dev/null & echo $! > "$1/child"
  until [[ -s $1/ports ]]; do sleep 0.01; done' "$simulator" "$work"
child=$(cat "$work/child")
started+=("$child")
comesTrue hasEnded "$child"
expect "a child whose parent ended" "$(kill -0 "$child" 2>&1 | grep -c 'No such process')" 1

((failures == 0)) && echo "simulator.sh: all good"
exit $((failures > 0))
