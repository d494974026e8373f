#!/usr/bin/env bash
# Shots at a keeper: of how many does it keep the ball out, with dives and without? Number 1 stands in the middle of its goal, the
# ball is shot from 2.5 to 5.5 m away at any place between the posts, half of the shots along the ground. Settings by the
# environment: SHOTS [100], SEED of the first [3001], TYPES of the keeper [0 4], BIN [bin], CONFIG [config], OUT
# [build/bench/saves]. Writes OUT.json and OUT.md.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
shots=${SHOTS:-100} seed=${SEED:-3001} types=${TYPES:-0 4} bin=$(realpath "${BIN:-bin}") config=${CONFIG:-config} out=${OUT:-build/bench/saves}
for value in "$shots" "$seed"; do
  [[ $value =~ ^[1-9][0-9]{0,5}$ ]] || { echo "saves.sh: '$value' is no whole number from 1 to 999999" >&2; exit 2; }
done
mkdir -p "$(dirname "$out")"
work=$(mktemp -d)
finish() { kill $(jobs -p) 2> /dev/null || true; wait 2> /dev/null || true; rm -rf "$work"; }
trap finish EXIT

play() { # seed, type, dives: prints the x to which the ball came [m]
  read -r x y vx vy vz < <(awk -v seed="$1" 'BEGIN {
    srand(seed); for (k = 0; k < 5; ++k) rand()
    d = 2.5 + 3 * rand(); y = 2 * rand() - 1; aim = 1.9 * rand() - 0.95
    v = 1.4 * (1 + 2 * rand() + (d + 0.6) / 0.92); vz = rand() < 0.5 ? 0 : 2.5 * rand()
    l = sqrt((d + 0.6) ^ 2 + (aim - y) ^ 2)
    printf "%.3f %.3f %.3f %.3f %.3f\n", -14.4 + d, y, -v * (d + 0.6) / l, v * (aim - y) / l, vz }')
  printf 'moves: {startAnywhere: true}\nstartPlace: {on: true, x: %s, y: %s, speedX: %s, speedY: %s, speedZ: %s, robotX: -14.4, robotY: 0}\n' \
    "$x" "$y" "$vx" "$vy" "$vz" > "$work/rules.yaml"
  rm -rf "$work/config" "$work/ports.json" "$work/track.csv"
  cp -r "$config" "$work/config"
  printf 'dives: %s\n' "$3" > "$work/config/Goalie.yaml"
  timeout 60 "$bin/simulator" --port 0 --monitor-port 0 --ports-file "$work/ports.json" --wait-agents 2 --kickoff-after 3 --max-seconds 6 \
    --sync --seed "$1" --rules "$work/rules.yaml" --die-with-parent > "$work/simulator.log" 2>&1 &
  local simulator=$! agent monitor rest number
  until [[ -s $work/ports.json ]]; do kill -0 $simulator || { tail -1 "$work/simulator.log" >&2; exit 1; }; sleep 0.02; done
  read -r agent monitor rest < <(tr -cs '0-9\n' ' ' < "$work/ports.json")
  "$bin/watchgame" --no-kickoff --port "$monitor" --players 2 --track "$work/track.csv" > /dev/null 2>&1 &
  for number in 1 2; do
    "$bin/agent" --config "$work/config" --team Keepers --number $number --type "$2" --port "$agent" --monitor-port "$monitor" > /dev/null 2>&1 &
    sleep 0.05
  done
  wait $simulator || true
  sleep 0.1
  kill $(jobs -p) 2> /dev/null || true
  wait 2> /dev/null || true
  awk -F, '$2 == "ball" { x = $4 } END { print x }' "$work/track.csv"
}

for type in $types; do
  for dives in true false; do
    for ((i = 0; i < shots; ++i)); do
      x=$(play $((seed + i)) "$type" $dives)
      [[ $x ]] || { echo "saves.sh: the shot of seed $((seed + i)) at type $type was not played: $(tail -1 "$work/simulator.log")" >&2; exit 1; }
      echo "$type $dives $x" >> "$work/shots"
      if ((i % 20 == 19)); then echo "type $type, dives $dives: $((i + 1)) of $shots shots"; fi
    done
  done
done
awk -v shots="$shots" -v seed="$seed" -v json="$out.json" "$(< tests/support/interval.awk)"'
  { ++n[$1, $2]; kept[$1, $2] += $3 > -15; if (!($1 in seen)) { seen[$1]; type[++types] = $1 } }
  END {
    printf "%d shots at a keeper of each type, seeds from %d: 2.5 to 5.5 m away, at any place between the posts, half of them along the\n", shots, seed
    print "ground. Shares of balls that it keeps out, with 95 % intervals (Wilson).\n"
    print "| type | with dives | without |\n|---|---|---|"
    printf "[" > json
    for (i = 1; i <= types; ++i) {
      t = type[i]
      printf "| %s | %s | %s |\n", t, interval(kept[t, "true"], n[t, "true"]), interval(kept[t, "false"], n[t, "false"])
      printf "%s\n  {\"name\": \"saves.type%s\", \"value\": %.4g, \"unit\": \"%%\", \"better\": \"higher\"},\n  {\"name\": \"saves.type%s.without_dives\", \"value\": %.4g, \"unit\": \"%%\", \"better\": \"higher\"}",
        (i > 1 ? "," : ""), t, 100 * kept[t, "true"] / n[t, "true"], t, 100 * kept[t, "false"] / n[t, "false"] > json
    }
    print "\n]" > json
  }' "$work/shots" > "$out.md"
cat "$out.md"
