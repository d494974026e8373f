#!/usr/bin/env bash
# Tables 3.1 to 3.3 of the thesis (Seekircher 2015): motions made by hand beside those found by searches, by the thesis's
# protocol on the embedded simulator, and the thesis's own figures: build/bench/optimisation-motions.json and .md. Motions made by
# hand that are no longer in use are in by-hand/. TRIES of each [1000], seeds from FIRST on [1000000], of TYPES. What the motions do
# on the league's server comes from doc/results/motion-server.md.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
tries=${TRIES-1000} first=${FIRST-1000000} types=${TYPES-0 1 2 3 4} out=build/bench/optimisation-motions
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p build/bench
cp -r config "$scratch/config"
for folder in tests/bench/optimisation-motions/by-hand/type*/; do
  for file in "$folder"*.yaml; do cp "$file" "$scratch/config/robots/simspark_$(basename "$folder")/motions/$(basename "$file" .yaml)ByHand.yaml"; done
done
: > "$scratch/measured.tsv"

measure() { # KIND (hand or search), TASK, TYPE, MOTION, more options
  local motion=$4 words i
  if [[ $1 == hand && -f $scratch/config/robots/simspark_type$3/motions/$4ByHand.yaml ]]; then motion=$4ByHand; fi
  printf 'task: %s\noptions: {type: %s, motion: %s%s}\n' "$2" "$3" "$motion" "${5:+, $5}" > "$scratch/study.yaml"
  read -ra words < <(bin/optserver "$scratch/study.yaml" --config "$scratch/config" --folder "$scratch/none" --measure "$tries" \
    --first-seed "$first" 2> "$scratch/log") || { cat "$scratch/log" >&2; exit 1; }
  for ((i = 1; i + 3 < ${#words[@]}; i += 4)); do # NAME MEAN +- STANDARD ERROR
    printf '%s\t%s\t%s\t%s\t%s\t%s\n' "$1" "$3" "$4" "${words[i]}" "${words[i + 1]}" "${words[i + 3]}"
  done >> "$scratch/measured.tsv"
  echo "type $3, $motion"
}
for type in $types; do
  for direction in Front Back; do
    measure hand standUp "$type" "standUp$direction" "direction: ${direction,}"
    measure search standUp "$type" "standUp${direction}Fast" "direction: ${direction,}"
  done
  measure hand kick "$type" kickRight
  measure search kick "$type" kickLong
done
awk -v types="$types" -v tries="$tries" -v first="$first" -v day="$(date -u +%F)" -v json="$out.json.new" \
  -f tests/bench/optimisation-motions/tables.awk "$scratch/measured.tsv" doc/results/motion-server.md > "$out.md.new"
mv "$out.md.new" "$out.md"
mv "$out.json.new" "$out.json"
cat "$out.md"
