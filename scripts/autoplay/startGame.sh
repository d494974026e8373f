#!/usr/bin/env bash
# Plays a whole game between two teams without a person (thesis A.5) and writes a line of games.log about it.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/autoplay.bash"
server=simulator seed="" halfTime=300 players=22 log=games.log folder="" realtime="" limit=7200 hang=60 patience=120
network=auto names=("" "") verbose="" inside="" agentPort="" monitorPort="" serverOptions=() teams=()

usage() {
  cat << END
usage: startGame.sh [options] LEFT RIGHT [-- OPTIONS OF THE SERVER]
  LEFT, RIGHT        how a team is started: its start script, called in its folder as the league does, with the
                     host; or a command with {host}, {agent}, {monitor} in place of host and ports
  --server NAME      simulator, rcssserver3d, or a command with {agent}, {monitor}, {seed}, {halftime} [simulator]
  --seed N           seed of the server, for games that can be repeated [by chance]
  --half-time S      length of a half [300]
  --realtime         at the pace of the clock; without, as fast as it goes (agents must say (syn))
  --players N        how many come in all; kick-off waits for them [22]
  --names LEFT,RIGHT names in games.log, and of teams started by bin/start.sh [those the teams give]
  --log FILE         [games.log]
  --output FOLDER    what the programs said [build/games/DATE-PROCESS]
  --patience S, --hang S, --limit S
                     longest time to wait for players [120], without any change [60], in all [7200]; of real time
  --network own|shared|auto
                     own: a network of the game's own, where ports 3100 and 3200 are free for any start script;
                     auto: own if a start script needs it, as it gets no ports
  --verbose          a line per second
examples:
  scripts/autoplay/startGame.sh bin/start.sh "bin/start.sh --team Other"
  scripts/autoplay/startGame.sh --server rcssserver3d bin/start.sh ../opponent/start.sh
Exit status: 0 the game is over; 1 it came to no end, games.log says why; 2 bad options; 130 interrupted.
END
}

arguments=("$@")
while (($#)); do
  case $1 in
    -h | --help) usage; exit 0 ;;
    --) shift; serverOptions=("$@"); break ;;
    --realtime) realtime=1; shift ;;
    --verbose) verbose=1; shift ;;
    --inside) inside=1; shift ;;
    --server | --seed | --half-time | --players | --names | --log | --output | --patience | --hang | --limit | --network)
      needsValue "$1" $#
      case $1 in
        --server) server=$2 ;;
        --seed) seed=$2 ;;
        --half-time) halfTime=$2 ;;
        --players) players=$2 ;;
        --names) [[ $2 == ?*,?* ]] || fail "--names '$2': two names with a comma between"
          names=("${2%%,*}" "${2#*,}") ;;
        --log) log=$2 ;;
        --output) folder=$2 ;;
        --patience) patience=$2 ;;
        --hang) hang=$2 ;;
        --limit) limit=$2 ;;
        --network) network=$2 ;;
      esac
      shift 2 ;;
    -*) fail "unknown option $1; see $self --help" ;;
    *) teams+=("$1"); shift ;;
  esac
