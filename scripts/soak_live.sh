#!/usr/bin/env bash
# An agent plays for hours, as fast as possible, while everything that observes it is on: two consoles that watch, a
# page, a log, and another agent that reads its representations. Prints memory and processor time per cycle at the
# beginning and at the end, and writes them to build/bench/live_soak.json, from where `scripts/make_results.sh live`
# takes them.
#   scripts/soak_live.sh [HOURS]    simulated hours [0.1]
# Example: scripts/soak_live.sh 5
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
bin=${PLUMBLINE_BIN:-bin}
hours=${1:-0.1}
(($# <= 1)) && [[ $hours =~ ^[0-9]+(\.[0-9]+)?$ ]] && awk "BEGIN { exit !($hours >= 0.02 && $hours <= 1000) }" || {
  echo "soak_live.sh: give simulated hours from 0.02 to 1000, not '$*'; see soak_live.sh --help" >&2
  exit 2
}
scratch=$(mktemp -d)
children=()
end() {
  local status=$?
  if ((${#children[@]})); then kill "${children[@]}" 2> /dev/null || true; fi
  wait 2> /dev/null || true
  rm -rf "$scratch"
  exit "$status"
}
trap end EXIT
trap 'exit 130' INT TERM
fail() {
  echo "soak_live.sh: $*; the agent's last words:" >&2
  tail -3 "$scratch/agent.err" >&2
  exit 1
}

cp -r config "$scratch/config"
echo "domain: $((100 + $$ % 100))" >> "$scratch/config/NetworkModule.yaml"
printf 'fileMegabytes: 64\nfiles: 4\n' > "$scratch/config/log.yaml" # or five hours fill a disk
{ echo "include $scratch/config/platforms/simspark/modules.cfg"; echo network; } > "$scratch/shows.cfg"
"$bin/agent" --config "$scratch/config" --modules "$scratch/shows.cfg" --start-simulator --simulator-option=--sync --simulator-option=--seed --simulator-option=1 \
  --simulator-option=--half-time --simulator-option=100000 --simulator-option=--kickoff-after --simulator-option=1 \
  --debug 0 --web 0 --log "$scratch/log" --crash-log "$scratch/crash.log" > "$scratch/agent.out" 2> "$scratch/agent.err" &
agent=$!
children+=("$agent")
for ((i = 0; i < 1200; ++i)); do
  grep -qs 'debug port' "$scratch/agent.err" && grep -qs 'page http' "$scratch/agent.err" && break
  kill -0 "$agent" 2> /dev/null || fail "the agent does not start"
  sleep 0.1
done
debug=127.0.0.1:$(sed -n 's/.*debug port 127.0.0.1:\([0-9]*\):.*/\1/p' "$scratch/agent.err")
page=$(sed -n 's#.*page http://localhost:\([0-9]*\)/$#\1#p' "$scratch/agent.err")
[[ $page ]] || fail "no page: make web builds it"

"$bin/rdb" "$debug" --exec 'watch r:BallPos every 10' > /dev/null 2>&1 &
children+=($!)
"$bin/rdb" "$debug" --exec 'watch r:RobotPose every 0.1s' > /dev/null 2>&1 &
children+=($!)
"$bin/agent" --config "$scratch/config" --platform watcher --debug 0 --crash-log "$scratch/watcher.crash" > /dev/null 2> "$scratch/watcher.err" &
watcher=$!
children+=("$watcher")
# A page: a WebSocket whose frames, as RFC 6455 has them, carry the mask zero.
readPage() {
  local text
  exec 4<> "/dev/tcp/127.0.0.1/$page"
  printf 'GET / HTTP/1.1\r\nHost: localhost:%s\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n' "$page" >&4
  printf 'Sec-WebSocket-Key: c29haywgYSBsb25nIG9uZQ==\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Protocol: plumbline\r\n\r\n' >&4
  for text in '#1 watch representation:JointData every 0.04s' '#2 watch representation:RobotPose every 0.04s' '#3 graph'; do
    printf "\\x81\\x$(printf %02x $((128 + ${#text})))\\x00\\x00\\x00\\x00%s" "$text" >&4
  done
  head -c 20000 <&4 > "$scratch/page"
  cat <&4 > /dev/null
}
readPage &
children+=($!)

cycle() { "$bin/rdb" "$debug" --exec 'get r:FrameInfo.cycle' 2> /dev/null | sed 's/.* //'; }
memory() { awk '/^VmRSS:/ { print $2 }' "/proc/$1/status"; }                       # kB
processor() { awk -v hz="$(getconf CLK_TCK)" '{ sub(/.*\) /, ""); print ($12 + $13) / hz }' "/proc/$1/stat"; } # s
last=$(awk "BEGIN { print int($hours * 3600 * 50) }")
step=$(awk "BEGIN { s = $last / 20; print int(s < 500 ? 500 : s) }")
next=$step
echo "simulated hours   memory [MB]   processor time per cycle [us]   reader's memory [MB]"
before=0 cpuBefore=0
while :; do
  now=$(cycle) || true
  [[ $now ]] || fail "the agent no longer answers"
  if ((now >= next || now >= last)); then
    cpu=$(processor "$agent")
    awk -v c="$now" -v b="$before" -v cpu="$cpu" -v was="$cpuBefore" -v m="$(memory "$agent")" -v w="$(memory "$watcher")" 'BEGIN {
      printf "%15.3f %13.1f %31.1f %22.1f\n", c / 180000, m / 1000, 1e6 * (cpu - was) / (c - b), w / 1000 }' | tee -a "$scratch/table"
    before=$now cpuBefore=$cpu
    while ((next <= now)); do next=$((next + step)); done
  fi
  ((now >= last)) && break
  sleep 0.5
done
[[ ! -e $scratch/crash.log ]] || fail "the agent crashed"
kill -0 "$watcher" || fail "the reader is gone: $(tail -1 "$scratch/watcher.err")"
grep -aq 'representation:JointData' "$scratch/page" || fail "the page got nothing"
there=127.0.0.1:$(sed -n 's/.*debug port 127.0.0.1:\([0-9]*\):.*/\1/p' "$scratch/watcher.err")
[[ $("$bin/rdb" "$there" --exec 'get r:SensorData.acc.z') != *' 9.810000' ]] || fail "the reader was sent nothing"
du -sm "$scratch/log" | awk '{ print "the log: " $1 " MB" }'
# The first line holds the start; memory that is taken once is taken by the second.
mkdir -p build/bench
awk '
  function figure(name, value, unit, target) {
    printf "%s {\"name\": \"live.soak_of_%s_h.%s\", \"value\": %.4g, \"unit\": \"%s\", \"better\": \"lower\"%s}", (n++ ? ",\n" : "[\n"), hours, name, value, unit, (target == "" ? "" : ", \"target\": " target)
  }
  { m[NR] = $2; c[NR] = $3; w[NR] = $4 }
  END {
    if (NR < 4) exit 1
    figure("memory_first", m[2], "MB", ""); figure("memory_last", m[NR], "MB", sprintf("%.4g", 1.1 * m[2]))
    figure("cpu_per_cycle_first", c[2], "us", ""); figure("cpu_per_cycle_last", c[NR], "us", sprintf("%.4g", 1.2 * c[2]))
    figure("readers_memory_first", w[2], "MB", ""); figure("readers_memory_last", w[NR], "MB", sprintf("%.4g", 1.1 * w[2]))
    print "\n]"
  }' hours="$hours" "$scratch/table" > build/bench/live_soak.json.new
mv build/bench/live_soak.json.new build/bench/live_soak.json
echo "build/bench/live_soak.json; scripts/make_results.sh live puts it into doc/results/live.md"
