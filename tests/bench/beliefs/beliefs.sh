#!/usr/bin/env bash
# What players believe of ball and others in games of the team against players without teamwork (config/platforms/simspark/swarm.cfg):
# errors by distance, alone and with mates' words. Settings by the environment: GAMES [5], HALF seconds [60], SEED of the first game
# [1], PLAYERS on each side [11], OUT, what the results' files are called [build/bench/beliefs]. Writes OUT.json and OUT.md; tracks
# and estimates stay in the folder OUT. `make bench-beliefs` builds what it needs and writes doc/results/beliefs.md.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
games=${GAMES:-5} half=${HALF:-60} seed=${SEED:-1} players=${PLAYERS:-11} out=${OUT:-build/bench/beliefs}
for value in "$games" "$half" "$seed"; do
  [[ $value =~ ^[1-9][0-9]{0,5}$ ]] || { echo "beliefs.sh: '$value' is no whole number from 1 to 999999" >&2; exit 2; }
done
[[ $players =~ ^([2-9]|1[01])$ ]] || { echo "beliefs.sh: PLAYERS='$players' is not 2 to 11" >&2; exit 2; }
[[ $out == /* ]] || out=$PWD/$out
rm -rf "$out"
mkdir -p "$out"
# The left team writes what it believes: a configuration of its own that says where to.
cp -r config "$out/config"
echo "OthersEvaluation" >> "$out/config/platforms/simspark/modules.cfg"
for ((game = 1; game <= games; ++game)); do
  echo "folder: $out/$game/others" > "$out/config/OthersEvaluation.yaml"
  scripts/autoplay/startGame.sh --half-time "$half" --seed $((seed + game - 1)) --players $((2 * players)) --names Team,Swarm --log "$out/games.log" --hang 300 \
    --output "$out/$game" "bin/start.sh --config $out/config --players $players" \
    "bin/start.sh --players $players -- --modules $PWD/config/platforms/simspark/swarm.cfg"
  awk -f tests/bench/beliefs/errors.awk "$out/$game/track.csv" "$out/$game"/others/left-*.csv >> "$out/errors.tsv"
done
awk -v half="$half" -v games="$games" -v seed="$seed" -v players="$players" -v json="$out.json" -f tests/support/interval.awk -f tests/bench/beliefs/table.awk "$out/errors.tsv" > "$out.md"
cat "$out.md"
