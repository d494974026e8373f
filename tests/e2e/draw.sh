# bin/agent --draw: drawings of several players from their first cycle on, each in sets of its own.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
expectError 2 'agent: --draw: no drawing is called "tema"; did you mean "team"?; see agent --help' "$bin/agent" --draw team,tema
expectError 2 'agent: --draw: no drawing is called "belief:bal"; did you mean "belief:ball"?; see agent --help' "$bin/agent" --draw belief:bal
expectError 2 'match.sh: --draw shows on the page: not with --no-page; see match.sh --help' scripts/match.sh --draw team --no-page
expectError 2 'match.sh: --draw: no drawing is called "tema"; did you mean "team"?; see match.sh --help' scripts/match.sh --draw tema

# A viewer: notes the names of all sets that it has to show, and how many shapes of each came.
python3 - "$scratch" << 'END' &
import re, socket, sys
from collections import Counter
viewer = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
viewer.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 22)
viewer.bind(("127.0.0.1", 0))
with open(sys.argv[1] + "/port.part", "w") as out: out.write(str(viewer.getsockname()[1]))
import os; os.rename(sys.argv[1] + "/port.part", sys.argv[1] + "/port")
seen, longest = Counter(), 0
while True:
    datagram = viewer.recv(65536)
    longest = max(longest, len(datagram))
    names = re.findall(rb"((?:left|right)\.\d\d\.[A-Za-z0-9:]+\.)\0", datagram)
    new = [n for n in names if n not in seen]
    seen.update(names)
    if new or longest > 512:
        with open(sys.argv[1] + "/sets.part", "w") as out:
            out.write("".join(n.decode() + "\n" for n in sorted(seen)) + f"longest {longest}\n")
        os.rename(sys.argv[1] + "/sets.part", sys.argv[1] + "/sets")
END
viewer=$!
waitFor test -s "$scratch/port"
"$bin/simulator" --port 0 --monitor-port 0 --ports-file "$scratch/ports.json" --sync --wait-agents 3 --kickoff-after 1 --seed 3 \
  --max-seconds 6 --die-with-parent > "$scratch/simulator.log" 2>&1 &
simulator=$!
waitFor test -s "$scratch/ports.json"
read -r agentPort monitorPort _ < <(tr -cs '0-9\n' ' ' < "$scratch/ports.json")
start() { # team, number, drawings
  "$bin/agent" --team "$1" --number "$2" --port "$agentPort" --monitor-port "$monitorPort" --draw "$3" \
    --drawing-port "$(cat "$scratch/port")" --crash-log "$scratch/crash$1$2" --status > "$scratch/$1$2.log" 2>&1 &
  agents+=($!)
  waitFor grep -q . "$scratch/$1$2.log"
}
agents=()
start One 1 team,belief
start One 2 team,belief
start Other 2 belief:ball
wait $simulator || fail "the simulator: $(tail -1 "$scratch/simulator.log")"
kill -TERM "${agents[@]}" 2> /dev/null || true
kill "$viewer"
wait
cat "$scratch/sets"
for set in left.0{1,2}.{team:role,belief:{ball,robots,sight,heard}}. right.02.belief:ball.; do
  grep -qxF "$set" "$scratch/sets" || fail "no set $set"
done
! grep -F right.02 "$scratch/sets" | grep -qvF belief:ball || fail "drawings that nobody asked for"
(($(sed -n 's/^longest //p' "$scratch/sets") <= 512)) || fail "a datagram is longer than viewers read"
