#!/usr/bin/env bash
# How the players of games that were played ended and what they cost: writes players.tsv into each game's folder. A line for each
# player that bin/start.sh has started: side, number, exit status, whether it ended before the game did. Then: cycles late by their CPU,
# CPU per cycle, mean and 99th percentile [us], and cycles late by the clock, with all that held them up. A dash: nothing is known, as of a player that is not ours or did not end.
#   players.sh FOLDER...     folders of scripts/autoplay/startGame.sh
set -euo pipefail
value() { sed -n 's/^ *"'"$2"'": *\([0-9.e+-]*\),\{0,1\}$/\1/p' "$1" 2> /dev/null || true; }
for game in "$@"; do
  for side in left right; do
    for started in "$game/$side"/pid*; do
      [[ -f $started ]] || continue
      number=${started##*/pid} folder=${started%/*} status=- early=0
      if [[ -s $folder/exit$number ]]; then
        status=$(< "$folder/exit$number")
        # The track is written until the game is over, and the players end after it.
        [[ ! $folder/exit$number -ot $game/track.csv ]] || early=1
      fi
      line=$side$'\t'$number$'\t'$status$'\t'$early
      for key in late_cycles_cpu cpu_us_per_cycle cpu_us_p99 late_cycles; do
        found=$(value "$folder/stats$number.json" $key)
        line+=$'\t'${found:--}
      done
      echo "$line"
    done
  done > "$game/players.tsv"
done
