# Bad options and files: one line that says what and where, status 2, nothing half-started.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
cp -r config "$scratch/config"
agent=("$bin/agent" --config "$scratch/config" --start-simulator)

expectError 2 "agent: there is no option --speed; see agent --help" "$bin/agent" --speed
expectError 2 "agent: there is no robot type 5; config/robots has the league's types 0 to 4, the next one is a file simspark_type5.json there" "$bin/agent" --type 5
expectError 2 "game: there is no robot type 5; config/robots has the league's types 0 to 4, the next one is a file simspark_type5.json there" "$bin/game" --type 5
expectError 2 'game: there is no option --enigne; did you mean "--engine"?; see game --help' "$bin/game" --enigne
expectError 2 "optimizewalk: with --over the output is called walking.yaml, not '$scratch/walk.yaml'" \
  "$bin/optimizewalk" --choose --over config/walks/type0/over --output "$scratch/walk.yaml"
expectError 2 "optimizewalk: --over requires --choose; see optimizewalk --help" "$bin/optimizewalk" --over config/walks/type0/over
expectError 2 "agent: $scratch/none.cfg: cannot be read: No such file or directory" "$bin/agent" --modules "$scratch/none.cfg"

expectError 2 'agent: there is no option --tem; did you mean "--team"?; see agent --help' "$bin/agent" --tem X
expectError 2 'gap: there is no command diagnos; did you mean "diagnose"?; see gap --help' "$bin/gap" diagnos runs
expectError 2 'gap: there is no option --jbos; did you mean "--jobs"?; see gap diagnose --help' "$bin/gap" diagnose runs --jbos 2
expectError 2 'simulator: there is no option --snyc; did you mean "--sync"?; see simulator --help' "$bin/simulator" --snyc

# A field of one's own is read by all three, and checked by all three.
printf 'length: 20\nlenght: 9\n' > "$scratch/field.yaml"
for program in agent simulator; do
  expectError 2 "$program: $scratch/field.yaml:2: unknown key \"lenght\"; did you mean \"length\"?" "$bin/$program" --field "$scratch/field.yaml"
done
expectError 2 "simulator: $scratch/none.yaml: cannot be read: No such file or directory" "$bin/simulator" --field "$scratch/none.yaml"

# Every program says its version, has examples in its help, shows nothing of the option parser's insides, and names the nearest
# option and command.
programs=()
for file in "$bin"/*; do
  program=${file##*/}
  [[ -x $file && $program != *.* ]] || continue # scripts are another matter
  programs+=("$program")
  [[ $("$file" --version) == "$program (Plumbline "*")" ]] || fail "$program --version: $("$file" --version)"
  help=$("$file" --help)
  [[ $help == *Example* ]] || fail "$program --help has no examples"
  [[ $help != *'{false}'* ]] || fail "$program --help shows {false}"
  expectError 2 "$program: there is no option --hepl; did you mean \"--help\"?; see $program --help" "$file" --hepl
  command=$(sed -n '/^Subcommands:/,/^$/s/^  \([a-z]\{1,\}\) .*/\1/p' <<< "$help" | head -1)
  [[ ! $command ]] ||
    expectError 2 "$program: there is no command ${command}x; did you mean \"$command\"?; see $program --help" "$file" "${command}x"