done
((${#teams[@]} == 2)) || fail "two teams are wanted, not ${#teams[@]}; see $self --help"
if [[ ! $seed ]]; then seed=$((1 + (RANDOM << 15 | RANDOM))); fi
isWhole "$seed" && ((seed > 0)) || fail "--seed '$seed' is no whole number from 1"
isWhole "$players" && ((players >= 1 && players <= 22)) || fail "--players '$players' is not 1 to 22"
for value in "$halfTime" "$patience" "$hang" "$limit"; do isNumber "$value" || fail "'$value' is no number of seconds"; done
[[ $network == own || $network == shared || $network == auto ]] || fail "--network '$network': own, shared or auto"
for program in simulator watchgame; do [[ -x $bin/$program ]] || fail "no $bin/$program: make SimRelease builds it"; done

# A team's command: a start script is called in its folder. isPlain: it gets the host and nothing else.
ownStart=$root/bin/start.sh
isPlain() { [[ $1 != *'{'* && $(readlink -f "${1%% *}" 2> /dev/null) != "$ownStart" ]]; }
for team in "${teams[@]}"; do
  first=${team%% *}
  [[ $team == *'{'* ]] || [[ -x $first && -f $first ]] || fail "no start script $first; see $self --help"
done
if [[ ! $inside && $network == auto ]]; then
  network=shared
  for team in "${teams[@]}"; do if isPlain "$team"; then network=own; fi; done
fi
if [[ ! $inside && $network == own ]]; then
  if unshare --user --map-root-user --net ip link set lo up 2> /dev/null; then
    exec unshare --user --map-root-user --net "${BASH_SOURCE[0]}" --inside "${arguments[@]}"
  fi
  # Not allowed here: then on the league's ports, one game after the other.
  echo "$self: this system gives no network of its own: on ports 3100 and 3200, one game at a time" >&2
  exec 9> "${TMPDIR:-/tmp}/plumbline-ports-3100.lock"
  flock 9 || fail "cannot lock ports 3100 and 3200"
  agentPort=3100 monitorPort=3200
fi
if [[ $inside ]]; then
  ip link set lo up
  agentPort=3100 monitorPort=3200
fi
if [[ $agentPort ]] && { isListening "$agentPort" || isListening "$monitorPort"; }; then fail "port $agentPort or $monitorPort is in use"; fi

[[ $folder ]] || folder=$root/build/games/$(date +%Y%m%d-%H%M%S)-$$
mkdir -p "$folder" || fail "cannot make $folder"
folder=$(cd "$folder" && pwd)
[[ $log == /* ]] || log=$PWD/$log
mark=$$-$RANDOM$RANDOM
watcher=""
# Whatever happens, nothing is left behind.
leave() {
  local status=$?
  trap - EXIT
  trap '' INT TERM HUP
  if [[ $watcher ]]; then kill -TERM "$watcher" 2> /dev/null || true; fi
  endGame "$mark"
  exit $status
}
trap leave EXIT
trap 'exit 130' INT TERM HUP

startTeam() { # $1: 0 left, 1 right
  local command=${teams[$1]} side=(left right) name=${names[$1]}
  # A team against itself needs two names.
  if [[ ! $name && $1 == 1 && ${teams[0]} == "${teams[1]}" ]]; then name=Mirror; fi
  if [[ $command == *'{'* ]]; then
    command=${command//\{host\}/127.0.0.1}
    command=${command//\{agent\}/$agentPort}
    command=${command//\{monitor\}/$monitorPort}
  else
    local script=${command%% *} rest=""
    [[ $command == *' '* ]] && rest=${command#* }
    script=$(readlink -f "$script")
    command="cd $(printf %q "${script%/*}") && ./$(printf %q "${script##*/}") 127.0.0.1 $rest"
  fi
  (
    exec 9>&-
    export PLUMBLINE_GAME=$mark PLUMBLINE_AGENT_PORT=$agentPort PLUMBLINE_MONITOR_PORT=$monitorPort PLUMBLINE_LOGS=$folder/${side[$1]}
    if [[ $name ]]; then export PLUMBLINE_TEAM_NAME=$name; fi
    exec setsid bash -c "$command"
  ) > "$folder/${side[$1]}.log" 2>&1 < /dev/null &
}

case $server in
  simulator) startSimulator ;;
  rcssserver3d) startRcssserver3d; export PLUMBLINE_START_PAUSE=0.5 ;;
  *'{'*) startOther "$server"; server=other ;;
  *) fail "no server '$server': simulator, rcssserver3d or a command with {agent} and {monitor}" ;;
esac
echo "$self: $server, seed $seed, agent port $agentPort, monitor port $monitorPort, logs in $folder"

"$bin/watchgame" --limit "$limit" --port "$monitorPort" --players "$players" --patience "$patience" --hang "$hang" \
  --server "$server" --seed "$seed" --half-time "$halfTime" --log "$log" ${names[0]:+--left "${names[0]}" --right "${names[1]}"} \
  --end-server --track "$folder/track.csv" "${watchOptions[@]}" > "$folder/game.log" 2>&1 < /dev/null &
watcher=$!

# The team that comes first is the left one. Its players connect before those of the other team, so that the server has all
# in one order and a seed repeats the game. A smaller team has come if nobody follows for two seconds.
startTeam 0
connected=0
for ((i = 0, quiet = 0; i < 200; ++i, ++quiet)); do
  now=$(tcpPort "$agentPort" 01)
  ((now == connected)) || quiet=0
  connected=$now
  ((connected >= players / 2 || (connected > 0 && quiet >= 40))) && break
  kill -0 $watcher 2> /dev/null || break
  sleep 0.05
done
startTeam 1

if [[ $verbose ]]; then
  tail -f --pid=$watcher "$folder/game.log" 2> /dev/null &
fi
status=0
wait $watcher || status=$?
watcher=""
if ((status == 0)); then tail -1 "$folder/game.log"; else tail -2 "$folder/game.log" >&2; fi
exit $((status == 0 ? 0 : 1))
