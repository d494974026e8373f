# Which tests exercise something, for scripts/where.sh, in the root of the tree. Patterns are extended ones of grep.

# Tests and what they share that have a pattern; folders or options of grep. The test of where.sh names things as samples.
naming() {
  grep -rslE "${@:2}" -e "$1" --include='*.cpp' --include='*.h' --include='*.sh' --include='*.bash' --include='*.mjs' \
    --exclude-dir=data --exclude=scripts.sh | sort
}
unitTests() { grep -E '^tests/(.*/)?[^/]*(Test|Targets?)\.cpp$' | grep -vE '^tests/(e2e|bench)/'; } # of a list
once() { awk 'NF && !seen[$0]++'; }
# The names in a list of files; several of one folder and ending as tests/e2e/*.sh: goal log
together() {
  awk '{
      folder = $0; sub(/[^\/]*$/, "", folder); file = substr($0, length(folder) + 1); ending = file; sub(/^[^.]*/, "", ending)
      sub(/\..*/, "", file); key = folder "*" ending
      if (!(key in of)) order[++n] = key
      of[key] = of[key] (++count[key] > 1 ? " " : "") file
      if (count[key] == 1) first[key] = $0
    }
    END { for (i = 1; i <= n; ++i) print (count[order[i]] > 1 ? order[i] ": " of[order[i]] : first[order[i]]) }'
}
# Unit tests of parts (headers): those beside them and those that include them.
testsOfParts() {
  local piece test base
  for piece; do
    test=tests/${piece#src/} test=${test%.h}Test.cpp
    [[ ! -e $test ]] || echo "$test"
    # What is common to many is tested in its own folder.
    base=tests/$(cut -d/ -f2 <<< "$piece")
    [[ ! -d $base ]] || grep -rlF "#include \"${piece#src/}\"" "$base" --include='*Test.cpp' | sort
  done | once
}
# Unit tests that exercise something by what tests share: a header that has a pattern, or functions of a source that name it.
throughFixtures() { # pattern, name
  local fixture header functions user
  naming "$1" tests | grep -vE '(Test|Targets?)\.cpp$|\.(sh|bash|mjs)$|^tests/(bench|e2e)/' | while read -r fixture; do
    grep -vE '^ *//' "$fixture" | grep -qE -e "$1" || continue # a comment names it as an example
    functions='' user=
    [[ $fixture == *.h ]] || functions=$(awk -v name="$2" -f scripts/where_functions.awk "$fixture" | paste -sd '|')
    header=$(basename "${fixture%.*}").h
    grep -rlE "^#include \"(.*/)?$header\"" tests --include='*Test.cpp' --include='*Target*.cpp' | while read -r user; do
      [[ ! $functions ]] || grep -qE "\b($functions)\(" "$user" && echo "$user"
    done
  done
}
# Unit tests beside a configuration of their own that runs a module.
besideConfigurations() { # module
  local file
  grep -rlE "^ *$1( |\$)" tests --include='*.cfg' | while read -r file; do
    grep -rlF "$file" "${file%%/config/*}" --include='*Test.cpp'
  done
}
# Scripts in which an agent runs the lines of files of config/: with a platform's modules.cfg, all that start an agent or a
# game on it; with another file, those that name it.
withAgents() {
  local file platform usual
  local plays='/game"? |/agent"? .*(--(port|start-simulator|replay|host|config)|"\$@")|scripts/match\.sh|start\.sh|set-start\.bash'
  usual=$(sed -nE 's/.* defaultPlatform = "(.*)";/\1/p' src/main/agent.cpp 2> /dev/null)
  for file; do
    case $file in
      config/modules/*) grep -lE "^include +(.*/)?modules/${file##*/}" config/platforms/*/*.cfg 2> /dev/null ;;
      *) echo "$file" ;;
    esac
  done | sort -u | while read -r file; do
    platform=$(basename "$(dirname "$file")")
    if [[ $file != */modules.cfg ]]; then naming "\b$(basename "$file")\b" tests
    elif [[ $platform != "$usual" ]]; then naming "--platform[= ]$platform\b" tests
    else naming "$plays" tests/e2e tests/bench; fi
  done | grep '\.sh$' | sort -u
}
# Tests over all of a kind.
overAll() { # kind, name, file
  local type=${2#simspark_type}
  case $1 in
    module) naming 'Registry::instance\(\)\.modules\(\)' tests ;;
    "keyframe motion")
      [[ $3 != config/motions/* ]] || naming 'contentsOf\("config/motions"' tests
      # Kicks are played one after the other, and those that stand a robot up as it falls.
      ! grep -qE '^(kick|ball):' $3 || naming '\.motions\)' tests
      # MotionSelector's parameters name them.
      ! grep -qsE "\b$2\b" <(sed -n '/^## MotionSelector/,/^## [^M]/p' doc/reference/parameters.md 2> /dev/null) \
        config/MotionSelector.yaml config/robots/*/MotionSelector.yaml || naming '\bnextStandUp\(|\bstandUpTrial\(' tests
      ;;
    "excitation program") naming '\b(hanging|floatingBase)Battery\(|contentsOf\("config/excitation"' tests ;;
    effect) naming '\beffects\(\)' tests && naming '\bgap"? diagnose ' tests/e2e ;;
    effect*) naming '\bleagueEffects\(\)' tests ;;
    optimiser) naming '\boptimizerNames\(\)' tests ;;
    engine*) naming '\bRobotSimulations::names\(\)' tests ;;
    platform) naming '\bPlatforms::names\(\)' tests ;;
    rule) naming 'contentOf\("doc/reference/rules.yaml"|readRules\("doc' tests ;;
    robot)
      naming 'directory_iterator\("config/robots"' tests
      [[ $type == "$2" ]] ||
        naming "\b(numSimsparkTypes|simsparkRobots)\(\)|\btype < 5|Range\(0, 5\)|for type in .*($type|\\$)" tests
      ;;
  esac | grep -vE '\.h$|\.bash$' | sort -u
}

