# What getAvgSteps.sh and getAvgForEachOpp.sh share. shellcheck shell=bash
# They set: step, games in a row of the table (0: one row for each opponent); stepHelp, the help's line about it.
source "$(dirname "${BASH_SOURCE[0]}")/autoplay.bash"
team="" logs=()

usage() {
  echo "usage: $self [options] [LOG]...       [games.log]"
  echo "  --team NAME   ours [the one that is in all games]"
  [[ $stepHelp ]] && echo "$stepHelp"
  cat << END
Goals, falls and kicks of both teams: mean of a game and its 95 % confidence interval (Student's t). Games that came
to no end are not counted and named below. Exit status: 0; 2 for bad options or logs, or without a game.
example:
  scripts/autoplay/$self --team Plumbline games.log
END
}

# Reads the options and prints the table.
showAverages() {
  local file
  while (($#)); do
    case $1 in
      -h | --help) usage; exit 0 ;;
      --team) needsValue "$1" $#; team=$2; shift 2 ;;
      --step) [[ $stepHelp ]] || fail "unknown option $1; see $self --help"; needsValue "$1" $#; step=$2; shift 2 ;;
      -*) fail "unknown option $1; see $self --help" ;;
      *) logs+=("$1"); shift ;;
    esac
  done
  [[ ! $stepHelp ]] || { isWhole "$step" && ((step > 0)); } || fail "--step '$step' is no number of games"
  ((${#logs[@]})) || logs=(games.log)
  for file in "${logs[@]}"; do [[ -f $file && -r $file ]] || fail "cannot read $file"; done
  awk -v team="$team" -v step="$step" -f "$root/scripts/autoplay/averages.awk" "${logs[@]}" 2> >(sed "s/^/$self: /" >&2)
}
