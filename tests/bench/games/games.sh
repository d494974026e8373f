#!/usr/bin/env bash
# The team against the players of before it, who all go to the ball (config/platforms/simspark/swarm.cfg), in whole games on the
# embedded simulator; and how well a player knows the others, against the monitor's scene, in one more game. Settings by the
# environment: GAMES [10], HALF seconds [300], SEED of the first game [1], JOBS at once [cores], BEFORE, the folder of an earlier
# state that is built, to play against as well. Before the games one robot tries set starts (starts.sh). Writes build/bench/games.json and
# games.md; what the programs said stays in build/bench/games/. `make bench-games` builds what it needs and writes
# doc/results/games.md.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
games=${GAMES:-10} half=${HALF:-300} seed=${SEED:-1} jobs=${JOBS:-$(nproc)}
for value in "$games" "$half" "$seed" "$jobs"; do
  [[ $value =~ ^[1-9][0-9]{0,5}$ ]] || { echo "games.sh: '$value' is no whole number from 1 to 999999" >&2; exit 2; }
done
work=$PWD/build/bench/games
rm -rf "$work"
mkdir -p "$work"

# One player of each side writes what it believes: a configuration of its own that says where to.
cp -r config "$work/config"
echo "folder: $work/others" > "$work/config/OthersEvaluation.yaml"
cp config/platforms/simspark/modules.cfg "$work/config/platforms/simspark/modules.cfg"
echo "OthersEvaluation" >> "$work/config/platforms/simspark/modules.cfg"

tests/bench/games/starts.sh
echo "$games games of 2 x $half s, seeds from $seed, $jobs at once"
echo "Swarm bin/start.sh -- --modules $PWD/config/platforms/simspark/swarm.cfg" > "$work/opponents"
if [[ ${BEFORE-} ]]; then
  before=$(realpath "$BEFORE")
  [[ -x $before/bin/agent ]] || { echo "games.sh: BEFORE=$BEFORE: no bin/agent there" >&2; exit 2; }
  echo "Before $before/bin/start.sh --config $before/config --port {agent} --monitor {monitor} {host}" >> "$work/opponents"
fi
scripts/autoplay/runOppList.sh --games "$games" --half-time "$half" --seed "$seed" --jobs "$jobs" --name Team --log "$work/games.log" \
  --output "$work/played" bin/start.sh "$work/opponents"
scripts/autoplay/startGame.sh --half-time 60 --seed "$seed" --names Team,Swarm --log "$work/others.log" --output "$work/believed" \
  "bin/start.sh --config $work/config" "bin/start.sh -- --modules $PWD/config/platforms/simspark/swarm.cfg"
awk -v games="$work/games.log" -v played="$work/played" -f tests/bench/games/tracks.awk "$work/games.log" > "$work/games.tsv"
awk -v half="$half" -v json=build/bench/games.json -f tests/bench/games/table.awk "$work/games.tsv" > build/bench/games.md
awk -f tests/bench/games/believed.awk "$work/believed/track.csv" "$work"/others/left-*.csv >> build/bench/games.md
{ cat build/bench/starts.md && cat build/bench/games.md; } > "$work/games.md"
mv "$work/games.md" build/bench/games.md
{ sed '$d' build/bench/games.json | sed '$s/$/,/' && sed 1d build/bench/starts.json; } > "$work/games.json"
mv "$work/games.json" build/bench/games.json
cat build/bench/games.md
