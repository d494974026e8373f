# A further robot type of the league is a file and its folder in the configuration; agent, simulator and game take it.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
cp -r config "$scratch/config"
sed 's/"name": "simspark_type1"/"name": "simspark_type5"/' config/robots/simspark_type1.json > "$scratch/config/robots/simspark_type5.json"
cp -r config/robots/simspark_type1 "$scratch/config/robots/simspark_type5"
cd "$scratch"

# The same robot by another name does the same.
for type in 1 5; do
  status=0
  within 60 "$bin/game" --type $type --seed 3 --limit 8 --output type$type > type$type.out 2>&1 || status=$?
  expectEqual "$status" 1 "a game of type $type without a goal in 8 s: $(tail -1 type$type.out)"
done
tracks=$(sed 's/Robot type [0-9]//' type1/track.svg | sha256sum)
expectEqual "$(sed 's/Robot type [0-9]//' type5/track.svg | sha256sum)" "$tracks" "track of type 5, which is type 1's file"

# Another one is refused with those there are, by the folder that is asked.
expectError 2 "agent: there is no robot type 6; config/robots has the league's types 0 to 5, the next one is a file simspark_type6.json there" "$bin/agent" --type 6
cd - > /dev/null
expectError 2 "agent: there is no robot type 5; config/robots has the league's types 0 to 4, the next one is a file simspark_type5.json there" "$bin/agent" --type 5
expectError 2 "agent: there is no robot type 6; $scratch/config/robots has the league's types 0 to 5, the next one is a file simspark_type6.json there" "$bin/agent" --config "$scratch/config" --type 6
