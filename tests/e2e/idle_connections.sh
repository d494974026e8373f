# Thousands of connections that say nothing, or the beginning of what they should. Meanwhile a late page, a late client of the
# debug port and a late one of a search get in at once. That holds where the system allows few files, too.
# tests/simulation/idle_connections.sh does so with players. Servers without idle connections say how long the machine takes.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
mkdir "$scratch/page"
echo '<html>a page</html>' > "$scratch/page/index.html"
"$bin/game" --seed 8 --limit 2 --output "$scratch/game" --agent-option=--log --agent-option="$scratch/log" --agent-option=--log-wait > /dev/null || true
printf 'task: function\noptions: {function: sphere, dimension: 2}\npopulation: 8\nruns: 1\nrunsOfBest: 1\ngenerations: 9\n' > "$scratch/study.yaml"
"$bin/simulator" --port 0 --monitor-port 0 --ports-file "$scratch/ports" > /dev/null 2>&1 &
waitFor test -s "$scratch/ports"
monitor=$(sed 's/.*"monitor": *\([0-9]*\).*/\1/' "$scratch/ports")

start() { # name, what stands before the port in what it says, command...
  "${@:3}" > "$scratch/$1" 2>&1 &
  waitFor grep -q "$2[0-9]" "$scratch/$1"
  sed -n "s#.*$2\([0-9]*\).*#\1#p" "$scratch/$1" | head -1 > "$scratch/$1.port"
}
search() { # name, most files
  bash -c 'ulimit -n "$0"; exec "$@"' "$2" "$bin/optserver" "$scratch/study.yaml" --port 0 --folder "$scratch/search.$1" > "$scratch/$1" 2>&1 &
  waitFor test -s "$scratch/search.$1/port"
  cp "$scratch/search.$1/port" "$scratch/$1.port"
}
agent=("$bin/agent" --replay "$scratch/log" --paused --debug 0 --crash-log "$scratch/crash.log")
for name in flooded control; do
  start page.$name 'http://localhost:' "$bin/webmonitor" --port "$monitor" --web-port 0 --drawing-port -1 --page "$scratch/page"
  start debug.$name 'debug port 127.0.0.1:' "${agent[@]}"
  start token.$name 'debug port 127.0.0.1:' "${agent[@]}" --debug-token secret
  search farm.$name "$(ulimit -n)"
  search few.$name 100
done
python3 - "$scratch" << 'END' || fail "see above"
import resource, socket, statistics, sys, time
scratch = sys.argv[1]
hard = resource.getrlimit(resource.RLIMIT_NOFILE)[1]
resource.setrlimit(resource.RLIMIT_NOFILE, (min(hard, 4000), hard))
get, ask, hello = b"GET / HTTP/1.1\r\nHost: localhost\r\n\r\n", b"get nothing\n", b'{"hello": "status", "version": 1, "name": "late"}\n'
kinds = {"page": (get, b"HTTP/1.1 200"), "debug": (ask, b"error: nothing is called"), "token": (b"secret\n" + ask, b"error: nothing is called"),
         "farm": (hello, b'{"again"'), "few": (hello, b'{"again"')}
def port(kind, name): return int(open(f"{scratch}/{kind}.{name}.port").read())
def enter(kind, name):
    says, answer = kinds[kind]
    begin = time.monotonic()
    with socket.create_connection(("127.0.0.1", port(kind, name)), 600) as client:
        client.settimeout(600)
        client.sendall(says)
        got = client.recv(1000)
    if not got.startswith(answer): sys.exit(f"FAIL {kind}.{name}: a late client is answered {got[:80]}")
    return time.monotonic() - begin
class Crowd:
    def __init__(self, kind):
        self.says, self.where, self.tried, self.idle = kinds[kind][0][:5], ("127.0.0.1", port(kind, "flooded")), 0, []
    def come(self, count):
        for _ in range(count):
            try:
                self.idle.append(socket.create_connection(self.where, 5))
                if self.tried % 2: self.idle[-1].sendall(self.says)
            except OSError: # it was sent away already
                pass
            self.tried += 1
            if len(self.idle) > 1500: self.idle.pop(0).close()
for kind in kinds:
    crowd, waits, controls = Crowd(kind), [], []
    crowd.come(1200)
    for _ in range(11):
        waits.append(enter(kind, "flooded"))
        controls.append(enter(kind, "control"))
        crowd.come(300)
    # A busy machine may stop any of them for a while: the medians count, and what makes the control wait is the machine.
    # An idle one takes 0.01 s; who is locked out waits for ten.
    wait, alone = statistics.median(waits), statistics.median(controls)
    limit = max(2, 10 * alone)
    print(f"{kind}: {crowd.tried} idle connections tried; late clients in after {wait:.3f} s, {max(waits):.2f} at most;"
          f" without idle connections after {alone:.3f} s")
    if wait > limit: sys.exit(f"FAIL {kind}: limit {limit:.2f} s, waits {waits}, without idle connections {controls}")
    crowd = None
END
