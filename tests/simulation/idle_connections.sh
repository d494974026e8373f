#!/usr/bin/env bash
# 10,000 connections that say nothing: a late player gets in within a second meanwhile, and the log stays short.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
work=$(mktemp -d)
trap 'kill "$server" 2> /dev/null; rm -rf "$work"' EXIT
bin/simulator --port 0 --monitor-port 0 --ports-file "$work/ports" > /dev/null 2> "$work/log" &
server=$!
for ((i = 0; i < 600; ++i)); do [[ -s $work/ports ]] && break; sleep 0.05; done
python3 - "$work/ports" << 'END' || exit 1
import json, resource, socket, sys, threading, time
port = json.load(open(sys.argv[1]))["agent"]
hard = resource.getrlimit(resource.RLIMIT_NOFILE)[1]
resource.setrlimit(resource.RLIMIT_NOFILE, (min(hard, 12000), hard))
frame = lambda text: len(text).to_bytes(4, "big") + text
tried, idle, waits = 0, [], []
def flood():
    global tried
    for _ in range(10000):
        try:
            idle.append(socket.create_connection(("127.0.0.1", port), 5))
        except OSError:
            if idle: idle.pop(0).close()
        tried += 1
        if len(idle) > 900: idle.pop(0).close()
thread = threading.Thread(target=flood)
thread.start()
number = 0
while thread.is_alive() and number < 11:
    number += 1
    begin = time.monotonic()
    player = socket.create_connection(("127.0.0.1", port), 20)
    player.settimeout(20)
    player.sendall(frame(b"(scene rsg/agent/nao/nao_hetero.rsg 0)"))
    if not player.recv(4): sys.exit(f"FAIL player {number} was sent away")
    waits.append(time.monotonic() - begin)
    player.close()
    time.sleep(0.1)
thread.join()
print(f"{tried} idle connections tried; {len(waits)} late players in after {max(waits):.2f} s at most")
# A busy machine may stop any of them for a while; the median may not suffer.
if tried < 10000 or sorted(waits)[len(waits) // 2] > 1: sys.exit(f"FAIL waits {waits}")
END
kill -0 "$server" || { echo "FAIL the simulator ended"; exit 1; }
lines=$(wc -l < "$work/log")
((lines < 2000)) || { echo "FAIL $lines lines in the log"; exit 1; }
echo "$lines lines in the log"
