# A game is recorded, also by an agent that is killed, and any part of it runs on the recording with the same bytes.
# bin/logtool lists, cuts, joins, compares and exports it. The debug interface steps a replay forward and back.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
cd "$scratch"
log=game
"$bin/game" --seed 8 --limit 6 --output out --agent-option=--log --agent-option="$scratch/$log" --agent-option=--log-wait > /dev/null || true
"$bin/logtool" list $log > list.txt
grep -q '^thread default: 29[0-9] cycles, numbers 1 to 29[0-9]' list.txt || fail "cycles of six seconds: $(sed -n 3p list.txt)"
grep -q 'RobotPose *AugmentedSelfLocator ' list.txt || fail "no pose in the log"

# The same bytes: all modules but the platform's; self-locator, ball and behaviour alone; one of them.
part=0
for compute in "" "AugmentedSelfLocator,BallLocator,BeliefCombinator,Striker2,BehaviorCombinator,SkillGetBall" MotionSelector; do
  part=$((part + 1))
  "$bin/agent" --replay $log --log again$part ${compute:+--compute "$compute"} || fail "replay of '$compute'"
  "$bin/logtool" compare $log again$part > compare.txt || fail "replay of '$compute' differs: $(cat compare.txt)"
  grep -q '^the same in 29[0-9] cycles$' compare.txt || fail "$(cat compare.txt)"
done
# What is changed is found, with its field.
mkdir -p changed && cp -r "$OLDPWD/config" changed/config && printf 'forgetSeconds: 0.01\n' > changed/config/BallLocator.yaml
"$bin/agent" --config changed/config --replay $log --log other --compute BallLocator || fail "replay of a changed module"
if "$bin/logtool" compare $log other > compare.txt; then fail "a changed parameter changes nothing"; fi
grep -q ' LocalBallPos\.[a-z.]* ' compare.txt || fail "no first difference: $(cat compare.txt)"
expectEqual "$(grep -c RobotPose compare.txt)" 0 "differences of what did not run"

# Parts.
"$bin/logtool" cut $log a --to 3 > /dev/null
"$bin/logtool" cut $log b --from 3.001 > /dev/null
"$bin/logtool" join whole a b > /dev/null
"$bin/logtool" compare $log whole > /dev/null || fail "parts joined are not the whole"
"$bin/logtool" export $log --csv ball.csv --only BallPos.relative,RobotPose.position > /dev/null
expectEqual "$(head -1 ball.csv)" "time,cycle,RobotPose.position.x,RobotPose.position.y,BallPos.relative.x,BallPos.relative.y" "header"
"$bin/logtool" export $log --gap run > /dev/null
"$bin/gap" diagnose --help > /dev/null && grep -q '"robot": "simspark_type0"' run/run.json || fail "no run"
expectError 2 "logtool: $log has no BalPos; did you mean \"BallPos\"?" "$bin/logtool" export $log --csv - --only BalPos
expectError 2 "agent: $log exists already: a log is never overwritten; choose another name" "$bin/agent" --start-simulator --log $log
expectError 2 "agent: none: there is no such log" "$bin/agent" --replay none

# On, back, to a time.
"$bin/agent" --replay $log --paused --debug 0 2> agent.err &
waitFor grep -q 'debug port' agent.err
rdb=("$bin/rdb" "127.0.0.1:$(sed -n 's/.*debug port 127.0.0.1:\([0-9]*\):.*/\1/p' agent.err)")
value() { "${rdb[@]}" --exec "get $1"; }
"${rdb[@]}" --exec 'set replay:time 4'
there=$(value r:BallPos)
expectEqual "$(value r:FrameInfo.time)" "representation:FrameInfo.time 4.000000" "time gone to"
"${rdb[@]}" --exec 'dr replay:step' > /dev/null
[[ $(value r:BallPos) != "$there" ]] || fail "a step changes nothing"
"${rdb[@]}" --exec 'dr replay:back' > /dev/null
expectEqual "$(value r:BallPos)" "$there" "a step on and back"
"${rdb[@]}" --exec 'providers BallP' | grep -q '^BallPos  BeliefCombinator  \[default\]$' || fail "who provides the ball"
"${rdb[@]}" --exec 'providers Frame' | grep -q '^FrameInfo  log  \[default\]$' || fail "who provides the frame"
"${rdb[@]}" --exec 'reset BallLocator' > /dev/null || fail "reset"
kill %%
wait %% || true

# An agent that is killed: all but the last half second is there, and replays. Its own clock says when that was.
"$bin/agent" --start-simulator --simulator-option=--realtime --log killed --debug 0 2> agent.err &
agent=$!
waitFor test -s killed/killed_0.db3-wal
waitFor grep -q 'debug port' agent.err
rdb=("$bin/rdb" "127.0.0.1:$(sed -n 's/.*debug port 127.0.0.1:\([0-9]*\):.*/\1/p' agent.err)")
sleep 4
alive=$(value r:FrameInfo.time)
kill -9 $agent
wait $agent 2> /dev/null || true
"$bin/logtool" list killed > list.txt
last=$(sed -n 's/^thread default: .* time .* to \([0-9.]*\) s$/\1/p' list.txt)
awk -v alive="${alive##* }" -v last="$last" 'BEGIN { exit !(alive > 2 && last >= alive - 0.5) }' ||
  fail "the last half second before $alive of a killed agent is missing: $(sed -n 3p list.txt)"
"$bin/agent" --replay killed --log killedAgain
"$bin/logtool" compare killed killedAgain > /dev/null || fail "the log of a killed agent does not replay"
