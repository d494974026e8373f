# bin/webmonitor without a browser: it goes on when the drawings' port is taken, and refuses broken recordings in a line.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
scripts/build_page.sh || fail "the page could not be built"
python3 - "$scratch" << 'END' &
import socket, sys, time
taken = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
try:
    taken.bind(("127.0.0.1", 32769))
except OSError:
    pass  # another program has it: as good
free = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
free.bind(("127.0.0.1", 0))
open(sys.argv[1] + "/taken", "w").write(str(free.getsockname()[1]))
time.sleep(60)
END
waitFor test -s "$scratch/taken"
"$bin/webmonitor" --web-port 0 --port 1 > "$scratch/out" 2>&1 &
monitor=$!
waitFor grep -q drawings "$scratch/out"
grep -qx "webmonitor: without the agents' drawings: UDP port 32769 for drawings: Address already in use" "$scratch/out" || fail "it says: $(cat "$scratch/out")"
kill -TERM $monitor
wait $monitor || fail "webmonitor ended with status $?"
# A port that somebody asks for is had or not.
port=$(cat "$scratch/taken")
expectError 2 "webmonitor: UDP port $port for drawings: Address already in use; give --drawing-port another, 0 for a free one, or -1 for none" \
  "$bin/webmonitor" --web-port 0 --drawing-port "$port"

# The state of a game that is nested without end: 1.3 kB on the disk.
python3 - "$scratch/nested.plm" << 'END'
import struct, sys, zlib
message = b"[" * 300000
records = struct.pack("<BII", 1, 0, len(message)) + message + struct.pack("<BII", 3, 0, 4) + b"abcd"
packed = zlib.compress(records)
chunk = b"CHNK" + struct.pack("<III", len(packed), len(records), 0) + struct.pack("<dd", 0, 1) + packed
open(sys.argv[1], "wb").write(b"PLUMBLINE MATCH\n" + struct.pack("<I", 1) + chunk)
END
expectError 2 "webmonitor: $scratch/nested.plm: the game's state at 0.00 s is nested deeper than 16 levels" \
  "$bin/webmonitor" --web-port 0 --replay "$scratch/nested.plm"
