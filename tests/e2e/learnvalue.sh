# bin/learnvalue: from tracks of games to a file that an agent plays by. The same tracks give the same bytes. A track that
# is none, or a disk that takes no more, is an error of one line, and the file before stays.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
track() { # file, side that scores: a ball that is carried to and fro, and goes in
  awk -v side="$2" 'BEGIN {
    print "time,side,number,x,y,up,mode"
    for (i = 0; i < 200; ++i) {
      mode = i < 180 ? "PlayOn" : "Goal_" side
      printf "%.1f,ball,0,%.2f,%.2f,1,%s\n", i / 2, i % 20 - 10, i % 7 - 3, mode
      printf "%.1f,left,1,%.2f,0,1,%s\n%.1f,right,1,%.2f,1,1,%s\n", i / 2, i % 20 - 11, mode, i / 2, i % 20 - 6, mode
    }
  }' > "$1"
}
cd "$scratch"
track left.csv Left
track right.csv Right
cp -r "$OLDPWD/config" config
value=config/field_value.yaml
learn() { within 120 "$bin/learnvalue" "$@" > said || fail "learnvalue $*: $(cat said)"; }

learn left.csv right.csv -o $value
expectEqual "$(cat said)" "2 games, 360 steps, 12 of them into a goal: $value" "what was learnt"
learn left.csv right.csv -o again.yaml
cmp $value again.yaml || fail "the same tracks give another file"
# A ball before their goal is worth more than one before ours.
for whose in theirs nobodys ours; do
  sed -n "/^$whose:/{n;s/[^-0-9. ]//g;p}" $value | awk '{ exit !($2 < $NF) }' || fail "of $whose, the value does not rise: $(cat $value)"
done
# An agent reads it.
status=0
within 240 "$bin/game" --seed 3 --limit 1 --output out --agent-option=--config --agent-option="$PWD/config" > game.txt 2>&1 || status=$?
expectEqual "$status" 1 "status of a game of a second with that file"
grep -q 'no goal within 1 s' game.txt || fail "$(cat game.txt)"
cp -r config broken
sed -i 's/^ours:/uors:/' broken/field_value.yaml
expectError 2 'agent: broken/field_value.yaml:1: missing key "ours"; is it "uors" in line 17?' "$bin/agent" --config broken --start-simulator

cp $value before.yaml
expectError 2 "learnvalue: $value:1: must have 7 columns" "$bin/learnvalue" $value -o $value
sed '9s/,[-0-9.]*,/,far,/2' left.csv > wrong.csv
expectError 2 "learnvalue: wrong.csv:9: 'far' is no number within 1000" "$bin/learnvalue" wrong.csv -o $value
head -1 left.csv > none.csv
expectError 2 "learnvalue: no ball in play in 1 tracks" "$bin/learnvalue" none.csv -o $value
expectError 2 "learnvalue: tracks: File does not exist: nowhere.csv; see learnvalue --help" "$bin/learnvalue" nowhere.csv
expectError 2 "learnvalue: cannot write nowhere/value.yaml: No such file or directory" "$bin/learnvalue" left.csv -o nowhere/value.yaml
expectError 2 "learnvalue: cannot write $value: File too large" bash -c 'trap "" XFSZ; ulimit -f 0; exec "$@"' full "$bin/learnvalue" left.csv -o $value
cmp $value before.yaml || fail "an error changed the file"
[[ ! $(find . -name '*.part') ]] || fail "left: $(find . -name '*.part')"
