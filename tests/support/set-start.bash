# One robot in a set start, for starts.sh and positioning.sh: the referee puts ball and robot where they are wanted. Who sources
# this has `bin`, the folder of programs, and `work`, a folder with a copy of the agent's configuration in `config`. What happened
# is in $work/run/track.csv afterwards; a game that could not be played ends the script.
playSetStart() { # type, seed, limit [s], "ballX ballY robotX robotY", "x y heading" to which the robot beams itself before
  local type=$1 seed=$2 limit=$3 ballX ballY robotX robotY x y heading status=0
  read -r ballX ballY robotX robotY <<< "$4"
  read -r x y heading <<< "$5"
  printf 'x: [%s]\ny: [%s]\nheading: [%s]\n' "$x" "$y" "$heading" > "$work/config/BeforeKickOff.yaml"
  printf 'moves: {startAnywhere: true}\nstartPlace: {on: true, x: %s, y: %s, robotX: %s, robotY: %s}\n' \
    "$ballX" "$ballY" "$robotX" "$robotY" > "$work/rules.yaml"
  "$bin/game" --type "$type" --seed "$seed" --limit "$limit" --output "$work/run" --agent-option=--config \
    "--agent-option=$work/config" --simulator-option=--rules "--simulator-option=$work/rules.yaml" > "$work/run.log" 2>&1 || status=$?
  ((status < 2)) || { tail -1 "$work/run.log" >&2; exit 1; }
}