done
((${#programs[@]} >= 10)) || fail "few programs in $bin: ${programs[*]}"
for command in record diagnose report apply next blind reveal import effects settings; do
  [[ $("$bin/gap" "$command" --help) == *Example* ]] || fail "gap $command --help has no examples"
done
expectError 2 "gap: cannot write to standard output: No space left on device" bash -c '"$0" effects > /dev/full' "$bin/gap"

# A file of the configuration with a mistake, and what is said of it.
mistake() { # file, sed script, message
  cp "config/$1" "$scratch/config/$1"
  sed -i "$2" "$scratch/config/$1"
  expectError 2 "agent: $3" "${agent[@]}"
  cp "config/$1" "$scratch/config/$1"
}
line() { grep -n "$2" "config/$1" | head -1 | cut -d: -f1; }
c=$scratch/config
# The same of a module's own file: its text, what is said of it.
own() {
  printf '%b' "$1" > "$c/Striker2.yaml"
  expectError 2 "agent: $c/Striker2.yaml:$2" "${agent[@]}"
  rm "$c/Striker2.yaml"
}
own 'ballMaxAgee: 3\n' '1: unknown key "ballMaxAgee"; did you mean "ballMaxAge"?'
own '\nkickAllowed: perhaps\n' '2: kickAllowed must be true or false, not "perhaps"'
own 'ballMaxAge: -1\n' '1: ballMaxAge must be within [0.1, 60], not -1'
own 'kickAllowed: true\nspeed: [3\n' '3: broken YAML: end of sequence flow not found'
m=modules/perception.cfg
mistake $m 's/^BallLocator .*//' \
  "$c/$m:$(line $m ^BeliefCombinator): no provider for representation LocalBallPos required by module BeliefCombinator in thread default; add \"BallLocator LocalBallPos\""
mistake $m 's/^BallLocator .*/BallLocatr LocalBallPos/' \
  "$c/$m:$(line $m ^BallLocator): unknown module BallLocatr; did you mean \"BallLocator\"?"
m=platforms/simspark/modules.cfg
mistake $m 's#modules/motion.cfg#modules/motions.cfg#' \
  "$c/$m:$(line $m modules/motion): include $c/modules/motions.cfg: cannot be read: No such file or directory"
expectError 2 'agent: --platform simspak: unknown platform; did you mean "simspark"?' "$bin/agent" --platform simspak

printf 'standUp:\n  front: standUpFron\n' > "$c/MotionSelector.yaml"
expectError 2 "agent: $c/MotionSelector.yaml:2: standUp.front there is no motion standUpFron in motions/; did you mean \"standUpFront\"?" "${agent[@]}"
cp config/MotionSelector.yaml "$c/"
printf 'overlay: {base: MotionSelector.yaml, values: 1}\nstandUp:\n  fastBack: standUpBackFaster\n' > "$c/robots/simspark_type0/MotionSelector.yaml"
expectError 2 "agent: $c/robots/simspark_type0/MotionSelector.yaml:3: standUp.fastBack there is no motion standUpBackFaster in motions/; did you mean \"standUpBackFast\"?" "${agent[@]}"
cp config/robots/simspark_type0/MotionSelector.yaml "$c/robots/simspark_type0/"
expectError 2 'agent: --motion wavy: there is no motion wavy in motions/; did you mean "wave"?' "$bin/agent" --motion wavy
expectError 2 "agent: --team: a team's name is 1 to 20 printable ASCII characters without blanks, parentheses or quotes" "$bin/agent" --team "two words"
expectError 2 "start.sh: no server at 127.0.0.1:1: start one first, or give --wait; see start.sh --help" bin/start.sh --port 1
# A modules.cfg that was cut off.
head -7 config/platforms/simspark/modules.cfg > "$scratch/cut.cfg"
expectError 2 "agent: $scratch/cut.cfg: this agent sends nothing to the simulator: no line has the module SimSparkSend; was the file cut off?" \
  "${agent[@]}" --modules "$scratch/cut.cfg"
head -4 config/platforms/simspark/modules.cfg > "$scratch/cut.cfg"
expectError 2 "agent: $scratch/cut.cfg: no modules" "${agent[@]}" --modules "$scratch/cut.cfg"

# YAML that would be read by half.
printf 'kickAllowed: true\n---\nspeed: 1\n' > "$c/Striker2.yaml"
expectError 2 "agent: $c/Striker2.yaml:2: a second document begins at ---; a file holds one: take this line out" "${agent[@]}"
printf '# Striker.\n  kickAllowed: true\nballMaxAge: 3\n' > "$c/Striker2.yaml"
expectError 2 "agent: $c/Striker2.yaml:3: is indented less than the first key in line 2; all keys of a map begin in the same column" "${agent[@]}"
rm "$c/Striker2.yaml"
# A type's file that lost a line.
printf 'overlay: {base: SkillDribble.yaml, values: 2}\nwalk: {maxTurn: 2}\n' > "$c/robots/simspark_type4/SkillDribble.yaml"
expectError 2 "agent: $c/robots/simspark_type4/SkillDribble.yaml:1: overlay.values is 2, but there are 1 in the file: was a line lost or added? If not, write 1" \
  "${agent[@]}" --type 4
rm "$c/robots/simspark_type4/SkillDribble.yaml"

# Robots.
sed 's/"max_speed"/"max_sped"/' config/robots/xl330_pendulum.json > "$scratch/arm.json"
expectError 2 'gap: '"$scratch"'/arm.json: joints[0].max_sped: unknown key; did you mean "max_speed"?' "$bin/gap" effects --robot "$scratch/arm.json"

# From any folder.
(cd "$scratch" && "$bin/gap" effects --robot so101 > effects.txt && "$bin/optimizewalk" --try --task forward --tries 1 --seconds 2 > try.txt) ||
  fail "gap and optimizewalk outside of the project's folder"
grep -q 'on so101' "$scratch/effects.txt" || fail "gap effects elsewhere"

# A keyframe file with a mistake.
motion=$c/motions/standUpBack.yaml
sed -i '0,/KneePitch/s//KneePitsch/' "$motion"
expectError 2 "agent: $motion:$(grep -n KneePitsch "$motion" | cut -d: -f1): KneePitsch: unknown joint; did you mean \"KneePitch\"?" "${agent[@]}"

# Ports.
"$bin/simulator" --port 0 --monitor-port 0 --ports-file "$scratch/ports" > /dev/null &
waitFor test -s "$scratch/ports"
port=$(value "$scratch/ports" agent)
[[ $port ]] || port=$(sed 's/.*"agent": *\([0-9]*\).*/\1/' "$scratch/ports")
expectError 2 "simulator: port $port of 127.0.0.1 is in use; choose another or 0" "$bin/simulator" --port "$port" --monitor-port 0
expectError 2 "simulator: --port: '70000' is not a port, 0 to 65535; see simulator --help" "$bin/simulator" --port 70000
expectError 2 "simulator: unknown physics engine \"foo\"; there are: ode, ode-dense, bullet" "$bin/simulator" --engine foo
expectError 2 "simulator: --bind 0.0.0.0 opens the ports to others: set a --token" "$bin/simulator" --bind 0.0.0.0

# A recording on a full disk (here: a file that may not grow): a line at once, and status 2 at the end.
mkdir -p "$scratch/page"
echo '<html></html>' > "$scratch/page/index.html"
monitor=$(value "$scratch/ports" monitor)
[[ $monitor ]] || monitor=$(sed 's/.*"monitor": *\([0-9]*\).*/\1/' "$scratch/ports")
status=0
(trap '' XFSZ; ulimit -f 1; exec timeout --foreground --preserve-status -s INT 6 "$bin/webmonitor" --port "$monitor" --web-port 0 --drawing-port -1 \
  --page "$scratch/page" --record "$scratch/match.plm" > /dev/null 2> "$scratch/recording.log") || status=$?
expectEqual "$(cat "$scratch/recording.log")" \
  "webmonitor: the recording ends here: $scratch/match.plm: cannot write on; is the disk full?" "recording on a full disk"
expectEqual "$status" 2 "status of a recording on a full disk"
