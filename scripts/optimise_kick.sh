#!/usr/bin/env bash
# Searches a long kick by stages: first as far as the ball goes, whatever becomes of the robot, then with more and more worth of a robot
# that stays upright. One search that wants both from the beginning ends at 7 to 9 m (doc/decisions/0020-what-limits-a-kick.md).
# After the first stage the kick gets a keyframe more at its end, in which the robot can catch itself. The result is FOLDER/kick.yaml; its head
# says what TRIES runs with other seeds gave. It goes to config/robots/simspark_typeTYPE/motions/. About 5 to 7 minutes of two cores. Stopped or
# killed, the same command goes on.
#   scripts/optimise_kick.sh TYPE [MOTION]     MOTION: a kick of that type, or a file of any [kickLong]
# Variables: SEED of the searches [1], WORKERS [2], FOLDER [kickTYPE.search], TRIES [1000]. EFFORT multiplies the number of generations [1].
# Examples:
#   scripts/optimise_kick.sh 2
#   SEED=7 scripts/optimise_kick.sh 0 config/robots/simspark_type1/motions/kickLong.yaml
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
source "$(dirname "${BASH_SOURCE[0]}")/search_stages.bash"
motion=${2:-kickLong} tries=${TRIES:-1000} folder=${FOLDER:-kick$type.search}
[[ $tries =~ ^[1-9][0-9]{0,5}$ ]] || fail "TRIES is a whole number from 1, not '$tries'"
file=$motion
for place in "$root/config/motions" "$root/config/robots/simspark_type$type/motions"; do
  [[ ! -f $place/$motion.yaml ]] || file=$place/$motion.yaml
done
[[ -f $file ]] || fail "no motion '$motion' of type $type, and no file of that name"

# The motion with its last keyframe once more.
withOneMore() {
  awk '/^  - \{time:/ { last = "" } { print; if (last != "" || /^  - \{time:/) last = last $0 "\n" }
    END { sub(/time: [0-9.]+/, "time: 0.120", last); printf "%s", last }' "$1"
}

# Worth of a radian of lean, seconds of walk after the kick, sigma, generations, population, runs, worth of a millisecond.
stages=("0 0.2 2 1000 40 1 0" "0.3 0.6 0.6 400 60 1 0.01" "1 1 0.4 400 50 1 0.02" "2 1.5 0.3 400 40 1 0.03" "3 2 0.15 300 30 2 0.03")
from=$file
for ((i = 1; i <= ${#stages[@]}; ++i)); do
  read -r steady walk sigma generations population runs weight <<< "${stages[i - 1]}"
  runsOfBest=$((2 * runs))
  beginStage "$i" motions/kickStage.yaml < <(if ((i == 2)); then withOneMore "$from"; else cat "$from"; fi)
  # The feet of a robot that walks up push a ball away that is nearer than 158 mm.
  writeStudy <<< "task: kick
options: {type: $type, motion: kickStage, spread: 0.012, steady: $steady, walk: $walk, weight: $weight, ceiling: 5}
parameters: {ballX: {min: 158}}"
  echo "$name: stage $i of ${#stages[@]}: a radian of lean is worth $steady"
  if [[ ! -f $stage/done ]]; then
    serveStage --workers "$workers" --port 0
    serveStage --measure "$tries" --first-seed 1000000
    touch "$stage/done"
  fi
  from=$stage/search/kick.yaml
done
cp "$from" "$folder/kick.yaml"
echo "$name: $folder/kick.yaml"
