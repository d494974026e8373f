#!/usr/bin/env bash
# 10,000 connections that say nothing: a late player gets in within a second meanwhile, and the log stays short. A second
# simulator, which has no idle connections, tells how long the machine itself takes at that time.
set -uo pipefail
source "$(dirname "$0")/../support/far-off.bash"
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
work=$(mktemp -d)
servers=()
trap 'kill "${servers[@]}" 2> /dev/null; rm -rf "$work"' EXIT
for name in flooded control; do
  bin/simulator --port 0 --monitor-port 0 --ports-file "$work/$name" > /dev/null 2> "$work/$name.log" &
  servers+=($!)
done
listen() { [[ -s $work/flooded && -s $work/control ]]; }
comesTrue listen
python3 - "$work/flooded" "$work/control" << 'END' || exit 1
import json, resource, socket, statistics, sys, threading, time
flooded, control = (json.load(open(file))["agent"] for file in sys.argv[1:])
hard = resource.getrlimit(resource.RLIMIT_NOFILE)[1]
resource.setrlimit(resource.RLIMIT_NOFILE, (min(hard, 12000), hard))
frame = lambda text: len(text).to_bytes(4, "big") + text
tried, idle = 0, []
waits, controls = [], []
def flood():
    global tried
    for _ in range(10000):
        try:
            idle.append(socket.create_connection(("127.0.0.1", flooded), 5))
        except OSError:
            if idle: idle.pop(0).close()
        tried += 1
        if len(idle) > 900: idle.pop(0).close()
def enter(port):
    begin = time.monotonic()
    player = socket.create_connection(("127.0.0.1", port), 600)
    player.settimeout(600)
    player.sendall(frame(b"(scene rsg/agent/nao/nao_hetero.rsg 0)"))
    if not player.recv(4): sys.exit(f"FAIL player {len(waits) + 1} was sent away")
    wait = time.monotonic() - begin
    player.close()
    return wait
thread = threading.Thread(target=flood, daemon=True)
thread.start()
while thread.is_alive() and len(waits) < 11:
    waits.append(enter(flooded))
    controls.append(enter(control))
    time.sleep(0.1)
thread.join()
# A busy machine may stop any of them for a while: the medians count. What makes the control wait is the machine; an idle
# one answers it within 0.1 s, and the limit is then 1 s.
wait, alone = statistics.median(waits), statistics.median(controls)
limit = max(1, 10 * alone)
print(f"{tried} idle connections tried; {len(waits)} late players in after {wait:.2f} s, {max(waits):.2f} at most;"
      f" without idle connections after {alone:.2f} s, {max(controls):.2f} at most")
if tried < 10000 or wait > limit: sys.exit(f"FAIL limit {limit:.2f} s, waits {waits}, without idle connections {controls}")
END
kill -0 "${servers[0]}" || { echo "FAIL the simulator ended"; exit 1; }
lines=$(wc -l < "$work/flooded.log")
((lines < 2000)) || { echo "FAIL $lines lines in the log"; exit 1; }
echo "$lines lines in the log"
