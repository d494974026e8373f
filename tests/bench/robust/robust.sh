#!/usr/bin/env bash
# What draws are worth to a motion: two searches with the same seed and as many runs, one in the nominal world alone, one over drawn
# robots. They begin with a motion of begin/, which a robot type had before such searches. Then both motions are tried in the nominal
# world, on Bullet, which no search has seen, and on drawn robots that were in no search. Writes build/bench/robust.json and .md.
# A search that was stopped goes on; one that is complete is not done again as long as its folder
# build/bench/robust/SUBJECT-with-SEED is there.
# Variables: SUBJECTS [standUp kick], SEEDS [1 2], TRIES of each motion in each world [500], FIRST seed of them [5000000],
# JOBS searches or motions at once [1], each search with WORKERS [2].
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
subjects=${SUBJECTS-standUp kick} seeds=${SEEDS-1 2} tries=${TRIES-500} first=${FIRST-5000000}
jobs=${JOBS-1} workers=${WORKERS-2} out=build/bench/robust
effects=config/optimisation/unlike.yaml
mkdir -p "$out"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
begin=tests/bench/robust/begin
cp -r config "$scratch/config"

# Of each subject: the motion, options of its task, what only draws and drawn robots have, the search.
declare -A task=([standUp]=standUp [kick]=kick) type=([standUp]=1 [kick]=4) motion=([standUp]=standUpBackFast [kick]=kickLong)
declare -A options=([standUp]="direction: back, start: fall, still: 0.5, weight: 0.03" [kick]="steady: 3, walk: 2, weight: 0.03")
declare -A nominal=([standUp]="" [kick]=", spread: 0.015")
declare -A unlike=([standUp]=", effects: $effects" [kick]=", effects: $effects, spread: 0.025")
declare -A population=([standUp]=16 [kick]=20) runs=([standUp]=12 [kick]=8) generations=([standUp]=25 [kick]=30) # the better half runs twice as often
declare -A searched=([standUp]="sigma: 0.5" [kick]=$'sigma: 0.3\nparameters: {ballX: {min: 158}}')
drawsOfSearch=16 drawsTried="draws: 40, firstDraw: 1000"
for subject in $subjects; do cp "$begin/${motion[$subject]}.yaml" "$scratch/config/robots/simspark_type${type[$subject]}/motions/"; done

study() { # SUBJECT, MOTION, what is different from the nominal world
  printf 'task: %s\noptions: {type: %s, motion: %s, %s%s}\n' "${task[$1]}" "${type[$1]}" "$2" "${options[$1]}" "$3"
}
search() { # SUBJECT, with or without, SEED
  local folder=$out/$1-$2-$3 worlds=${nominal[$1]}
  [[ $2 == without ]] || worlds="${unlike[$1]}, draws: $drawsOfSearch"
  mkdir -p "$folder"
  { study "$1" "${motion[$1]}" "$worlds"
    printf 'optimizer: cmaes\nahead: 1\nseed: %s\npopulation: %s\nruns: %s\nrunsOfBest: %s\ngenerations: %s\n%s\n' "$3" "${population[$1]}" "${runs[$1]}" \
      $((2 * runs[$1])) "${generations[$1]}" "${searched[$1]}"; } > "$folder/study.new"
  if [[ -f $folder/done ]] && cmp -s "$folder/study.new" "$folder/study.yaml"; then return; fi
  mv "$folder/study.new" "$folder/study.yaml"
  bin/optserver "$folder/study.yaml" --config "$scratch/config" --folder "$folder" --workers "$workers" --port 0 > "$folder/log" 2>&1 || { tail -3 "$folder/log" >&2; return 1; }
  cp "$folder/log" "$folder/done"
  echo "searched $1, $2 draws, seed $3"
}

# Runs a command in the background, at most `jobs` at once.
waiting=0
launch() {
  "$@" &
  if ((++waiting >= jobs)); then wait -n; waiting=$((waiting - 1)); fi
}
finish() { while ((waiting > 0)); do wait -n; waiting=$((waiting - 1)); done; }

for subject in $subjects; do
  for seed in $seeds; do
    for how in without with; do launch search "$subject" "$how" "$seed"; done
  done
done
finish

# A file for each motion with a line for each world and figure: SUBJECT MOTION WORLD FIGURE MEAN STANDARD-ERROR
try() { # SUBJECT, name of the row, file of the motion
  local world words i differs mine=$scratch/$1-$2
  mkdir "$mine"
  cp -r config "$mine/config"
  cp "$3" "$mine/config/robots/simspark_type${type[$1]}/motions/tried.yaml"
  for world in nominal bullet drawn; do
    differs=${nominal[$1]}
    case $world in
      bullet) differs+=", engine: bullet" ;;
      drawn) differs="${unlike[$1]}, $drawsTried" ;;
    esac
    study "$1" tried "$differs" > "$mine/study.yaml"
    read -ra words < <(bin/optserver "$mine/study.yaml" --config "$mine/config" --folder "$mine/none" --measure "$tries" \
      --first-seed "$first" 2> "$mine/log") || { cat "$mine/log" >&2; return 1; }
    for ((i = 1; i + 3 < ${#words[@]}; i += 4)); do echo "$1 $2 $world ${words[i]} ${words[i + 1]} ${words[i + 3]}"; done >> "$mine/measured"
  done
  echo "tried $1, $2"
}
rows=()
for subject in $subjects; do
  rows+=("$scratch/$subject-start/measured")
  launch try "$subject" start "$begin/${motion[$subject]}.yaml"
  for seed in $seeds; do
    for how in without with; do
      rows+=("$scratch/$subject-$how-$seed/measured")
      launch try "$subject" "$how-$seed" "$out/$subject-$how-$seed/${task[$subject]}.yaml"
    done
  done
done
finish
budget() { echo "${generations[$1]} generations, $((population[$1] * runs[$1] * 3 / 2 * generations[$1])) runs"; } # SUBJECT
awk -v tries="$tries" -v first="$first" -v json="$out.json.new" -v seeds="$seeds" -v draws="$drawsOfSearch" \
  -v about="standUp|Standing up from the back, type ${type[standUp]}: \`${motion[standUp]}\`, from the motion of the fall, then walking or standing; $(budget standUp)
kick|The long kick, type ${type[kick]}: ball within 3 x 3 cm, with draws 5 x 5; $(budget kick)" -f tests/bench/robust/tables.awk "${rows[@]}" > "$out.md.new"
mv "$out.md.new" "$out.md"
mv "$out.json.new" "$out.json"
cat "$out.md"
