#!/usr/bin/env bash
# CPU time of bin/gap diagnose on recordings of four robots that are hung up, made in Bullet: a NAO, the six-joint SO-101,
# twelve joints at 200 Hz and one joint at 1 kHz. Each has two causes that its model lacks. Writes
# build/bench/gap-speed.json and .md.
# Environment:
#   SEED   of the sensors' noise [1]
#   CASE   one case alone: nao, arm, legs or joint
# Recordings, answers and times of this seed stay in build/bench/gap-speed-SEED/; a case that is there is not repeated.
set -euo pipefail
seed=${SEED:-1}
kept=build/bench/gap-speed-$seed
mkdir -p "$kept"
# name|robot|target [s of CPU]|programs|effects; what is measured is in the page's table
cases="nao|nao_v5|180|hang_sweep hang_multisine hang_small hang_fast hang_sweep|{effect: coulomb_friction, at: LKneePitch, value: 0.2}
arm|so101|180|hang_sweep hang_multisine hang_small hang_fast|{effect: load_friction, at: Elbow, value: 0.3}
legs|tests/bench/gap-speed/four_legs.json|180|hang_sweep hang_multisine hang_small hang_fast|{effect: coulomb_friction, at: FL_thigh, value: 1.2}
joint|tests/bench/gap-speed/one_joint.json|60|hang_sweep hang_multisine hang_small hang_fast|{effect: coulomb_friction, at: hinge, value: 0.15}"
second() {
  case $1 in
    nao) echo "{effect: servo_gain, at: RShoulderRoll, value: 0.8}" ;;
    arm) echo "{effect: servo_gain, at: Pitch, value: 0.8}" ;;
    legs) echo "{effect: link_mass, at: RR_shank_link, value: 0.1}" ;;
    joint) echo "{effect: command_delay, at: hinge, value: 0.006}" ;;
  esac
}
field() { sed -n "s/.*\"$2\": *\([0-9.e+-]*\).*/\1/p" "$1" | sed -n 1p; }
# What one answer names, as EFFECT at PLACE VALUE, from its JSON on one line.
causes() {
  node -e 'const a = JSON.parse(require("fs").readFileSync(process.argv[1], "utf8"));
    console.log(a.verdict + ": " + (a.effects.map(e => `${e.effect} at ${e.at} ${Number(e.value).toPrecision(3)}`).join(", ") || "nothing"))' "$1"
}
record() { # NAME ROBOT PROGRAMS EFFECTS...
  local name=$1 robot=$2 programs=$3 number=0 program
  shift 3
  { echo "effects:"; printf '  - %s\n' "$@"; } > "$kept/$name.yaml"
  for program in $programs; do
    number=$((number + 1))
    bin/gap record --robot "$robot" --engine bullet --program "$program" --effects "$kept/$name.yaml" \
      --seed $((seed * 100 + number)) --force -o "$kept/$name/run$number" > /dev/null
  done
}
while IFS='|' read -r name robot target programs effect; do
  [[ ${CASE:-$name} == "$name" && ! -s $kept/$name.timing.json ]] || continue
  rm -rf "${kept:?}/$name"
  record "$name" "$robot" "$programs" "$effect" "$(second "$name")"
  bin/gap diagnose "$kept/$name" --robot "$robot" --json "$kept/$name.json" --timing "$kept/$name.timing.new" --jobs 1 < /dev/null
  mv "$kept/$name.timing.new" "$kept/$name.timing.json"
done <<< "$cases"
{
  echo "CPU time of \`bin/gap diagnose\` by its default method on recordings made in Bullet, seed $seed. The targets are the project's."
  echo
  echo "| case | robot | runs | recorded, s | cycles a second | in the robot | answer | CPU, s | target, s |"
  echo "|---|---|---|---|---|---|---|---|---|"
} > build/bench/gap-speed.md
figures=()
while IFS='|' read -r name robot target programs effect; do
  [[ -s $kept/$name.timing.json ]] || continue
  cpu=$(field "$kept/$name.timing.json" cpu_seconds)
  recorded=0 rate=0
  for run in "$kept/$name"/run*; do
    read -r cycles last < <(zcat -f "$run"/run.csv* | awk -F, 'END { print NR - 1, $1 }')
    recorded=$(awk -v a="$recorded" -v b="$last" 'BEGIN { printf "%.1f", a + b }')
    rate=$(awk -v n="$cycles" -v t="$last" 'BEGIN { printf "%.0f", (n - 1) / t }')
  done
  robot=${robot##*/}
  echo "| $name | ${robot%.json} | $(wc -w <<< "$programs") | $recorded | $rate | $(sed -n 's/^  - {effect: \(.*\)}$/\1/p' "$kept/$name.yaml" | sed 's/, at:/ at/; s/, value://' | paste -sd';' | sed 's/;/, /') | $(causes "$kept/$name.json") | $cpu | $target |" >> build/bench/gap-speed.md
  figures+=("{\"name\": \"gap-speed.$name.seed$seed\", \"value\": $cpu, \"unit\": \"s of CPU\", \"better\": \"lower\", \"target\": $target}")
done <<< "$cases"
{ echo "["; printf '%s\n' "${figures[@]}" | sed '$!s/$/,/'; echo "]"; } > build/bench/gap-speed.json
cat build/bench/gap-speed.md
