#!/usr/bin/env bash
# Writes doc/results/reliability.md from what `make fuzz`, `make faults`, `make kills`, `make stops` and `make soak` left
# in build/. What was not run here keeps the section that the page has, and each section says where and when it was measured.
# Jobs and targets that a run of `make fuzz`, `make faults`, `make kills` or `make stops` leaves out keep their rows of the page.
#   scripts/make_reliability.sh
# Example: make faults && scripts/make_reliability.sh
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
noArguments "$@"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
page=doc/results/reliability.md
machine=$(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo | sed -n 1p)
# The text that people wrote: what is above the first mark and below the last.
mark='<!-- measured -->' end='<!-- /measured -->'
grep -qF "$mark" $page && grep -qF "$end" $page || { echo "make_reliability.sh: $page has no place for figures ($mark ... $end)" >&2; exit 2; }
dated() { date -u -r "$1" +%Y-%m-%d; }
# A table of words as one of Markdown; the last line is a sentence.
table() { # file, first line to take
  sed '$d' "$1" | awk '{ line = "|"; for (i = 1; i <= NF; ++i) line = line " " $i " |"; print line; if (NR == 1) { gsub(/[^|]+/, "---", line); print line } }'
  printf '\n%s.\n' "$(tail -1 "$1")"
}
here="$(nproc) cores of ${machine:-an unknown CPU}"
# The section ($1) as it is in the page, or that the command ($2) is to be run.
missing() {
  local before
  before=$(awk -v head="## $1" '$0 == head { on = 1; next } /^## / || /^<!-- \/measured/ { on = 0 } on' $page | sed -e '/./,$!d' | sed -e :a -e '/^\n*$/{$d;N;ba' -e '}')
  if [[ $before ]]; then printf '%s\n' "$before"; else printf 'Not measured yet: `%s`.\n' "$2"; fi
}
# The table ($2) with the rows that the page's section ($1) has of other jobs, where its columns are the same. The last line
# counts what is in it: the sum of columns 2 to $4, whose unit is $3.
joined() {
  missing "$1" "" | awk -v unit="$3" -v last="$4" '
    function put(job, line) { if (!(job in row)) order[++n] = job; row[job] = line }
    FNR == NR && (!/^\|/ || /^\|---/) { next }
    FNR == NR { gsub(/^\| | \|$/, ""); gsub(/ \| /, " "); if (!head) head = $0; else { put($1, $0); old[$1] } next }
    FNR == 1 { $1 = $1; if ($0 != head) { split("", row); n = 0 } print; next }
    $2 == unit || $2 == unit "," { if (match($0, /seed [0-9]+/)) seed = ", " substr($0, RSTART, RLENGTH); next } # its own last line
    { $1 = $1; put($1, $0); delete old[$1]; names = names (names ? ", " : "") $1 }
    END {
      for (i = 1; i <= n; ++i) {
        print row[order[i]]
        count = split(row[order[i]], part, " ")
        for (j = 2; j <= last; ++j) sum += part[j]
        broken += unit == "executions" ? part[5] != "nothing" : part[count]
        older += (order[i] in old)
      }
      of = older ? ". Of this run" seed ": " names : seed ? " (" substr(seed, 3) ")" : ""
      if (unit == "executions") printf "%d executions, %d of %d targets broke%s\n", sum, broken, n, of
      else printf "%d %s in %d jobs, %d broke something%s\n", sum, unit, n, broken, of
    }' - "$2"
}
# A section: title, command, table, two lines about the figures.
measured() {
  printf '\n## %s\n\n' "$1"
  if [[ ! -s $3 ]]; then missing "$1" "$2"; return; fi
  printf '`%s`, %s, %s: %s\n%s\n\n' "$2" "$(dated "$3")" "$here" "$4" "$5"
  case $1 in
    Kills | Stops) joined "$1" "$3" "${1,}" 2 ;;
    Calls*) joined "$1" "$3" faults 6 ;;
  esac > "$3.joined"
  table "$3.joined"
}
{
  sed "/$mark/q" $page
  echo
  echo "Written by \`scripts/make_reliability.sh\`."
  printf '\n## Readers under libFuzzer\n\n'
  if [[ -s build/fuzz/table.txt ]]; then
    echo "\`make fuzz\`, $(dated build/fuzz/table.txt), $here:"
    echo
    sed 's/nothing found/nothing/' build/fuzz/table.txt > build/fuzz/words.txt
    joined "Readers under libFuzzer" build/fuzz/words.txt executions 2 > build/fuzz/joined.txt
    table build/fuzz/joined.txt
  else missing "Readers under libFuzzer" "make fuzz"; fi
  printf '\n## Damaged inputs in every test run\n\n'
  cat tests/fuzz/*.cpp | awk '
    /^const Registered/ { open = 1 }
    open { line = line $0 }
    open && /;$/ { match(line, /[0-9]+\}\);$/); inputs += substr(line, RSTART); quarter += int(substr(line, RSTART) / 4); ++n; line = ""; open = 0 }
    END { printf "%d readers: %d damaged inputs in a release build, the first quarter of them (%d) under the sanitizers in `make test`.\n", n, inputs, quarter }'
  measured "Calls of the system that fail" "make faults" build/faults/table.txt \
    "how often each kind of call was made to fail, and how often a program then" \
    "ended without saying why, or left a file half written. Of writes each failed alone, and with all that follow."
  measured Kills "make kills" build/faults/kills.txt \
    "how often each program was killed, its recording was readable, and the same" \
    "command came to the same bytes as without the kill. Equal folders that kills left were gone on with once."
  measured Stops "make stops" build/stops/table.txt \
    "how often each program got SIGINT or SIGTERM, and how long it then took to" \
    "its end at most [s]. Uncaught: before or after its work, where the signal itself ends it. Slow: over a second, but not again."
  printf '\n## Long games\n\n'
  if compgen -G 'build/soak/*.txt' > /dev/null; then
    for file in build/soak/*.txt; do echo "\`make soak\`, $(dated "$file"), $here: $(cat "$file")." && echo; done
    # Games of other numbers of agents stay.
    missing "Long games" "make soak" | grep "^\`make soak\`" | while read -r line; do
      number=$(sed -n 's/.*: \([0-9]*\) agents, .*/\1/p' <<< "$line")
      [[ -s build/soak/$number.txt ]] || printf '%s\n\n' "$line"
    done
  else missing "Long games" "make soak"; fi
  printf '\n## Lines that the tests run\n\n`make coverage`: [coverage.md](coverage.md).\n'
  echo
  sed -n "/${end//\//\\/}/,\$p" $page
} > $page.new
mv $page.new $page
echo $page
