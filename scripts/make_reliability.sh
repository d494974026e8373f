#!/usr/bin/env bash
# Writes doc/results/reliability.md from what `make fuzz`, `make faults`, `make kills`, `make soak` and `make coverage` left
# in build/; what was not run on this machine is said to be missing.
#   scripts/make_reliability.sh
# Example: make faults && scripts/make_reliability.sh
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
noArguments "$@"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
page=doc/results/reliability.md
machine=$(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo | sed -n 1p)
# The text that people wrote: what stands above the first mark and below the last.
mark='<!-- measured -->' end='<!-- /measured -->'
grep -qF "$mark" $page && grep -qF "$end" $page || { echo "make_reliability.sh: $page has no place for figures ($mark ... $end)" >&2; exit 2; }
dated() { date -u -r "$1" +%Y-%m-%d; }
# A table of words as one of Markdown; the last line is a sentence.
table() { # file, first line to take
  sed '$d' "$1" | awk '{ line = "|"; for (i = 1; i <= NF; ++i) line = line " " $i " |"; print line; if (NR == 1) { gsub(/[^|]+/, "---", line); print line } }'
  printf '\n%s.\n' "$(tail -1 "$1")"
}
missing() { printf 'Not measured here: `%s`.\n' "$1"; }
{
  sed "/$mark/q" $page
  echo
  echo "Measured on $(nproc) cores of ${machine:-an unknown CPU}, written by \`scripts/make_reliability.sh\`."
  printf '\n## Readers under libFuzzer\n\n'
  if [[ -s build/fuzz/table.txt ]]; then
    echo "\`make fuzz\`, $(dated build/fuzz/table.txt):"
    echo
    sed 's/nothing found/nothing/' build/fuzz/table.txt > build/fuzz/words.txt
    table build/fuzz/words.txt
  else missing "make fuzz"; fi
  printf '\n## Damaged inputs in every test run\n\n'
  cat tests/fuzz/*.cpp | awk '
    /^const Registered/ { open = 1 }
    open { line = line $0 }
    open && /;$/ { match(line, /[0-9]+\}\);$/); inputs += substr(line, RSTART); quarter += int(substr(line, RSTART) / 4); ++n; line = ""; open = 0 }
    END { printf "%d readers: %d damaged inputs in a release build, the first quarter of them (%d) under the sanitizers in `make test`.\n", n, inputs, quarter }'
  printf '\n## Calls of the system that fail\n\n'
  if [[ -s build/faults/table.txt ]]; then
    echo "\`make faults\`, $(dated build/faults/table.txt): how often each kind of call was made to fail, and how often a program then"
    echo "ended without saying why, or left a file half written."
    echo
    table build/faults/table.txt
  else missing "make faults"; fi
  printf '\n## Kills\n\n'
  if [[ -s build/faults/kills.txt ]]; then
    echo "\`make kills\`, $(dated build/faults/kills.txt): how often each program was killed, its recording was readable, and the same"
    echo "command came to the same bytes as without the kill."
    echo
    table build/faults/kills.txt
  else missing "make kills"; fi
  printf '\n## Long games\n\n'
  if [[ -s build/soak/summary.txt ]]; then
    echo "\`make soak\`, $(dated build/soak/summary.txt): $(cat build/soak/summary.txt)."
  else missing "make soak"; fi
  printf '\n## Lines that the tests run\n\n'
  if [[ -s build/coverage/folders.txt ]]; then
    echo "\`make coverage\`, $(dated build/coverage/folders.txt):"
    printf '\n| folder | lines run | lines |\n|---|---|---|\n'
    awk '{ print "| `" $1 "` | " $2 " % | " $5 " |" }' build/coverage/folders.txt
  else missing "make coverage"; fi
  echo
  sed -n "/${end//\//\\/}/,\$p" $page
} > $page.new
mv $page.new $page
echo $page
