#!/usr/bin/env bash
# Checks that includes only point down the floors of src/ (doc/architecture.md), and that no other module includes a
# platform's folders. Also that USES of each src/*/CMakeLists.txt is what its sources include from and what the page has, that no folders include
# each other in a circle and that no two headers have the same name. And that each module src/modules/AREA/NAME.h has its test
# tests/modules/AREA/NAMETest.cpp.
# Each offender: file:line: why. Example: scripts/check_floors.sh
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
noArguments "$@"
cd "$(dirname "${BASH_SOURCE[0]}")/.."

files=$(find src -type f \( -name '*.h' -o -name '*.cpp' -o -name '*.c' \) | LC_ALL=C sort)
folders=$(find src -type d | LC_ALL=C sort)
status=0

# Ground floor first; "walking" and "motion" stand beside the representations: "walking" sees only
# parameters, math, robot and optimization, "motion" the framework's readers of files as well.
awk '
  BEGIN {
    count = split("parameters math framework field robot optimization simspark tunnel simulation servo representations walking motion trials tactics inspect dds record pages modules training gap game watch web situation main", f, " ")
    for (i = 1; i <= count; ++i) floorOf[f[i]] = i
    split("parameters math robot optimization walking", w, " ")
    for (i in w) may["walking " w[i]] = may["motion " w[i]] = 1
    may["walking walking"] = may["motion motion"] = may["motion framework"] = 1
  }
  FNR == 1 { split(FILENAME, path, "/"); here = path[2] }
  /^[ \t]*#[ \t]*include[ \t]*"/ {
    target = $0
    sub(/^[^"]*"/, "", target); sub(/".*/, "", target)
    there = target
    if (target ~ /^\.\.?\//) { say("relative include \"" target "\": write the path from src/"); next }
    if (!sub(/\/.*/, "", there) || !(there in floorOf)) next
    if (!(here in floorOf)) { say("folder src/" here " has no floor: add it to scripts/check_floors.sh"); next }
    if ((here == "walking" || here == "motion") && !((here " " there) in may)) say("src/" here " may include parameters, math, robot and optimization only, not \"" target "\"")
    else if (floorOf[there] > floorOf[here]) say("src/" here " must not look up to \"" target "\"")
  }
  function say(what) { print FILENAME ":" FNR ": " what; ++bad }
  END { if (bad) { print "check_floors: " bad " include(s) point up" > "/dev/stderr"; exit 1 } }
' $files < /dev/null || status=1

# A platform is a folder of src/modules/ that registers one; a folder of src/ of its name is its wire. Only its own modules
# include them.
platforms=$(grep -rl '^MAKE_PLATFORM(' src/modules 2> /dev/null | sed 's#^src/modules/##; s#/.*##' | LC_ALL=C sort -u | tr '\n' ' ' || true)
awk -v platforms="$platforms" '
  BEGIN { n = split(platforms, p, " "); for (i = 1; i <= n; ++i) isPlatform[p[i]] = 1 }
  FNR == 1 { split(FILENAME, path, "/"); here = path[2] == "modules" ? path[3] : "" }
  here != "" && /^[ \t]*#[ \t]*include[ \t]*"/ {
    target = $0
    sub(/^[^"]*"/, "", target); sub(/".*/, "", target)
    split(target, to, "/")
    there = to[1] == "modules" ? to[2] : to[1]
    if (there in isPlatform && there != here) {
      print FILENAME ":" FNR ": only modules of the platform " there " include \"" target "\""; bad = 1
    }
  }
  END { exit bad }' $files < /dev/null || status=1

# The table of folders in doc/architecture.md has USES, too; its remarks in brackets do not count.
[[ ! -e doc/architecture.md ]] || awk '
  function sorted(text,   n, i, j, w, t, all) {
    n = split(text, w, /[ ,]+/)
    for (i = 1; i <= n; ++i) for (j = i + 1; j <= n; ++j) if (w[j] < w[i]) { t = w[i]; w[i] = w[j]; w[j] = t }
    for (i = 1; i <= n; ++i) if (w[i] != "" && w[i] != "-") all = all (all == "" ? "" : ", ") w[i]
    return all
  }
  FILENAME ~ /[.]md$/ {
    if (!/^\| `src\/[a-z]+\/` \|/) next
    name = $0; sub(/^\| `src\//, "", name); sub(/\/.*/, "", name)
    cell = $0; sub(/ *\| *$/, "", cell); sub(/.* \| /, "", cell); gsub(/\([^)]*\)/, "", cell)
    written[name] = sorted(cell); line[name] = FNR
    next
  }
  FNR == 1 { split(FILENAME, path, "/"); here = path[2] }
  { sub(/#.*/, "") }
  /plumbline_library\(/ { text = ""; listing = 1 }
  listing { text = text " " $0; if (/\)/) { listing = 0
    uses = text ~ / USES / ? text : ""; sub(/.* USES /, "", uses); sub(/ [A-Z_]+ .*/, "", uses); sub(/\).*/, "", uses)
    if (!(here in line)) print "doc/architecture.md: the table of folders lacks src/" here "/"
    else if (written[here] == sorted(uses)) next
    else print "doc/architecture.md:" line[here] ": src/" here " uses " sorted(uses) ", not " written[here]
    bad = 1 } }
  END { exit bad }' doc/architecture.md $(grep -ls 'plumbline_library(' src/*/CMakeLists.txt | LC_ALL=C sort) || status=1

# What a folder includes from is in USES of its CMakeLists.txt, or in USES of what that uses; each of USES is included from.
libraries=$(grep -ls 'plumbline_library(' src/*/CMakeLists.txt | LC_ALL=C sort || true)
awk '
  FNR == 1 { split(FILENAME, path, "/"); here = path[2]; listing = inUses = 0 }
  FILENAME ~ /\/CMakeLists[.]txt$/ {
    sub(/#.*/, "")
    if (sub(/.*plumbline_library\(/, "")) { listing = 1; isLibrary[here] = 1 }
    if (!listing) next
    ends = sub(/\).*/, "")
    n = split($0, word, /[ \t]+/)
    for (i = 1; i <= n; ++i) {
      if (word[i] ~ /^[A-Z_]+$/) inUses = word[i] == "USES"
      else if (inUses && word[i] != "") { uses[here] = uses[here] " " word[i]; where[here, word[i]] = FILENAME ":" FNR }
    }
    if (ends) listing = inUses = 0
    next
  }
  function reach(from, to,   i, n, u) {
    if (from == to) return 1
    if (from in seen) return 0
    seen[from] = 1
    n = split(uses[from], u, " ")
    for (i = 1; i <= n; ++i) if (reach(u[i], to)) return 1
    return 0
  }
  here in isLibrary && /^[ \t]*#[ \t]*include[ \t]*"/ {
    there = $0
    sub(/^[^"]*"/, "", there); sub(/".*/, "", there)
    target = there
    if (!sub(/\/.*/, "", there) || !(there in isLibrary)) next
    included[here, there] = 1
    if (!((here, there) in can)) { split("", seen); can[here, there] = reach(here, there) }
    if (!can[here, there]) {
      print FILENAME ":" FNR ": src/" here " does not use \"" target "\": add " there " to USES in src/" here "/CMakeLists.txt"
      bad = 1
    }
  }
  END {
    for (pair in where) {
      split(pair, p, SUBSEP)
      if (pair in included) continue
      print where[pair] ": src/" p[1] " includes nothing from src/" p[2] ": take " p[2] " out of USES"
      bad = 1
    }
    exit bad
  }' $libraries $files < /dev/null | LC_ALL=C sort || status=1

# Folders that include each other, also round about: take away, again and again, each folder that includes none of the
# others; what stays is in a circle or includes one.
awk -v folders="$folders" '
  BEGIN {
    n = split(folders, f, "\n"); for (i = 1; i <= n; ++i) isFolder[f[i]] = 1
  }
  FNR == 1 { here = FILENAME; sub(/\/[^\/]*$/, "", here) }
  /^[ \t]*#[ \t]*include[ \t]*"/ {
    there = $0
    sub(/^[^"]*"/, "", there); sub(/".*/, "", there)
    if (!sub(/\/[^\/]*$/, "", there)) next
    there = "src/" there
    if (there == here || !(there in isFolder)) next
    edge = here " " there
    if (!(edge in where)) where[edge] = FILENAME ":" FNR
  }
  END {
    for (edge in where) { left[edge] = 1; split(edge, p, " "); ++outOf[p[1]]; ++into[p[2]] }
    do { # both ends of what hangs on a circle go
      gone = 0
      for (edge in left) {
        split(edge, p, " ")
        if (!outOf[p[2]] || !into[p[1]]) { delete left[edge]; --outOf[p[1]]; --into[p[2]]; gone = 1 }
      }
    } while (gone)
    for (edge in left) { split(edge, p, " "); print where[edge] ": " p[1] " and " p[2] " are in a circle of folders"; bad = 1 }
    exit bad
  }' $files < /dev/null | LC_ALL=C sort || status=1

# A name is one file: what two headers are called by says of neither what it holds.
headers=(src)
for folder in tests utils; do [[ ! -d $folder ]] || headers+=("$folder"); done
find "${headers[@]}" -type f -name '*.h' | LC_ALL=C sort | awk '
  { name = $0; sub(/.*\//, "", name) }
  name in first { print $0 ":1: " first[name] " has this name too"; bad = 1; next }
  { first[name] = $0 }
  END { exit bad }' || status=1

# What a reader looks for beside a module's name.
while IFS= read -r header; do
  test=tests/${header#src/}
  [[ -e ${test%.h}Test.cpp ]] || { echo "$header:1: this module has no test ${test%.h}Test.cpp"; status=1; }
done < <(grep -rl --include='*.h' '^MODULE(' src/modules 2> /dev/null | LC_ALL=C sort || true)
exit $status
