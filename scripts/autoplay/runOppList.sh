#!/usr/bin/env bash
# Plays games against each opponent of a list, several at once, without a person (thesis A.5).
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/autoplay.bash"
games=10 jobs="" seed=1 log=games.log folder="" sides=alternate name=Plumbline handed=() plain=()

usage() {
  cat << END
usage: runOppList.sh [options] OWN LIST [-- OPTIONS OF THE SERVER]
  OWN            how our team is started, as for startGame.sh
  LIST           file with a line for each opponent: NAME COMMAND; # begins a comment
  --games N      against each opponent [10]
  --jobs N       games at once [number of cores: $(nproc)]
  --sides WHICH  ours: left, right, or alternate [alternate]
  --name NAME    of our team [$name]
  --seed N       of the first game; the next ones have the next [1]
  --log FILE     [games.log]
  --output FOLDER  what the programs said, a folder for each game [build/games/DATE-PROCESS]
  --server, --half-time, --players, --patience, --hang, --limit, --network VALUE, --realtime: as for startGame.sh
example:
  echo "Old ../old/bin/start.sh" > opponents; scripts/autoplay/runOppList.sh --games 20 bin/start.sh opponents
Ctrl-C ends all games. Exit status: 0 all games are over; 1 some came to no end; 2 bad options; 130 interrupted.
END
}

while (($#)); do
  case $1 in
    -h | --help) usage; exit 0 ;;
    --) break ;;
    --realtime) handed+=("$1"); shift ;;
    --server | --half-time | --players | --patience | --hang | --limit | --network) needsValue "$1" $#; handed+=("$1" "$2"); shift 2 ;;
    --games | --jobs | --sides | --name | --seed | --log | --output)
      needsValue "$1" $#
      case $1 in
        --games) games=$2 ;;
        --jobs) jobs=$2 ;;
        --sides) sides=$2 ;;
        --name) name=$2 ;;
        --seed) seed=$2 ;;
        --log) log=$2 ;;
        --output) folder=$2 ;;
      esac
      shift 2 ;;
    -*) fail "unknown option $1; see $self --help" ;;
    *) plain+=("$1"); shift ;;
  esac
done
serverOptions=("$@") # with the -- before them
((${#plain[@]} == 2)) || fail "our team and a list are wanted; see $self --help"
own=${plain[0]} list=${plain[1]}
[[ $jobs ]] || jobs=$(nproc)
for value in "$games" "$jobs" "$seed"; do isWhole "$value" && ((value > 0)) || fail "'$value' is no whole number from 1"; done
[[ $sides == alternate || $sides == left || $sides == right ]] || fail "--sides '$sides': left, right or alternate"
[[ $name != *,* ]] || fail "--name '$name' has a comma"
[[ -f $list ]] || fail "no list $list"
names=() commands=()
lineNumber=0
while read -r opponent command; do
  lineNumber=$((lineNumber + 1))
  [[ ! $opponent || $opponent == '#'* ]] && continue
  [[ $command ]] || fail "$list:$lineNumber: NAME COMMAND is wanted, there is only '$opponent'"
  [[ $opponent != *,* && $opponent != "$name" ]] || fail "$list:$lineNumber: name '$opponent': another one, without a comma"
  names+=("$opponent") commands+=("$command")
done < <(cat "$list"; echo)
((${#names[@]})) || fail "$list: no opponent"
[[ $folder ]] || folder=$root/build/games/$(date +%Y%m%d-%H%M%S)-$$
mkdir -p "$folder" || fail "cannot make $folder"

running=()
leave() {
  local status=$?
  trap - EXIT
  trap '' INT TERM HUP
  # Each game puts its own things away.
  if ((${#running[@]})); then
    echo "$self: ending ${#running[@]} games" >&2
    kill -TERM "${running[@]}" 2> /dev/null || true
    wait "${running[@]}" 2> /dev/null || true
  fi
  exit $status
}
trap leave EXIT
trap 'exit 130' INT TERM HUP

total=$((games * ${#names[@]})) done=0 bad=0 begin=$SECONDS
declare -A gameOf=()

startOne() { # $1: which game, from 0
  local index=$(($1 % ${#names[@]})) round=$(($1 / ${#names[@]})) left right
  local opponent=${names[index]} command=${commands[index]} which=$sides
  if [[ $which == alternate ]]; then if ((round % 2)); then which=right; else which=left; fi; fi
  if [[ $which == left ]]; then left=$own right=$command both=$name,$opponent; else left=$command right=$own both=$opponent,$name; fi
  "${BASH_SOURCE[0]%/*}/startGame.sh" "${handed[@]}" --seed $((seed + $1)) --log "$log" --output "$folder/$(($1 + 1))" --names "$both" \
    "$left" "$right" "${serverOptions[@]}" > "$folder/$(($1 + 1)).log" 2>&1 < /dev/null &
  gameOf[$!]=$(($1 + 1))
  running+=($!)
}

# What is said when a game has ended.
report() { # $1: game, $2: status
  local file=$folder/$1.log left
  done=$((done + 1))
  left=$(((total - done) * (SECONDS - begin) / done))
  if (($2 == 0)); then
    tail -1 "$file" | awk -F, -v head="[$done/$total]" -v rest="$((left / 60)) min $((left % 60)) s to go" '{
      printf "%s %s %d : %d %s   falls %d : %d   kicks %d : %d   seed %d   %.0f s   %s\n", head, $3, $7, $8, $4, $9, $10, $11, $12, $5, $16, rest }'
  else
    bad=$((bad + 1))
    echo "[$done/$total] game $1 came to no end: $(tail -1 "$file")"
    (($2 != 2)) || exit 2 # nothing will get better by trying again
  fi
}

next=0
while ((done < total)); do
  if ((next < total && ${#running[@]} < jobs)); then
    startOne $next
    next=$((next + 1))
    continue
  fi
  status=0 ended=""
  wait -n -p ended "${running[@]}" || status=$?
  [[ $ended ]] || continue
  remaining=()
  for process in "${running[@]}"; do [[ $process == "$ended" ]] || remaining+=("$process"); done
  running=("${remaining[@]}")
  report "${gameOf[$ended]}" $status
done
echo "$total games in $((SECONDS - begin)) s, $bad without an end; $log"
((bad == 0))
