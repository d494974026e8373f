#!/usr/bin/env bash
# Reads games.log and shows the average game of each ten games, or so many, in their order: whether a team gets
# better (thesis A.5).
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/autoplay.bash"
team="" step=10 logs=()
usage() {
  cat << END
usage: getAvgSteps.sh [options] [LOG]...       [games.log]
  --team NAME   ours [the one that is in all games]
  --step N      games in a row of the table [10]
Goals, falls and kicks of both teams: mean of a game and its 95 % confidence interval (Student's t). Games that came
to no end are not counted and named below. Exit status: 0; 2 for bad options or logs, or without a game.
END
}
while (($#)); do
  case $1 in
    -h | --help) usage; exit 0 ;;
    --team) needsValue "$1" $#; team=$2; shift 2 ;;
    --step) needsValue "$1" $#; step=$2; shift 2 ;;
    -*) fail "unknown option $1; see $self --help" ;;
    *) logs+=("$1"); shift ;;
  esac
done
isWhole "$step" && ((step > 0)) || fail "--step '$step' is no number of games"
((${#logs[@]})) || logs=(games.log)
for file in "${logs[@]}"; do [[ -f $file && -r $file ]] || fail "cannot read $file"; done
awk -v team="$team" -v step="$step" -f "$(dirname "${BASH_SOURCE[0]}")/averages.awk" "${logs[@]}" 2> >(sed "s/^/$self: /" >&2)
