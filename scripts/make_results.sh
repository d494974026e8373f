#!/usr/bin/env bash
# Writes doc/results/<area>.md from the figures in build/bench/<area>*.json (`make bench` measures them), with the
# machine and the date, and copies the diagrams build/bench/<area>*.svg there. `make results` does both.
#   scripts/make_results.sh [AREA...]
# Example: scripts/make_results.sh walking
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
areas=("$@")
((${#areas[@]})) || mapfile -t areas < <(find build/bench -name '*.json' -printf '%f\n' 2> /dev/null | sed 's/[._].*//' | LC_ALL=C sort -u)
((${#areas[@]})) || { echo "make_results.sh: no figures in build/bench; run make bench first" >&2; exit 1; }
mkdir -p doc/results
machine=$(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo | sed -n 1p)
for area in "${areas[@]}"; do
  files=()
  for file in build/bench/"$area".json build/bench/"$area".*.json build/bench/"$area"_*.json; do [[ -s $file ]] && files+=("$file"); done
  ((${#files[@]})) || { echo "make_results.sh: no figures of $area" >&2; exit 1; }
  {
    echo "# Measured: $area"
    echo
    bench=${area/#games-*/games}
    echo "Written by \`make results\` (\`make bench-${bench/#walking/walk}\` measures) on $(date -u +%Y-%m-%d), $(nproc) cores of ${machine:-an unknown CPU}, $(c++ --version | sed -n 1p)."
    echo "Seeds and numbers of runs are part of each figure's name or fixed in \`tests/bench/${bench/#walking-*/walking}/\`."
    echo
    # Tables that the benchmark wrote itself come before the bare figures.
    if [[ -s build/bench/$area.md ]]; then
      cat "build/bench/$area.md"
      printf '\n## All figures\n\n'
    fi
    awk '
      function field(text, key,   found) {
        if (!match(text, "\"" key "\"[ \t\n]*:[ \t\n]*(\"[^\"]*\"|[^,}\n]*)")) return ""
        found = substr(text, RSTART, RLENGTH); sub(/^"[^"]*"[ \t\n]*:[ \t\n]*/, "", found); gsub(/^"|"$|[ \t]+$/, "", found)
        return found == "null" ? "" : found
      }
      BEGIN { RS = "}"; print "| figure | value | unit | target | met | peer |\n|---|---|---|---|---|---|" }
      {
        name = field($0, "name"); if (name == "") next
        value = field($0, "value"); target = field($0, "target"); peer = field($0, "peer"); peerValue = field($0, "peer_value")
        met = target == "" ? "" : (field($0, "better") == "higher" ? value + 0 >= target + 0 : value + 0 <= target + 0) ? "yes" : "no"
        if (peerValue != "") peer = (peer == "" ? "" : peer ": ") sprintf("%.4g", peerValue)
        printf "| `%s` | %.4g | %s | %s | %s | %s |\n", name, value, field($0, "unit"), target == "" ? "" : sprintf("%.4g", target), met, peer
      }' "${files[@]}"
  } > "doc/results/$area.md.new"
  mv "doc/results/$area.md.new" "doc/results/$area.md"
  for file in build/bench/"$area".svg build/bench/"$area"_*.svg; do [[ ! -s $file ]] || cp "$file" doc/results/; done
  echo "doc/results/$area.md"
done
