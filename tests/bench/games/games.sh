#!/usr/bin/env bash
# The team against players without teamwork, which all go to the ball (config/platforms/simspark/swarm.cfg), in whole
# games on the embedded simulator.
# Settings by the environment: GAMES [10], HALF seconds [300], SEED of the first game [1], JOBS at once [cores]. BEFORE:
# the folder of an earlier state that is built, to play against as well. OUT: what the results' files are called
# [build/bench/games]. Before the games one robot tries set starts (starts.sh). Writes OUT.json and OUT.md; what the
# programs said stays in the new folder OUT. `make bench-games` builds what it needs and writes doc/results/games.md.
# With OTHER, the command that starts a team that is not ours, nothing but games against that team, PLAYERS [11] on each
# side: {host}, {agent}, {monitor}, {team} and {players} in it are replaced. A script without them gets the host
# alone. With OTHER_NAME as well, what that team is called, the table goes into games-peers/ beside OUT and with those of
# other teams into games-peers.md there, of which make_results.sh makes doc/results/games-peers.md. SERVER=rcssserver3d plays
# them on the league's server, as scripts/autoplay/startGame.sh finds it, instead of the embedded simulator. REALTIME=1 plays games
# at the pace of the clock; the tables then also have the cycles of our players that were late by it. JOBS=1 is wise then.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
games=${GAMES:-10} half=${HALF:-300} seed=${SEED:-1} jobs=${JOBS:-$(nproc)} players=${PLAYERS:-11} server=${SERVER:-simulator} realtime=${REALTIME:+--realtime} out=${OUT:-build/bench/games}
for value in "$games" "$half" "$seed" "$jobs"; do
  [[ $value =~ ^[1-9][0-9]{0,5}$ ]] || { echo "games.sh: '$value' is no whole number from 1 to 999999" >&2; exit 2; }
done
[[ $players =~ ^([1-9]|1[01])$ ]] || { echo "games.sh: PLAYERS='$players' is not 1 to 11" >&2; exit 2; }
[[ ${OTHER-} || $players == 11 ]] || { echo "games.sh: PLAYERS needs OTHER, the command that starts the other team" >&2; exit 2; }
[[ $server == simulator || $server == rcssserver3d ]] || { echo "games.sh: SERVER='$server' is neither simulator nor rcssserver3d" >&2; exit 2; }
[[ ${OTHER-} || $server == simulator ]] || { echo "games.sh: SERVER needs OTHER, the command that starts the other team" >&2; exit 2; }
[[ ! ${OUT-} || ! -e $out ]] || { echo "games.sh: OUT=$out exists already" >&2; exit 2; }
[[ $out == /* ]] || out=$PWD/$out
work=$out
rm -rf "$work"
mkdir -p "$work"

# The scripts of scripts/autoplay end their games and leave nothing behind if a signal ends them, so a signal goes on to
# the one that runs.
running=""
autoplay() { # script, its arguments
  scripts/autoplay/"$@" &
  running=$!
  wait "$running"
  running=""
}
passOn() { # $1: status
  trap '' INT TERM HUP
  if [[ $running ]]; then kill "$running" 2> /dev/null && wait "$running" || true; fi
  exit "$1"
}
trap 'passOn 130' INT
trap 'passOn 143' TERM HUP

# Games against the teams of $work/opponents as lines of games.tsv.
play() { # $1: how our team is started
  autoplay runOppList.sh --games "$games" --half-time "$half" --seed "$seed" --jobs "$jobs" --name Team --log "$work/games.log" \
    --players $((2 * players)) --server "$server" ${realtime:+--realtime} --output "$work/played" "$1" "$work/opponents"
  tests/bench/games/players.sh "$work/played"/*/
  awk -v played="$work/played" -v realtime="$realtime" -f tests/bench/games/tracks.awk "$work/games.log" > "$work/games.tsv"
}

if [[ ${OTHER-} ]]; then
  other=${OTHER//\{team\}/Other}
  other=${other//\{players\}/$players}
  if [[ $other != *'{'* ]]; then # a start script, which is called in its own folder
    first=${other%% *}
    [[ -x $first && -f $first ]] || { echo "games.sh: OTHER: no start script $first" >&2; exit 2; }
    other=$(realpath "$first")${other#"$first"}
  fi
  echo "$games games of 2 x $half s against OTHER, $players on each side, seeds from $seed, $jobs at once, server $server"
  echo "Other $other" > "$work/opponents"
  play "bin/start.sh --players $players"
  awk -v half="$half" -v players="$players" -v other="${OTHER_NAME-}" -v server="$server" -v realtime="$realtime" -v played="$(date -u +%F)" -v json="$out.json" -f tests/support/interval.awk -f tests/bench/games/table.awk "$work/games.tsv" > "$out.md"
  cat "$out.md"
  [[ ${OTHER_NAME-} ]] || exit 0
  peers=${out%/*}/games-peers
  piece=$peers/$(tr -cs 'A-Za-z0-9\n' - <<< "$OTHER_NAME")-$players
  [[ $server == simulator ]] || piece+=-$server
  [[ ! $realtime ]] || piece+=-realtime
  mkdir -p "$peers"
  mv "$out.md" "$piece.md"
  mv "$out.json" "$piece.json"
  cat "$peers"/*.md > "$peers.md"
  { echo "["; sed -s '1d; $d' "$peers"/*.json | sed 's/},*$/},/; $s/,$//'; echo "]"; } > "$peers.json"
  exit
fi

OUT=build/bench/starts tests/bench/games/starts.sh
echo "$games games of 2 x $half s, seeds from $seed, $jobs at once"
echo "Swarm bin/start.sh -- --modules $PWD/config/platforms/simspark/swarm.cfg" > "$work/opponents"
if [[ ${BEFORE-} ]]; then
  before=$(realpath "$BEFORE")
  [[ -x $before/bin/agent ]] || { echo "games.sh: BEFORE=$BEFORE: no bin/agent there" >&2; exit 2; }
  echo "Before $before/bin/start.sh --config $before/config --port {agent} --monitor {monitor} {host}" >> "$work/opponents"
fi
play bin/start.sh
awk -v half="$half" -v realtime="$realtime" -v json="$out.json" -f tests/support/interval.awk -f tests/bench/games/table.awk "$work/games.tsv" > "$out.md"
{ cat build/bench/starts.md && cat "$out.md"; } > "$work/games.md"
mv "$work/games.md" "$out.md"
{ sed '$d' "$out.json" | sed '$s/$/,/' && sed 1d build/bench/starts.json; } > "$work/games.json"
mv "$work/games.json" "$out.json"
cat "$out.md"
