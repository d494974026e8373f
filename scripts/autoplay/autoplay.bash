# What the scripts of this folder share. shellcheck shell=bash
self=${0##*/}
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
bin=${PLUMBLINE_BIN:-$root/bin}

fail() { echo "$self: $*" >&2; exit 2; }
needsValue() { (($2 > 1)) || fail "$1 needs a value; see $self --help"; }
isWhole() { [[ $1 =~ ^[0-9]{1,15}$ ]]; }
isNumber() { [[ $1 =~ ^[0-9]+([.][0-9]+)?$ ]]; }

# Process ids of a game: whatever has its mark in the environment, wherever it has gone (setsid, nohup, fork).
processesOf() { # $1: the game's mark
  grep -lzsx "PLUMBLINE_GAME=$1" /proc/[0-9]*/environ 2> /dev/null | cut -d / -f 3
}

# Ends a game's processes: asks, waits two seconds, kills.
endGame() { # $1: the game's mark
  local signal pids i
  for signal in TERM KILL; do
    mapfile -t pids < <(processesOf "$1")
    ((${#pids[@]})) || return 0
    kill -$signal "${pids[@]}" 2> /dev/null || true
    for ((i = 0; i < 20; ++i)); do
      [[ $(processesOf "$1") ]] || return 0
      sleep 0.1
    done
  done
}

# Whether somebody listens on a TCP port of this machine; how many connections it has.
tcpPort() { # $1: port, $2: state, 0A listening, 01 connected
  local hex
  printf -v hex '%04X' "$1"
  cat /proc/net/tcp /proc/net/tcp6 2> /dev/null | awk -v port=":$hex\$" -v state="$2" '$2 ~ port && $4 == state' | wc -l
}
isListening() { (($(tcpPort "$1" 0A) > 0)); }
freePort() {
  local port
  for ((i = 0; i < 200; ++i)); do
    port=$((20000 + RANDOM % 10000))
    isListening "$port" || { echo "$port"; return; }
  done
  fail "no free port"
}

# ---- servers: each starts in the background with the game's mark and is there when its ports are ---------------
# Each in a session of its own, so that a Ctrl-C reaches the script first. They read: mark, seed, halfTime, realtime,
# players, folder; they set: agentPort, monitorPort, watchOptions.

# The embedded simulator: in step with its agents unless in real time; it kicks off by itself, at a time of its
# own clock, so that a seed repeats the game.
startSimulator() {
  local options=(--ports-file "$folder/ports.json" --seed "$seed" --half-time "$halfTime" --monitor-step 0.1 --kickoff-after 3)
  if [[ $agentPort ]]; then options+=(--port "$agentPort" --monitor-port "$monitorPort"); else options+=(--port 0 --monitor-port 0); fi
  if [[ $realtime ]]; then options+=(--wait-agents "$players"); else options+=(--sync --wait-agents "$players"); fi
  rm -f "$folder/ports.json"
  PLUMBLINE_GAME=$mark setsid "$bin/simulator" "${options[@]}" "${serverOptions[@]}" > "$folder/server.log" 2>&1 < /dev/null &
  local server=$! i
  for ((i = 0; i < 200; ++i)); do
    [[ -s $folder/ports.json ]] && break
    kill -0 $server 2> /dev/null || fail "the simulator did not start: $(tail -1 "$folder/server.log")"
    sleep 0.05
  done
  [[ -s $folder/ports.json ]] || fail "the simulator has no ports after 10 s; see $folder/server.log"
  agentPort=$(sed -n 's/.*"agent": \([0-9]*\).*/\1/p' "$folder/ports.json")
  monitorPort=$(sed -n 's/.*"monitor": \([0-9]*\).*/\1/p' "$folder/ports.json")
  watchOptions=(--no-kickoff)
}

# The league's server as it is installed: found in PATH or by RCSSSERVER3D. It runs with copies of its own scripts
# that have the seed, the length of a half and the synchronisation, in the folder of the game.
startRcssserver3d() {
  local program prefix file
  program=$(command -v "${RCSSSERVER3D:-rcssserver3d}") || fail "no ${RCSSSERVER3D:-rcssserver3d} in PATH: install rcssserver3d or set RCSSSERVER3D to it"
  program=$(readlink -f "$program")
  prefix=${program%/bin/*}
  [[ $agentPort ]] || agentPort=$(freePort) monitorPort=$(freePort)
  mkdir -p "$folder/server"
  for file in simspark/spark.rb rcssserver3d/rcssserver3d.rb rcssserver3d/naosoccersim.rb; do
    [[ -f $prefix/share/$file ]] || fail "$program: its scripts are expected in $prefix/share/, but there is no $file"
    cp "$prefix/share/$file" "$folder/server/"
  done
  local sync=true clock=false
  if [[ $realtime ]]; then sync=false clock=true; fi
  # Threads are off: in step they bring nothing, and Ruby suffers calls from one thread only.
  sed -i -e "s/^\$agentSyncMode *=.*/\$agentSyncMode = $sync/" -e "s/^\$threadedAgentControl *=.*/\$threadedAgentControl = false/" \
    -e "s/^\$serverMultiThreadedMode *=.*/\$serverMultiThreadedMode = false/" "$folder/server/spark.rb"
  sed -i "s/^\$enableRealTimeMode *=.*/\$enableRealTimeMode = $clock/" "$folder/server/rcssserver3d.rb"
  sed -i -e "s/randomServer\.seed([0-9]*)/randomServer.seed($seed)/" \
    -e "s/^addSoccerVar('RuleHalfTime',.*/addSoccerVar('RuleHalfTime', $(awk "BEGIN { printf \"%.3f\", $halfTime }"))/" "$folder/server/naosoccersim.rb"
  (
    cd "$folder/server" || exit 2
    export PLUMBLINE_GAME=$mark HOME=$folder/server
    export LD_LIBRARY_PATH=$prefix/lib/simspark:$prefix/lib/rcssserver3d${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
    exec setsid "$program" --init-script-prefix "$folder/server" --script-path rcssserver3d.rb --agent-port "$agentPort" \
      --server-port "$monitorPort" "${serverOptions[@]}"
  ) > "$folder/server.log" 2>&1 < /dev/null &
  waitForServer $!
  watchOptions=(--settle 3)
}

# Any other: a command with {agent}, {monitor}, {seed}, {halftime} for ports and the like.
startOther() { # $1: command
  local command=$1
  [[ $agentPort ]] || agentPort=$(freePort) monitorPort=$(freePort)
  command=${command//\{agent\}/$agentPort}
  command=${command//\{monitor\}/$monitorPort}
  command=${command//\{seed\}/$seed}
  command=${command//\{halftime\}/$halfTime}
  PLUMBLINE_GAME=$mark setsid bash -c "$command" > "$folder/server.log" 2>&1 < /dev/null &
  waitForServer $!
  watchOptions=()
}

waitForServer() { # $1: its process
  local i
  for ((i = 0; i < 300; ++i)); do
    if isListening "$agentPort" && isListening "$monitorPort"; then return; fi
    kill -0 "$1" 2> /dev/null || fail "the server did not start: $(tail -1 "$folder/server.log")"
    sleep 0.1
  done
  fail "the server does not listen on ports $agentPort and $monitorPort after 30 s; see $folder/server.log"
}
