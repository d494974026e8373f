#!/usr/bin/env bash
# What path planning saves: the same games with and without the module PathPlanning, whose ways are straight then. The team plays
# against players without teamwork (config/platforms/simspark/swarm.cfg). Fouls of touching and charging, mates nearer than 0.4 m
# and falls, of a player in a minute. Settings by the environment: GAMES [6], HALF seconds [100], SEED of the first game [1],
# JOBS at once [1], BIN, the folder of programs [bin], CONFIG, the agent's configuration [config], OUT [build/bench/collisions]. Writes
# OUT.json and OUT.md.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
games=${GAMES:-6} half=${HALF:-100} seed=${SEED:-1} jobs=${JOBS:-1} bin=$(realpath "${BIN:-bin}") config=${CONFIG:-config} out=${OUT:-build/bench/collisions}
for value in "$games" "$half" "$seed" "$jobs"; do
  [[ $value =~ ^[1-9][0-9]{0,5}$ ]] || { echo "collisions.sh: '$value' is no whole number from 1 to 999999" >&2; exit 2; }
done
mkdir -p "$(dirname "$out")"
out=$(realpath -m "$out")
rm -rf "$out"
mkdir -p "$out/straight"
# A folder of configuration like this one, but without the planner.
cp -r "$config" "$out/straight/config"
planner=$out/straight/config/modules/behavior.cfg
grep -q '^PathPlanning' "$planner" || { echo "collisions.sh: $config/modules/behavior.cfg has no line PathPlanning" >&2; exit 2; }
sed -i '/^PathPlanning/d' "$planner"

running=""
trap 'if [[ $running ]]; then kill "$running" 2> /dev/null && wait "$running" || true; fi; exit 130' INT
trap 'if [[ $running ]]; then kill "$running" 2> /dev/null && wait "$running" || true; fi; exit 143' TERM HUP
: > "$out/games.tsv"
for ways in Planned Straight; do
  folder=$(realpath "$config")
  [[ $ways == Planned ]] || folder=$out/straight/config
  echo "Swarm $bin/start.sh --port {agent} --monitor {monitor} {host} -- --modules $PWD/config/platforms/simspark/swarm.cfg" > "$out/opponents"
  # A busy machine takes minutes to start 22 players.
  scripts/autoplay/runOppList.sh --hang 600 --patience 600 --games "$games" --half-time "$half" --seed "$seed" --jobs "$jobs" --name $ways --log "$out/$ways.log" \
    --output "$out/$ways" "$bin/start.sh --config $folder --port {agent} --monitor {monitor} {host}" "$out/opponents" &
  running=$!
  wait $running
  running=""
  awk -v played="$out/$ways" -f tests/bench/games/tracks.awk "$out/$ways.log" | grep "^$ways" >> "$out/games.tsv"
done
awk -F'\t' -v half="$half" -v seed="$seed" -v games="$games" -v json="$out.json" "$(< tests/support/interval.awk)"'
  { ++n[$1]; minutes = 11 * 2 * half / 60
    value[1] = ($11 + $12) / minutes; value[2] = $11 / minutes; value[3] = $12 / minutes; value[4] = $7; value[5] = $4 / minutes
    for (i = 1; i <= 5; ++i) { sum[$1, i] += value[i]; squares[$1, i] += value[i] ^ 2 } }
  function mean(ways, i) { return n[ways] ? sum[ways, i] / n[ways] : 0 }
  function cell(ways, i) { return sprintf("%.2f ± %.2f", mean(ways, i), half95(sum[ways, i], squares[ways, i], n[ways])) }
  END {
    split("fouls of touching and charging|touching|charging|mates nearer than 0.4 m, seen twice a second|falls", title, "|")
    split("fouls touching charging mates_close falls", name, " ")
    printf "%d games of 2 x %d s against players without teamwork, eleven on each side, seeds from %d: with path planning, and with straight ways.\n", games, half, seed
    print "Of a player in a minute: means of a game with their 95 % intervals.\n\n| | planned ways | straight ways |\n|---|---|---|"
    for (i = 1; i <= 5; ++i) printf "| %s | %s | %s |\n", title[i], cell("Planned", i), cell("Straight", i)
    print "\nA player is called for touching if three or more touch each other, for charging if it runs into an opponent. The referee then puts it elsewhere."
    printf "[" > json
    for (i = 1; i <= 5; ++i) for (k = 1; k <= 2; ++k)
      printf "%s\n  {\"name\": \"collisions.%s.%s\", \"value\": %.4g, \"unit\": \"1/min\", \"better\": \"lower\"}", (i + k > 2 ? "," : ""), (k == 1 ? "planned" : "straight"), name[i], mean(k == 1 ? "Planned" : "Straight", i) > json
    print "\n]" > json
  }' "$out/games.tsv" > "$out.md"
cat "$out.md"
