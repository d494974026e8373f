# One agent plays and shows what it knows; another one without a robot reads it over the network, loses it and finds it again.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
cp -r config "$scratch/config"
echo "domain: $((100 + $$ % 100))" >> "$scratch/config/NetworkModule.yaml"
{ echo "include $scratch/config/platforms/simspark/modules.cfg"; echo network; } > "$scratch/shows.cfg"
player() { # how it plays: alone, with a simulator of its own
  "$bin/agent" --config "$scratch/config" --modules "$scratch/shows.cfg" --start-simulator --simulator-option=--realtime --debug 0 \
    > "$scratch/player.out" 2> "$scratch/player.err" &
  player=$!
}
portOf() { sed -n 's/.*debug port 127.0.0.1:\([0-9]*\):.*/\1/p' "$1"; }
"$bin/agent" --config "$scratch/config" --platform watcher --debug 0 > "$scratch/watcher.out" 2> "$scratch/watcher.err" &
waitFor grep -q 'debug port' "$scratch/watcher.err"
watcher=127.0.0.1:$(portOf "$scratch/watcher.err")
angle() { "$bin/rdb" "$watcher" --exec 'get r:SensorData.acc.z' | sed 's/.* //'; }
expectEqual "$(angle)" 9.810000 'what nobody sends keeps its first value'
moves() { local before; before=$(angle); sleep 0.2; [[ $(angle) != "$before" ]]; }
player
waitFor moves
for i in 1 2 3; do
  kill -KILL "$player"
  wait "$player" 2> /dev/null || true
  player
  waitFor moves
done
kill -TERM "$player"
wait "$player" || true
