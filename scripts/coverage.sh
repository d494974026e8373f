#!/usr/bin/env bash
# Runs the test programs with every line counted, and says what part of each folder of src/ they run; files and lines
# that none runs are in build/coverage/. `make coverage` calls it.
#   scripts/coverage.sh [AREA]...     areas of tests/ [all but diagnosis and build]
#   scripts/coverage.sh --report      writes doc/results/coverage.md from what was measured last
# Example: scripts/coverage.sh framework robot
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
report() {
  local page=doc/results/coverage.md machine
  machine=$(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo | sed -n 1p)
  [[ -s build/coverage/folders.txt ]] || { echo "coverage.sh: nothing was measured yet: make coverage" >&2; exit 2; }
  {
    echo "# Measured: which lines the tests run"
    echo
    echo "\`make coverage\`, written by \`scripts/coverage.sh --report\` on $(date -u -r build/coverage/folders.txt +%Y-%m-%d), $(nproc) cores of ${machine:-an unknown CPU}."
    echo
    echo "Counted are the lines of code of \`src/\` that the test programs of these folders of \`tests/\` run: $(cat build/coverage/areas.txt)."
    echo "Scripts, which run whole programs (\`tests/e2e\`), are left out, and so is \`src/main\`, which they run. \`tests/diagnosis\` takes too long to be counted, so some files of \`src/gap/diagnosis\` that it tests have 0 %."
    printf '\n| folder | lines run | lines |\n|---|---|---|\n'
    awk '{ print "| `" $1 "` | " $2 " % | " $5 " |" }' build/coverage/folders.txt
    printf '\n## Files of which least is run\n\nOf 20 lines of code and more.\n\n| file | lines run | lines |\n|---|---|---|\n'
    awk '$3 >= 20 && $4 !~ /^src\/main\// { print "| `" $4 "` | " $1 " % | " $3 " |" }' build/coverage/files.txt | LC_ALL=C sort -t'|' -k3,3n | sed 30q
  } > "$page.new" && mv "$page.new" "$page" && echo "$page"
}
[[ ${1-} == --report ]] && { report; exit; }
areas=("$@") part=$#
((part)) || mapfile -t areas < <(find tests -mindepth 1 -maxdepth 1 -type d ! -name bench ! -name support ! -name data \
  ! -name diagnosis ! -name build ! -name e2e -printf '%f\n' | LC_ALL=C sort)
find build/Coverage/cmake -name '*.gcda' -delete 2> /dev/null || true
status=0
scripts/run_tests.sh Coverage "${areas[@]}" || status=$?
rm -rf build/coverage
mkdir -p build/coverage
echo "${areas[*]}" > build/coverage/areas.txt
# A line counts once, however many programs and templates it is in. Of objects that no program ran there is no .gcda beside
# the .gcno: their lines count as not run.
find build/Coverage/cmake -name '*.gcno' -print0 | xargs -0 -r gcov -t -r 2> /dev/null | awk '
  /^ *-: +0:Source:/ { file = $0; sub(/.*:Source:/, "", file); wanted = file ~ /^src\//; next }
  wanted && match($0, /^ *([0-9]+\*?|#+|=+): *[0-9]+:/) {
    split($0, part, ":"); gsub(/ /, "", part[1]); gsub(/ /, "", part[2])
    key = file SUBSEP part[2]
    if (!(key in all)) all[key] = 0
    if (part[1] ~ /^[0-9]/ && part[1] + 0 > 0) all[key] = 1
  }
  END {
    for (key in all) {
      split(key, k, SUBSEP); split(k[1], p, "/")
      ++lines[p[2]]; ++of[k[1]]
      if (all[key]) { ++run[p[2]]; ++runOf[k[1]] } else print k[1] ":" k[2] > "build/coverage/lines.txt"
    }
    for (f in of) printf "%5.1f %% %6d %s\n", 100 * runOf[f] / of[f], of[f], f > "build/coverage/files.txt"
    for (d in lines) printf "%-16s %5.1f %% of %6d lines\n", "src/" d, 100 * run[d] / lines[d], lines[d]
  }' | LC_ALL=C sort > build/coverage/folders.txt
for file in lines files; do [[ ! -f build/coverage/$file.txt ]] || LC_ALL=C sort -t: -k1,1 -k2n -o build/coverage/$file.txt build/coverage/$file.txt; done
# Of other folders only headers were met.
if ((part)); then
  for list in folders files; do
    grep -E "src/($(IFS='|'; echo "${areas[*]}"))[ /]" build/coverage/$list.txt > build/coverage/$list.new || true
    mv build/coverage/$list.new build/coverage/$list.txt
  done
fi
cat build/coverage/folders.txt
exit $status
