#!/usr/bin/env bash
# One command for a match: the embedded simulator, two teams of our robots, the kick-off, and a page to watch it on.
set -uo pipefail
bin=$(cd "$(dirname "${BASH_SOURCE[0]}")/../bin" && pwd)
left=11 right=11 leftName=Plumbline rightName=Line seconds="" page=8080 record="" seed=0 field=() agent=()
# As in bin/start.sh: at most 7 of a type, 9 of any two, three types in a full team.
types=(4 1 1 3 1 3 1 1 1 1 4)
terminal="" draw="" decisions=""
[[ -t 1 ]] && terminal=1

usage() {
  cat << END
usage: make match ARGS="[options]", or scripts/match.sh [options] [-- OPTIONS OF bin/simulator]
  --left N, --right N   robots of a team, 0 to 11 [$left, $right]
  --left-name NAME, --right-name NAME   [$leftName, $rightName]
  --seconds N           ends after so many seconds of play [in a terminal: until Ctrl-C; else 60]
  --page N              port of the page, 0: a free one [$page, or a free one if it is in use]; --no-page: none
  --record FILE         writes the match to a file; bin/webmonitor --replay FILE shows it
  --draw NAMES          shows drawings of all robots on the page: groups as team,belief, or what bin/agent --draw takes
  --decisions FOLDER    the strikers' decisions, for bin/webmonitor --summary FILE --decisions FOLDER
  --fast                as fast as it goes instead of in real time [so without a terminal]
  --realtime            in real time without a terminal, too
  --field FILE          sizes of the field for simulator and robots, as config/field.yaml
  --seed N              of the simulator; 0: by chance [$seed]
Ctrl-C ends simulator and robots.
Examples:
  make match
  make match ARGS="--left 3 --right 3 --seconds 120 --record match.plm"
  make match ARGS="--draw team,belief"
  make match ARGS="--seconds 300 --record match.plm --decisions decisions"
END
}
fail() { echo "match.sh: $*; see match.sh --help" >&2; exit 2; }
count() { [[ $2 =~ ^[0-9]{1,6}$ ]] && ((10#$2 <= $3)) || fail "$1 '$2' is not 0 to $3"; }

fast=""
[[ $terminal ]] || fast=1
anyPage=1
while (($#)); do
  case $1 in
    -h | --help) usage; exit 0 ;;
    --) shift; break ;;
    --fast) fast=1; shift ;;
    --realtime) fast=""; shift ;;
    --no-page) page=""; shift ;;
    --left | --right | --left-name | --right-name | --seconds | --page | --record | --draw | --decisions | --field | --seed)
      (($# > 1)) || fail "$1 needs a value"
      case $1 in
        --left) count "$1" "$2" 11; left=$2 ;;
        --right) count "$1" "$2" 11; right=$2 ;;
        --left-name) leftName=$2 ;;
        --right-name) rightName=$2 ;;
        --seconds) count "$1" "$2" 100000; seconds=$2 ;;
        --page) count "$1" "$2" 65535; page=$2 anyPage="" ;;
        --record) record=$2 ;;
        --draw) agent+=(--draw "$2") draw=1 ;;
        --decisions) agent+=(--decisions "$2") decisions=$2 ;;
        --field) [[ -r $2 ]] || fail "--field $2 cannot be read"; field=(--field "$2") ;;
        --seed) count "$1" "$2" 999999; seed=$2 ;;
      esac
      shift 2 ;;
    *) fail "unknown option $1" ;;
  esac
done
for name in "$leftName" "$rightName"; do
  [[ $name =~ ^[^[:space:]\(\)]+$ ]] || fail "team '$name' has blanks or parentheses"
