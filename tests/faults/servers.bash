# Servers that the programs of jobs are clients of; sourced after helpers.bash.
# One of them sees many kills of its clients, and must be there after the last.
startSimulator() { # leaves `server` and `port`
  rm -f sim.ports
  env -u LD_PRELOAD "$bin/simulator" --port 0 --monitor-port 0 --wait-agents 0 --realtime --max-seconds 36000 --ports-file sim.ports \
    < /dev/null > /dev/null 2>&1 &
  server=$!
  waitFor 20 test -s sim.ports
  port=$(portIn sim.ports monitor)
}
startAgent() { # on the sample; leaves `server` and `port`
  env -u LD_PRELOAD "$bin/agent" --config "$tree/config" --replay "$sample" --paused --debug 0 --crash-log crash.log \
    < /dev/null > /dev/null 2> agent.err &
  server=$!
  waitFor 20 grep -q 'debug port' agent.err
  port=$(sed -n 's/.*debug port 127.0.0.1:\([0-9]*\).*/\1/p' agent.err)
}
withServer() { # startSimulator or startAgent, command with PORT: the server goes on for the next time
  local server port start=$1
  shift
  if [[ ! -s $scratch/server/pid ]]; then
    mkdir -p "$scratch/server"
    (cd "$scratch/server" && "$start" && echo "$server $port" > pid)
  fi
  read -r server port < "$scratch/server/pid"
  kill -0 "$server" 2> /dev/null || { echo "the server is gone" >&2; return 99; }
  "${@/%PORT/$port}"
}
withSimulator() { # command with PORT: a game of its own
  local result server port
  startSimulator
  "${@/%PORT/$port}"
  result=$?
  kill "$server" 2> /dev/null
  wait "$server" 2> /dev/null
  rm -f sim.ports
  return $result
}
withOptserver() { # command with PORT: the search of study.yaml, from where its folder `search` has come to
  local result server
  rm -f search/port
  env -u LD_PRELOAD "$bin/optserver" study.yaml --folder search --port 0 --every 1000 < /dev/null > /dev/null 2>&1 &
  server=$!
  waitFor 20 hasSaid search/port $server
  "${@/%PORT/$(< search/port)}"
  result=$?
  # A search that is over ends by itself.
  ((result == 0)) && waitFor 5 isGone $server
  kill "$server" 2> /dev/null
  # After the kill of a worker whose last result had come, the search is over before another worker is there.
  wait "$server" 2> /dev/null && [[ ! ${FAULT-} ]] && result=0
  rm -f search/port
  return $result
}
isGone() { ! kill -0 "$1" 2> /dev/null; }
# Whether the server that a job's program is a client of is there.
serverStands() { [[ ! -s $scratch/server/pid ]] || kill -0 "$(cut -d' ' -f1 "$scratch/server/pid")" 2> /dev/null; }
stopServers() {
  local server
  for server in "$scratch"/server/pid "$scratch"/of/*/server/pid; do
    [[ ! -s $server ]] || kill "$(cut -d' ' -f1 "$server")" 2> /dev/null
  done
}
