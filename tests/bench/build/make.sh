#!/usr/bin/env bash
# How long building takes, without the compiler cache, in a copy of the tree: what `make run` compiles from nothing. Also the agent
# after one line was added to a module, for the first and the largest source of each folder, and make when nothing changed. Seconds of
# the clock, and of the processor, which other programs hardly change. Packages are installed before. Writes build/bench/build.json and
# build.md. `make bench-build` writes doc/results/build.md.
set -euo pipefail
root=$(cd "$(dirname "$0")/../../.." && pwd)
unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES
cd "$root"
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
mkdir -p "$copy/bin" "$copy/build"
cp -a configure.sh Makefile CMakeLists.txt CMakePresets.json cmake scripts src utils tests "$copy/"
cp -a bin/*.sh "$copy/bin/"
cd "$copy"

# Runs a command; its seconds are then in $clock and $cpu, its output in log.txt.
timed() {
  local TIMEFORMAT='%R %U %S' user system
  { time "$@" > log.txt 2>&1; } 2> time.txt || { cat log.txt >&2; return 1; }
  read -r clock user system < time.txt
  cpu=$(awk "BEGIN { print $user + $system }")
}
steps() { grep -c '\] C++' log.txt || true; }

CCACHE="" timed scripts/build.sh SimRelease agent simulator game
fromNothing=$clock fromNothingCpu=$cpu compiled=$(steps)
echo "from nothing: $clock s, $cpu s of the processor"

: > changes.tsv
mapfile -t modules < <(for folder in $(find src/modules -name '*.cpp' -printf '%h\n' | LC_ALL=C sort -u); do
  find "$folder" -maxdepth 1 -name '*.cpp' | LC_ALL=C sort | sed -n 1p
  find "$folder" -maxdepth 1 -name '*.cpp' -printf '%s %p\n' | LC_ALL=C sort -n | sed -n '$s/^[0-9]* //p'
done | LC_ALL=C sort -u)
for module in "${modules[@]}"; do
  printf '// changed\n' >> "$module"
  CCACHE="" timed scripts/build.sh SimRelease agent
  printf '%s\t%s\t%s\t%s\n' "$module" "$clock" "$cpu" "$(steps)" >> changes.tsv
  echo "$module: $clock s, $cpu s of the processor"
done
timed make SimRelease # the other programs, from the cache where there is one
timed make SimRelease
grep -q "^Nothing to be done" log.txt
nothing=$clock

mkdir -p "$root/build/bench"
awk -F'\t' -v nothing="$nothing" -v all="$fromNothing" -v allCpu="$fromNothingCpu" -v compiled="$compiled" \
  -v load="$(cut -d ' ' -f 1 /proc/loadavg)" -v json="$root/build/bench/build.json" '
  { module[NR] = $1; clock[NR] = $2 + 0; cpu[NR] = $3 + 0; steps[NR] = $4
    for (i = NR; i > 1 && sorted[i - 1] > $2 + 0; --i) sorted[i] = sorted[i - 1]
    sorted[i] = $2 + 0 }
  END {
    median = NR % 2 ? sorted[(NR + 1) / 2] : (sorted[NR / 2] + sorted[NR / 2 + 1]) / 2
    printf "Without the compiler cache, with all packages there; the machine had a load of %s at the end.\n\n", load
    print "| what | seconds | seconds of the processor | compiled |\n|---|---|---|---|"
    printf "| agent, simulator and game from nothing (`make run`) | %.0f | %.0f | %d |\n", all, allCpu, compiled
    printf "| `make` when nothing changed | %.2f | | 0 |\n", nothing
    print "\nOne line added to the first and the largest source of each folder with modules, until `bin/agent` is linked:\n"
    print "| source | seconds | seconds of the processor | compiled |\n|---|---|---|---|"
    for (i = 1; i <= NR; ++i) printf "| `%s` | %.1f | %.1f | %d |\n", module[i], clock[i], cpu[i], steps[i]
    printf "[\n  {\"name\": \"build.run_from_nothing\", \"value\": %s, \"unit\": \"s\", \"better\": \"lower\", \"target\": 180},\n", all > json
    printf "  {\"name\": \"build.run_from_nothing_cpu\", \"value\": %s, \"unit\": \"s\", \"better\": \"lower\"},\n", allCpu > json
    printf "  {\"name\": \"build.make_nothing_changed\", \"value\": %s, \"unit\": \"s\", \"better\": \"lower\", \"target\": 1},\n", nothing > json
    printf "  {\"name\": \"build.one_line_to_agent_median\", \"value\": %s, \"unit\": \"s\", \"better\": \"lower\", \"target\": 5},\n", median > json
    printf "  {\"name\": \"build.one_line_to_agent_most\", \"value\": %s, \"unit\": \"s\", \"better\": \"lower\", \"target\": 5}\n]\n", sorted[NR] > json
  }' changes.tsv > "$root/build/bench/build.md"
cat "$root/build/bench/build.md"
