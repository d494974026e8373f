#!/usr/bin/env bash
# What each motion does by the protocol of the thesis (Seekircher 2015, 3.1.1), on the league's physics and on Bullet, which
# none was searched on: build/bench/motion_tries.json and .md. TRIES of each [1000], seeds from FIRST on [1000000], of TYPES.
set -euo pipefail
tries=${TRIES-1000} first=${FIRST-1000000}
out=build/bench
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p "$out"
: > "$scratch/json"
printf '### Standing up\n\nUpright: after two seconds of walking right after the motion, within 30 degrees. Error: formula 3.1'"'"'s.\n' > "$scratch/stand"
printf '\n| type | motion | engine | time [ms] | upright [%%] | error [rad] |\n|---|---|---|---|---|---|\n' >> "$scratch/stand"
printf '\n### Kicks\n\nLow: the ball comes three metres or farther and is below a goal'"'"'s bar (0.8 m) between 3 and 8 m. Off: from the file'"'"'s own\nforward, without its mean direction taken out. Touched: from the motion'"'"'s begin.\n' > "$scratch/kicks"
printf '\n| type | motion | engine | distance [m] | direction [deg] | off [deg] | low [%%] | height [m] | touched [ms] | upright [%%] |\n|---|---|---|---|---|---|---|---|---|---|\n' >> "$scratch/kicks"

# Figures of `start` into the array figure; options of the task.
declare -A figure
measure() { # TASK OPTIONS
  printf 'task: %s\noptions: {%s}\n' "$1" "$2" > "$scratch/study.yaml"
  local words i
  read -ra words < <(bin/optserver "$scratch/study.yaml" --folder "$scratch/none" --measure "$tries" --first-seed "$first" 2> /dev/null)
  figure=()
  for ((i = 1; i + 3 < ${#words[@]} + 1; i += 4)); do figure[${words[i]}]=${words[i + 1]}; done
  [[ ${figure[cost]-} ]] || { echo "tries.sh: nothing measured of $2" >&2; exit 1; }
}
add() { # NAME VALUE UNIT BETTER
  printf '{"name": "motion.tries%s.%s", "value": %s, "unit": "%s", "better": "%s"}\n' "$tries" "$1" "$2" "$3" "$4" >> "$scratch/json"
}
percent() { awk -v x="$1" 'BEGIN { printf "%.1f", 100 * x }'; }
has() { [[ -f config/robots/simspark_type$1/motions/$2.yaml || -f config/motions/$2.yaml ]]; }

for type in ${TYPES-0 1 2 3 4}; do
  for engine in ode bullet; do
    for motion in standUpFront standUpFrontFast standUpBack standUpBackFast; do
      has "$type" "$motion" || continue
      direction=front
      [[ $motion == *Back* ]] && direction=back
      measure standUp "type: $type, direction: $direction, motion: $motion, engine: $engine"
      printf '| %s | %s | %s | %.0f | %s | %.1f |\n' "$type" "$motion" "$engine" "${figure[time]}" "$(percent "${figure[up]}")" "${figure[error]}" >> "$scratch/stand"
      add "type$type.$motion.$engine.time" "${figure[time]}" ms lower
      add "type$type.$motion.$engine.upright" "$(percent "${figure[up]}")" % higher
    done
    for motion in kickRight kickShot kickLong; do
      has "$type" "$motion" || continue
      measure kick "type: $type, motion: $motion, engine: $engine"
      printf '| %s | %s | %s | %.2f | %.1f | %.1f | %s | %.2f | %.0f | %s |\n' "$type" "$motion" "$engine" "${figure[distance]}" \
        "${figure[direction]}" "${figure[off]}" "$(percent "${figure[low]}")" "${figure[height]}" "${figure[contact]}" \
        "$(percent "${figure[up]}")" >> "$scratch/kicks"
      add "type$type.$motion.$engine.distance" "${figure[distance]}" m higher
      add "type$type.$motion.$engine.low" "$(percent "${figure[low]}")" % higher
      add "type$type.$motion.$engine.touched" "${figure[contact]}" ms lower
      add "type$type.$motion.$engine.upright" "$(percent "${figure[up]}")" % higher
    done
  done
done
{ printf '## By the protocol of the thesis, %s tries each, seeds from %s on\n\n' "$tries" "$first"; cat "$scratch/stand" "$scratch/kicks"; } > "$out/motion.md.new"
{ printf '[\n'; sed '$!s/$/,/' "$scratch/json"; printf ']\n'; } > "$out/motion_tries.json.new"
mv "$out/motion.md.new" "$out/motion.md"
mv "$out/motion_tries.json.new" "$out/motion_tries.json"
