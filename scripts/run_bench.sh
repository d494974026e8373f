#!/usr/bin/env bash
# Runs the benchmarks that are built (all, or those of the areas named), one after the other, and prints a table.
# Each leaves build/bench/<area>.json: a list of {"name", "value", "unit", "better", "target", "peer", "peer_value"}.
# A plain program or a script tests/bench/<area>/*.sh writes that file itself; the output of a program made with
# Google Benchmark is turned into it (a counter named "target" or "peer_value" becomes that field).
# BENCH_ARGS: arguments of plain programs.
# Example: scripts/run_bench.sh gap
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
mkdir -p build/bench
areas=("$@")
((${#areas[@]})) || mapfile -t areas < <({
  find tests/bench -mindepth 1 -maxdepth 1 -type d -printf '%f\n'
  find tests/bench -mindepth 1 -maxdepth 1 -name '*.cpp' -printf '%f\n' | sed 's/\.cpp$//'
} 2> /dev/null | LC_ALL=C sort -u)
failed=0

# Google Benchmark's report ($2) of area $1 in the project's form. The time per call is CPU time.
convert() {
  awk -v area="$1" '
    function value(line) { sub(/^[^:]*: */, "", line); sub(/,? *$/, "", line); return line }
    /"benchmarks":/ { inside = 1; next }
    !inside { next }
    /"name":/ { name = value($0); gsub(/"/, "", name); time = ""; unit = ""; target = ""; peer = ""; items = "" }
    /"cpu_time":/ { time = value($0) }
    /"time_unit":/ { unit = value($0) }
    /"target":/ { target = value($0) }
    /"peer_value":/ { peer = value($0) }
    /"error_message":/ { time = "" }
    /^ *}/ && time != "" {
      if (index(name, area ".") != 1) name = area "." name
      printf "%s  {\"name\": \"%s\", \"value\": %s, \"unit\": %s, \"better\": \"lower\"", (count++ ? ",\n" : "[\n"), name, time, unit
      if (target != "") printf ", \"target\": %s", target
      if (peer != "") printf ", \"peer_value\": %s", peer
      printf "}"; time = ""
    }
    END { if (count) print "\n]"; else exit 1 }' "$2"
}

for area in "${areas[@]}"; do
  program=build/SimRelease/bench/$area
  log=build/bench/$area.log
  : > "$log"
  echo "bench $area (how far it is: tail -f $log)"
  if [[ -x $program ]]; then
    if ldd "$program" | grep -q libbenchmark; then
      if "$program" --benchmark_out="build/bench/$area.raw" --benchmark_out_format=json >> "$log" 2>&1 &&
        convert "$area" "build/bench/$area.raw" > "build/bench/$area.json.new"; then
        mv "build/bench/$area.json.new" "build/bench/$area.json"
      else
        echo "run_bench.sh: $program failed; see $log" >&2; failed=1
      fi
      rm -f "build/bench/$area.raw" "build/bench/$area.json.new"
    elif ! "$program" ${BENCH_ARGS-} >> "$log" 2>&1; then
      echo "run_bench.sh: $program failed; see $log" >&2; failed=1
    fi
  fi
  for script in tests/bench/"$area"/*.sh; do
    [[ -x $script ]] || continue
    "$script" >> "$log" 2>&1 || { echo "run_bench.sh: $script failed; see $log" >&2; failed=1; }
  done
done

# The table: every figure there is of these areas.
files=()
for area in "${areas[@]}"; do
  for file in build/bench/"$area".json build/bench/"$area".*.json build/bench/"$area"_*.json; do [[ -s $file ]] && files+=("$file"); done
done
((${#files[@]})) || { echo "run_bench.sh: no figures written" >&2; exit 1; }
awk '
  function field(text, key,   found) {
    if (!match(text, "\"" key "\"[ \t\n]*:[ \t\n]*(\"[^\"]*\"|[^,}\n]*)")) return ""
    found = substr(text, RSTART, RLENGTH); sub(/^"[^"]*"[ \t\n]*:[ \t\n]*/, "", found); gsub(/^"|"$|[ \t]+$/, "", found)
    return found == "null" ? "" : found
  }
  BEGIN { RS = "}"; printf "\n%-52s %14s %-10s %12s %-5s %s\n", "figure", "value", "unit", "target", "met", "peer" }
  {
    name = field($0, "name"); if (name == "") next
    value = field($0, "value"); target = field($0, "target"); better = field($0, "better"); peer = field($0, "peer")
    peerValue = field($0, "peer_value")
    met = ""
    if (target != "") met = (better == "higher" ? value + 0 >= target + 0 : value + 0 <= target + 0) ? "yes" : "NO"
    printf "%-52s %14.6g %-10s %12s %-5s %s%s\n", name, value, field($0, "unit"), (target == "" ? "" : target + 0), met, peer, (peerValue == "" ? "" : (peer == "" ? "" : " ") peerValue)
  }' "${files[@]}"
exit $failed
