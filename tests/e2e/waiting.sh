# Agents that wait for a server, for a number or for others, and servers that do not read: who waits says for what, and a
# signal ends every program at once. Of crowds of idle connections, idle_connections.sh.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"

server() { # name, options...
  local name=$1; shift
  "$bin/simulator" --port "${port:-0}" --monitor-port 0 --ports-file "$scratch/$name" "$@" > "$scratch/$name.out" 2> "$scratch/$name.log" &
  serverPid=$!
  waitFor test -s "$scratch/$name"
  read -r port monitorPort _ < <(tr -cs '0-9\n' ' ' < "$scratch/$name")
}
agent() { # name, options...
  local name=$1; shift
  "$bin/agent" --port "$port" --monitor-port "$monitorPort" --crash-log "$scratch/$name.crash" --status "$@" \
    > "$scratch/$name.out" 2> "$scratch/$name.err" &
  agentPid=$!
}

# No server: a line says so, no status is made up; then the server comes, goes, and comes back.
port=0 monitorPort=0
server first
endsBy TERM "$serverPid" "a simulator without agents"
agent late
waitFor grep -q "agent: waiting for a server: cannot connect to 127.0.0.1:$port: Connection refused" "$scratch/late.err"
expectEqual "$(cat "$scratch/late.out")" "" "status without a server"
server second
waitFor grep -q "agent: plays on port $port" "$scratch/late.err"
waitFor grep -q "^status" "$scratch/late.out"
latePid=$agentPid

# A number that is taken: the second agent says so, and gets the number when it is free.
agent taken
waitFor grep -q "gives no place in team Plumbline yet: number 1 may be taken" "$scratch/taken.err"
endsBy INT "$latePid" "an agent that plays"
waitFor grep -q "agent: plays on port" "$scratch/taken.err"

# The server goes and comes back.
endsBy TERM "$serverPid" "a simulator with an agent"
waitFor grep -q "agent: connection lost: " "$scratch/taken.err"
server third
waitFor grep -q "agent: back on port $port" "$scratch/taken.err"
endsBy TERM "$agentPid" "an agent that came back"
endsBy INT "$serverPid" "a simulator"

# A clock that stands until all are there: both say what they wait for, and nobody leaves.
port=0
server crowd --wait-agents 2 --max-seconds 60
agent one
waitFor grep -q "waiting for 2 agents on port $port, 1 so far; the clock is stopped, and the time until the end is simulated time" "$scratch/crowd.log"
waitFor grep -q "agent: connected; port $port gives no robot yet" "$scratch/one.err"
expectEqual "$(cat "$scratch/one.out")" "" "status before the first message"
onePid=$agentPid
agent two --number 2
waitFor grep -q "^status" "$scratch/one.out"
waitFor grep -q "^status" "$scratch/two.out"
endsBy INT "$onePid" "an agent"
endsBy INT "$agentPid" "an agent"

# A server that never reads holds no signal up.
port=0
python3 -c '
import socket, sys, time
listener = socket.socket()
listener.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
listener.bind(("127.0.0.1", 0))
listener.listen(1)
print(listener.getsockname()[1], flush=True)
client, _ = listener.accept()
frame = lambda text: len(text).to_bytes(4, "big") + text
for i in range(10 ** 6):
    client.sendall(frame(b"(time (now %.2f))(GS (t 0.00) (pm BeforeKickOff))(GYR (n torso) (rt 0 0 0))" % (0.02 * i)))
' > "$scratch/deaf" 2> /dev/null &
waitFor test -s "$scratch/deaf"
port=$(cat "$scratch/deaf")
agent deaf
stuck() { [[ $(cat "/proc/$agentPid/wchan") == *poll* ]] && (($(ss -tn "dst 127.0.0.1:$port" 2> /dev/null | awk 'NR > 1 {print $3}') > 10000)); }
if command -v ss > /dev/null; then waitFor stuck; else sleep 3; fi
endsBy INT "$agentPid" "an agent whose server does not read"

# A motion without a behaviour, once.
within 120 "$bin/agent" --motion wave --once --status --start-simulator --simulator-option=--sync --crash-log "$scratch/crash" \
  > "$scratch/wave" || fail "--motion wave --once: status $?"
grep -q "playing wave" "$scratch/wave" || fail "no wave in: $(cat "$scratch/wave")"
