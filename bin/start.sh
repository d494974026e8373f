#!/usr/bin/env bash
# Starts our team on a server and returns; the league's tournaments call it as start.sh HOST. bin/kill.sh ends it.
set -euo pipefail
bin=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# scripts/autoplay/ says by the environment where a game is.
host=127.0.0.1 port=${PLUMBLINE_AGENT_PORT:-3100} monitor=${PLUMBLINE_MONITOR_PORT:-3200}
team=${PLUMBLINE_TEAM_NAME:-Plumbline} players=11 logs=${PLUMBLINE_LOGS:-} config="" token="" wait=""
# At most 7 of a type, 9 of any two, three types in a full team.
types=(4 1 1 3 1 3 1 1 1 1 4)

usage() {
  cat << END
usage: start.sh [options] [HOST] [-- OPTIONS OF bin/agent]
  HOST                where the server runs [$host]
  -p, --port N        its agent port [$port]
  -m, --monitor N     its monitor port [$monitor]
  -t, --team NAME     [$team]
  -n, --players N     numbers 1 to N, 1 to 11 [$players]
  --types "T T ..."   robot types (0 to 4) of numbers 1, 2, ... [${types[*]}]
  --logs FOLDER       output of each agent, its cycles and CPU time (statsN.json), and its exit status (exitN)
  --config FOLDER     configuration [config beside bin]
  --token TOKEN       token of the simulator, if its port is open to other machines
  --wait              start the agents though no server is there yet; they wait for it
examples:
  bin/start.sh
  bin/start.sh 192.168.1.20 --team Red --players 3 --logs build/logs
  bin/start.sh -- --log build/game/player{number}     # {number} in these options is the player's
  bin/start.sh -- --draw team                         # roles and ways of all players in RoboViz
END
}
fail() { echo "start.sh: $*; see start.sh --help" >&2; exit 2; }
isNumber() { [[ $1 =~ ^[0-9]{1,5}$ ]]; }

hostGiven=""
while (($#)); do
  case $1 in
    -h | --help) usage; exit 0 ;;
    --) shift; break ;;
    -p | --port | -m | --monitor | -t | --team | -n | --players | --types | --logs | --config | --token)
      (($# > 1)) || fail "$1 needs a value"
      case $1 in
        -p | --port) port=$2 ;;
        -m | --monitor) monitor=$2 ;;
        -t | --team) team=$2 ;;
        -n | --players) players=$2 ;;
        --types) read -ra types <<< "$2" ;;
        --logs) logs=$2 ;;
        --config) config=$2 ;;
        --token) token=$2 ;;
      esac
      shift 2 ;;
    --wait) wait=1; shift ;;
    -*) fail "unknown option $1" ;;
    *) [[ $hostGiven ]] && fail "two hosts: $host and $1"
       host=$1 hostGiven=1; shift ;;
  esac
done
isNumber "$port" || fail "port '$port' is no number"
isNumber "$monitor" || fail "monitor port '$monitor' is no number"
isNumber "$players" && ((players >= 1 && players <= 11)) || fail "--players '$players' is not 1 to 11"
((${#types[@]} >= players)) || fail "${#types[@]} types for $players players"
robots=${config:-${bin%/bin}/config}/robots
for type in "${types[@]}"; do
  [[ $type =~ ^[0-9]$ && (! -d $robots || -e $robots/simspark_type$type.json) ]] || fail "there is no robot type '$type' in $robots"
done
isTeamName() { local LC_ALL=C; [[ $1 =~ ^[!-~]{1,20}$ && $1 != *[\(\)\"]* ]]; }
isTeamName "$team" || fail "team '$team': a team's name is 1 to 20 printable ASCII characters without blanks, parentheses or quotes"
[[ -x $bin/agent ]] || fail "no $bin/agent: make SimRelease builds it"
if [[ ! $wait ]] && ! timeout 3 bash -c 'exec 3<> "/dev/tcp/$0/$1"' "$host" "$port" 2> /dev/null; then
  fail "no server at $host:$port: start one first, or give --wait"
fi
[[ $logs ]] && mkdir -p "$logs"

# Runs agent $1, writes its process id into the file $0/pid$1 and, when it has ended, its exit status into $0/exit$1. A signal to end is
# passed on; where kill.sh has sent it to both, the agent ignores the second one.
waitForAgent='number=$1
shift
trap "kill -TERM \$! 2> /dev/null" TERM INT HUP
"$@" &
echo $! > "$0/pid$number"
while status=0; wait $! || status=$?; kill -0 $! 2> /dev/null; do :; done
echo $status > "$0/exit$number"'

# Whether a process has its connection to the server.
isConnected() { # PID
  local inode sockets
  sockets=$(readlink "/proc/$1"/fd/* 2> /dev/null || true)
  for inode in $(awk -v port="$(printf ':%04X' "$port")" 'substr($3, length($3) - 4) == port && $4 == "01" { print $10 }' /proc/net/tcp*); do
    [[ $sockets != *"socket:[$inode]"* ]] || return 0
  done
  return 1
}

export PLUMBLINE_TEAM=$team PLUMBLINE_START=$bin # by which kill.sh knows its own
for ((number = 1; number <= players; ++number)); do
  options=(--team "$team" --number "$number" --type "${types[number - 1]}" --host "$host" --port "$port" --monitor-port "$monitor")
  [[ $token ]] && options+=(--token "$token")
  [[ $config ]] && options+=(--config "$config")
  if [[ $logs ]]; then
    output=$logs/agent$number.log options+=(--crash-log "$logs/crash$number.log")
    [[ " $* " == *" --stats"* ]] || options+=(--stats "$logs/stats$number.json")
    rm -f "$logs"/{pid,exit}$number
    command=(bash -c "$waitForAgent" "$logs" "$number" "$bin/agent")
  else
    output=/dev/null command=("$bin/agent")
  fi
  # Not hung up with this shell, and not ended by its Ctrl-C.
  setsid "${command[@]}" "${options[@]}" "${@//\{number\}/$number}" > "$output" 2>&1 < /dev/null &
  agent=$!
  disown
  # One after the other: the server gives places in the order of connecting, so a seed repeats a game. And on the league's
  # server robots that come at once lie on top of each other, and then it hardly goes on.
  for ((look = 0; look < 100; ++look)); do
    [[ ! $logs || ! -s $logs/pid$number ]] || agent=$(< "$logs/pid$number")
    { [[ $wait ]] || isConnected $agent || ! kill -0 $agent 2> /dev/null; } && break
    sleep 0.02
  done
  sleep "${PLUMBLINE_START_PAUSE:-0.1}"
done
