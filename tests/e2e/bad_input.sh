# Bad options and files: one line that says what and where, status 2, nothing half-started.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
cp -r config "$scratch/config"
agent=("$bin/agent" --config "$scratch/config" --start-simulator)

expectError 2 "agent: The following argument was not expected: --speed; see agent --help" "$bin/agent" --speed
expectError 2 "agent: --type: Value 5 not in range 0 to 4; see agent --help" "$bin/agent" --type 5
expectError 2 "game: --type: Value 5 not in range 0 to 4; see game --help" "$bin/game" --type 5
expectError 2 "game: The following argument was not expected: --fast; see game --help" "$bin/game" --fast
expectError 2 "optimizewalk: with --over the output is called walking.yaml, not '$scratch/walk.yaml'" \
  "$bin/optimizewalk" --choose --over config/walks/type0/over --output "$scratch/walk.yaml"
expectError 2 "optimizewalk: --over requires --choose; see optimizewalk --help" "$bin/optimizewalk" --over config/walks/type0/over
expectError 2 "agent: $scratch/none.cfg: cannot be read: No such file or directory" "$bin/agent" --modules "$scratch/none.cfg"

# A file of the configuration with a mistake, and what is said of it.
mistake() { # file, sed script, message
  cp "config/$1" "$scratch/config/$1"
  sed -i "$2" "$scratch/config/$1"
  expectError 2 "agent: $3" "${agent[@]}"
  cp "config/$1" "$scratch/config/$1"
}
line() { grep -n "$2" "config/$1" | head -1 | cut -d: -f1; }
c=$scratch/config
mistake Striker2.yaml 's/ballMaxAge/ballMaxAgee/' \
  "$c/Striker2.yaml:1: missing key \"ballMaxAge\"; is it \"ballMaxAgee\" in line $(line Striker2.yaml ballMaxAge)?"
mistake Striker2.yaml 's/^kickAllowed: .*/kickAllowed: perhaps/' \
  "$c/Striker2.yaml:$(line Striker2.yaml kickAllowed): kickAllowed must be true or false, not \"perhaps\""
mistake Striker2.yaml 's/^ballMaxAge: 3.0/ballMaxAge: -1/' \
  "$c/Striker2.yaml:$(line Striker2.yaml ballMaxAge): ballMaxAge must be within [0.1, 60], not -1"
mistake Striker2.yaml '1aspeed: 3' "$c/Striker2.yaml:2: unknown key \"speed\""
mistake Striker2.yaml '1aspeed: [3' "$c/Striker2.yaml:3: broken YAML: end of sequence flow not found"
mistake modules.cfg 's/^BallLocator .*//' \
  "$c/modules.cfg:$(line modules.cfg BeliefCombinator): no provider for representation LocalBallPos required by module BeliefCombinator in thread default; add \"BallLocator LocalBallPos\""
mistake modules.cfg 's/^BallLocator .*/BallLocatr LocalBallPos/' \
  "$c/modules.cfg:$(line modules.cfg ^BallLocator): unknown module BallLocatr; did you mean \"BallLocator\"?"

# A keyframe file with a mistake.
motion=$c/motions/standUpBack.yaml
sed -i '0,/KneePitch/s//KneePitsch/' "$motion"
expectError 2 "agent: $motion:$(grep -n KneePitsch "$motion" | cut -d: -f1): KneePitsch: unknown joint; nearest known name: KneePitch" "${agent[@]}"

# Ports.
"$bin/simulator" --port 0 --monitor-port 0 --ports-file "$scratch/ports" > /dev/null &
waitFor test -s "$scratch/ports"
port=$(value "$scratch/ports" agent)
[[ $port ]] || port=$(sed 's/.*"agent": *\([0-9]*\).*/\1/' "$scratch/ports")
expectError 2 "simulator: port $port of 127.0.0.1 is in use; choose another or 0" "$bin/simulator" --port "$port" --monitor-port 0
expectError 2 "simulator: --port: '70000' is not a port, 0 to 65535" "$bin/simulator" --port 70000
expectError 2 "simulator: unknown physics engine \"foo\"; there are: ode, ode-dense, bullet" "$bin/simulator" --engine foo
expectError 2 "simulator: --bind 0.0.0.0 opens the monitor port to others: set a --token" "$bin/simulator" --bind 0.0.0.0