# Prints the rows of tests. From its caller it has:
# - kind, name and file; word, the pattern by which tests name it
# - own, its own test; first, the folder of tests that come first; under, the folder of all [tests]
# - uses, a pattern that the lines of unit tests must have; inScripts, one for all others [both: word]
# - pieces, its parts, or of a keyframe motion who chooses it; agents, the files of config/ that run it
tests() {
  local label='  of parts' all unit shared every programs runs benches mine
  all=$(naming "$word" "${under:-tests}")
  [[ ! ${inScripts-} ]] || all=$(naming "$inScripts|${uses:-$word}" "${under:-tests}")
  mine=$(grep -xF "${own:-none}" <<< "$all")
  unit=$(unitTests <<< "$all")
  [[ ! ${uses-} || ! $unit ]] || unit=$(xargs grep -lE "$uses" <<< "$unit")
  # Its own, those of the source's folder, then by how often they name it.
  unit=$({ echo "$mine"; grep -E "^${first:-none}/" <<< "$unit"
    xargs -r grep -HcE "$word" <<< "$unit" | sort -t : -k2,2nr -k1,1 | cut -d : -f 1; } | once)
  # Many are shortened by their folders.
  row tests "$( (($(wc -l <<< "$unit") <= 12)) && list 12 <<< "$unit" || together <<< "$unit" | list 30)"
  # Situations and other data that its own test reads.
  [[ ! $mine ]] || row '' "$(grep -hoE '"tests/data/[a-z/]+' "$mine" | tr -d '"' | sed 's#/$##' | sort -u | list 4)"
  [[ $kind == key* ]] && label="  of users" # who chooses it
  row "$label" "$(testsOfParts "${pieces[@]}" | grep -vxF "${unit:-none}" | list 12)"
  shared=$({ throughFixtures "${uses:-$word}" "$name"; [[ $kind != module ]] || besideConfigurations "$name"; } | sort -u |
    grep -vxF "${unit:-none}")
  row "  fixtures" "$(together <<< "$shared" | list 12)"
  every=$(overAll "$kind" "$name" "$file")
  row "  over all" "$(grep -E '(Test|Targets?)\.cpp$' <<< "$every" | grep -vxF "$unit"$'\n'"${shared:-none}" | together | list 30)"
  # Pages are tested by what a script shows in a browser.
  programs=$(grep -hvE '\.(cpp|h)$|^tests/(bench|support|faults)/' <<< "$all"$'\n'"$every" | awk NF | while read -r test; do
    echo "$test"
    [[ $test != *.mjs ]] || grep -lF "${test##*/}" tests/e2e/*.sh
  done | sort -u)
  row end-to-end "$(together <<< "$programs" | list 9)"
  runs=$(((${#agents[@]} == 0)) || withAgents "${agents[@]}")
  row "  in agents" "$(grep -vE '^tests/bench/' <<< "$runs" | grep -vxF "${programs:-none}" | together | list 9)"
  benches=$(grep -hE '^tests/bench/' <<< "$all"$'\n'"$every"$'\n'"$runs" | sort -u)
  row benchmarks "$(together <<< "$benches" | list 6)"
}