done
[[ $leftName != "$rightName" ]] || fail "both teams are called $leftName"
((left + right)) || fail "nobody is to play"
[[ $record && ! $page ]] && fail "--record records what the page shows: not with --no-page"
[[ $record && -e $record ]] && fail "$record exists already"
[[ $draw && ! $page ]] && fail "--draw shows on the page: not with --no-page"
# The names of the files are those of sides and numbers: an older match's would be taken for this one's.
[[ $decisions ]] && compgen -G "$decisions/*.csv" > /dev/null && fail "$decisions holds decisions already"
for program in simulator agent watchgame; do [[ -x $bin/$program ]] || fail "no $bin/$program: make SimRelease builds it"; done
# A wrong name is said before anything starts.
((${#agent[@]} == 0)) || wrong=$("$bin/agent" "${agent[@]}" --parameters 2>&1 > /dev/null) || { wrong=${wrong#agent: }; fail "${wrong%; see agent --help}"; }
if [[ ! $seconds && ! $terminal ]]; then seconds=60; fi

scratch=$(mktemp -d) || exit 2
children=()
# All get the signal at once; who has not gone half a second later is ended.
finish() {
  trap '' INT TERM HUP
  local child i
  ((${#children[@]})) && kill -TERM "${children[@]}" 2> /dev/null
  for ((i = 0; i < 25; ++i)); do
    for child in "${children[@]}"; do kill -0 "$child" 2> /dev/null && { sleep 0.02; continue 2; }; done
    break
  done
  ((${#children[@]})) && kill -KILL "${children[@]}" 2> /dev/null
  wait 2> /dev/null
  rm -rf "$scratch"
}
trap finish EXIT
trap 'echo; exit 130' INT
trap 'exit 143' TERM HUP

kickOff=3 # seconds for the robots to come to rest
options=(--port 0 --monitor-port 0 --ports-file "$scratch/ports.json" --wait-agents $((left + right)) --kickoff-after "$kickOff"
  --die-with-parent --seed "$seed" "${field[@]}")
if [[ $page && $anyPage ]]; then options+=(--web); elif [[ $page ]]; then options+=(--web "$page"); fi
[[ $record ]] && options+=(--record "$record")
[[ $draw ]] && options+=(--drawing-port 0)
[[ $seconds ]] && options+=(--max-seconds $((seconds + kickOff)))
if [[ $fast ]]; then options+=(--sync); else options+=(--realtime); fi
"$bin/simulator" "${options[@]}" "$@" > "$scratch/simulator.log" 2>&1 < /dev/null &
simulator=$!
children+=("$simulator")
trouble() { echo "match.sh: the simulator ended: $(tail -n 1 "$scratch/simulator.log" | sed 's/^simulator: //')" >&2; exit 2; }
until [[ -s $scratch/ports.json ]]; do kill -0 $simulator 2> /dev/null || trouble; sleep 0.05; done
grep 'watch at' "$scratch/simulator.log" | sed 's/^simulator: //'
[[ $draw ]] && agent+=(--drawing-port "$(sed -n 's/^simulator: drawings on UDP port //p' "$scratch/simulator.log")")
read -r agentPort monitorPort _ < <(tr -cs '0-9\n' ' ' < "$scratch/ports.json")

# One after the other, so that the server gives them their places in this order.
start() { # team, number
  "$bin/agent" --team "$1" --number "$2" --type "${types[$2 - 1]}" --host 127.0.0.1 --port "$agentPort" \
    --monitor-port "$monitorPort" "${field[@]}" "${agent[@]}" > "$scratch/$1-$2.log" 2>&1 < /dev/null &
  children+=($!)
  sleep 0.1
}
echo "$leftName ($left) against $rightName ($right)${seconds:+, $seconds s}"
for ((number = 1; number <= left; ++number)); do start "$leftName" $number; done
for ((number = 1; number <= right; ++number)); do start "$rightName" $number; done
# Tells the play. It ends with the server, which it would call an error; a paused game may stand for ever.
"$bin/watchgame" --no-kickoff --events --port "$monitorPort" --players $((left + right)) --hang 1000000 2> /dev/null < /dev/null &
watcher=$!
children+=("$watcher")
echo "all robots are on their way to the field; kick-off $kickOff s after the last has come${terminal:+; Ctrl-C ends}"

status=0
wait $simulator || status=$?
((status == 0)) || trouble
wait "$watcher"
if [[ $record ]]; then echo "bin/webmonitor --replay $record shows it again"; fi
if [[ $record && $decisions ]]; then echo "bin/webmonitor --summary $record --decisions $decisions makes a page of it"; fi
exit 0
