#!/usr/bin/env bash
# Tells where something is: its source, what it requires and provides, its parameters, data, tests and page.
#   scripts/where.sh NAME    a module, representation, motion, skill, effect, optimiser, engine, robot, platform, rule,
#                            task of a search, excitation program, or else a class of a library
# A name that there is not: status 2, and the nearest names.
# Example: scripts/where.sh SkillGetBall
set -uo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
[[ ${1-} != -* ]] || { echo "where.sh: no option $1; see where.sh --help" >&2; exit 2; }
[[ ${1-} ]] || { echo "where.sh: give a NAME; see where.sh --help" >&2; exit 2; }
name=$1
shift
noArguments "$@"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
export LC_ALL=C

# Everything that has a name: kind, name, file.
everything() {
  local files file base
  grep -rE '^(MODULE|REPRESENTATION|REPRESENTATION_OF)\(' src --include='*.h' |
    sed -E 's/^([^:]*):(MODULE|REPRESENTATION)(_OF)?\(([A-Za-z0-9_]+).*/\2\t\4\t\1/; s/^MODULE/module/; s/^REPR[A-Z]*/representation/'
  # Words by which motions and skills are asked for: Base(Motion::walk), Base("bow"), or Base(name) with the constant above it.
  mapfile -t files < <(grep -rlE 'OutputBase\((Motion|Skill)?(::|"|name)' src --include='*.h')
  ((${#files[@]} == 0)) || awk '
    /static constexpr const char\* name = "/ { split($0, part, "\""); constant = part[2] }
    /OutputBase\(/ && !/\/\/\// {
      word = $0; sub(/.*OutputBase\(/, "", word); sub(/[,)].*/, "", word)
      sub(/.*::/, "", word); gsub(/"/, "", word); if (word == "name") word = constant
      print (FILENAME ~ /\/skills\// ? "skill" : "motion") "\t" word "\t" FILENAME
    }' "${files[@]}"
  # What registers itself from a source: MAKE_X(Identifier, ..."name"), effects with .id = "name".
  mapfile -t files < <(grep -rlE '^MAKE_(EFFECT|LEAGUE_EFFECT|OPTIMIZER|PHYSICS|ROBOT_SIMULATION|PLATFORM|RULE|TASK|SPECIAL_MODULE)\(' src --include='*.cpp')
  ((${#files[@]} == 0)) || awk '
    BEGIN {
      kind["EFFECT"] = "effect"; kind["LEAGUE_EFFECT"] = "effect of the league"; kind["OPTIMIZER"] = "optimiser"
      kind["PHYSICS"] = "physics engine"; kind["ROBOT_SIMULATION"] = "engine for servo robots"; kind["PLATFORM"] = "platform"
      kind["RULE"] = "rule"; kind["TASK"] = "task"; kind["SPECIAL_MODULE"] = "module"
    }
    function put() { if (what) print kind[what] "\t" named "\t" file; what = "" }
    FNR == 1 { put(); id = "" }
    /\.id = "/ { split($0, part, "\""); id = part[2] }
    /^MAKE_[A-Z_]+\(/ {
      put(); what = $0; sub(/^MAKE_/, "", what); sub(/\(.*/, "", what)
      if (!(what in kind)) { what = ""; next }
      named = $0; sub(/^[^(]*\(/, "", named); sub(/[,) ].*/, "", named); gsub(/"/, "", named); file = FILENAME; lines = 0
      if (what ~ /EFFECT/) { named = id; put() }
    }
    what && index($0, "\"") { split($0, part, "\""); named = part[2]; put() }
    what && ++lines > 3 { put() }
    END { put() }' "${files[@]}"
  for file in config/motions/*.yaml config/robots/*/motions/*.yaml config/excitation/*.yaml config/robots/*.json; do
    [[ -e $file ]] || continue
    base=${file##*/}
    case $file in
      */motions/*) printf 'keyframe motion\t%s\t%s\n' "${base%.*}" "$file" ;;
      config/excitation/*) printf 'excitation program\t%s\t%s\n' "${base%.*}" "$file" ;;
      *) printf 'robot\t%s\t%s\n' "${base%.*}" "$file" ;;
    esac
  done
}
# A list from standard input in one line, by commas; of more than $1 the first ones.
list() {
  awk -v most="$1" '{ if (NR <= most) text = text (NR > 1 ? ", " : "") $0 }
    END { if (NR > most) text = text " and " (NR - most) " more"; if (NR) print text }'
}
index=$(everything)
# What headers are named after.
classes() { find src -name '*.h' | sort | sed -E 's#(.*/([^/]*)\.h)#class\t\2\t\1#'; }
# The lines that have the name, or else that have it in another case.
named() {
  awk -F '\t' -v name="$name" '$2 == name' <<< "$1" | grep . || awk -F '\t' -v name="$name" 'tolower($2) == tolower(name)' <<< "$1"
}
found=$(named "$index")
[[ $found ]] || found=$(named "$(classes)")
if [[ ! $found ]]; then
  names=$({ echo "$index"; classes; } | cut -f 2 | sort -u)
  near=$(awk -v name="$name" '
    function distance(a, b,   i, j, d, c) {
      for (j = 0; j <= length(b); ++j) d[0, j] = j
      for (i = 1; i <= length(a); ++i) {
        d[i, 0] = i
        for (j = 1; j <= length(b); ++j) {
          c = d[i - 1, j - 1] + (substr(a, i, 1) != substr(b, j, 1))
          if (d[i - 1, j] + 1 < c) c = d[i - 1, j] + 1
          if (d[i, j - 1] + 1 < c) c = d[i, j - 1] + 1
          d[i, j] = c
        }
      }
      return d[length(a), length(b)]
    }
    {
      d = distance(tolower(name), tolower($0))
      if (length(name) > 3 && index(tolower($0), tolower(name))) d = 1
      if (d <= (length(name) < 3 ? 1 : length(name) / 3)) print d "\t" $0
    }' <<< "$names" | sort -n -k1,1 -k2 | cut -f 2)
  # Names that share a word with it.
  words=$(sed -E 's/([a-z0-9])([A-Z])/\1 \2/g; s/[_-]/ /g' <<< "$name" | tr ' ' '\n' | grep -E '.{3}' | while read -r word; do
    grep -iF -- "$word" <<< "$names"
  done | sort | uniq -c | sort -k1,1nr -k2 | awk 'NR == 1 { most = $1 } $1 == most { print $2 }')
  near=$(printf '%s\n' "$near" "$words" | awk 'NF && !seen[$0]++' | list 7)
  [[ ! $near ]] || near="did you mean $near?"
  echo "where.sh: nothing is called \"$name\"; ${near:-see the map in doc/architecture.md}" >&2
  exit 2
fi

row() { # label, text: wrapped
  [[ ${2-} ]] || return 0
  fold -s -w 105 <<< "$2" | awk -v label="$1" '{ sub(/ +$/, ""); printf "  %-11s %s\n", NR == 1 ? label : "", $0 }'
}
inputs() { # header: what the module requires
  sed -nE '/^MODULE\(/,/^END_MODULE/ {
    s/^ *REQUIRES\((.*)\).*/\1/p; s/^ *REQUIRES_IF_PROVIDED\((.*)\).*/\1 (if provided)/p; s/^ *REQUIRES_ALL\((.*)\).*/all \1/p
    s/^ *USES\((.*)\).*/\1 (of the cycle before)/p; s/^ *USES_ALL\((.*)\).*/all \1 (of the cycle before)/p }' "$1" | list 99
}
outputs() { sed -nE 's/^ *PROVIDES\((.*)\).*/\1/p' "$1" | list 99; }
with() { grep -rlE "^ *$1\($2\)" src/modules --include='*.h' | sed 's#.*/##; s#\.h$##' | sort | list 8; } # macro, name
parametersOf() { # section of doc/reference/parameters.md; many by group
  [[ -e doc/reference/parameters.md ]] || return 0
  awk -F ' *[|] *' -v wanted="## $1" '
    /^## / { here = $0 == wanted }
    here && /^[|] `/ {
      path = $2; gsub(/`/, "", path); group = path
      if (!sub(/\..*/, "", group)) group = "on its own"
      if (!(group in of)) order[++groups] = group
      ++of[group]
      text = text (n++ ? ", " : "") path "=" ($4 == "" ? "\"\"" : $4) ($5 == "" ? "" : " " $5)
    }
    END {
      if (!n) exit
      if (n <= 45) { print text; exit }
      for (i = 1; i <= groups; ++i) many = many (i > 1 ? ", " : "") of[order[i]] " " order[i]
      print n ": " many "; doc/reference/parameters.md#" tolower(substr(wanted, 4))
    }' doc/reference/parameters.md
}
declared() { # sources: the macros in them
  sed -nE 's/^ *PARAMETER\([^,]*, *([A-Za-z0-9_]+), *([^,]*),.*/\1=\2/p' "$@" 2> /dev/null | list 30
}
ofFile() { sed -nE 's/^ *\.(unit|lower|upper) = "?([^",]*)"?,.*/\1 \2/p' "$1" | list 9; } # an effect's value

# Files that name something: pattern; folder of tests.
naming() {
  grep -rlE "$1" "$2" --include='*.cpp' --include='*.h' --include='*.sh' --include='*.bash' --include='*.mjs' --exclude-dir=data \
    --exclude-dir=build | sort
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
  done | awk '!seen[$0]++'
}
# Pattern of what tests name it by; its own test; folder of tests [tests]; pattern of a line that its unit tests have; folder of
# those that come first; its parts.
tests() {
  local all own unit parts=("${@:6}")
  all=$(naming "$1" "${3:-tests}")
  own=${2:+$(grep -xE "$2" <<< "$all")}
  unit=$(grep -E '^tests/(.*/)?[^/]*Test\.cpp$' <<< "$all" | grep -vE '^tests/(e2e|bench)/')
  [[ ! ${4-} || ! $unit ]] || unit=$(xargs grep -lE "$4" <<< "$unit")
  # Those of the source's folder first, then by how often they name it.
  unit=$({ grep -E "^${5:-none}/" <<< "$unit"
    xargs -r grep -HcE "$1" <<< "$unit" | sort -t : -k2,2nr -k1,1 | cut -d : -f 1; } | awk 'NF && !seen[$0]++')
  unit=$(printf '%s\n' "$own" "$unit" | awk 'NF && !seen[$0]++')
  row tests "$(list 9 <<< "$unit")"
  # Situations and other data that its own tests read.
  [[ ! $own ]] || row '' "$(grep -hoE '"tests/data/[a-z/]+' $own | tr -d '"' | sed 's#/$##' | sort -u | list 4)"
  row "  of parts" "$(testsOfParts "${parts[@]}" | grep -vxF "${unit:-none}" | list 9)"
  row end-to-end "$(grep -E '^tests/e2e/' <<< "$all" | list 6)"
  row benchmarks "$(grep -E '^tests/bench/' <<< "$all" | list 3)"
}
pages() { # pattern; the page of its kind; module: without those that name modules as examples
  local all examples="framework|modules-cfg|platforms|find-a-fault|debug-a-running-agent|log-and-replay|add-[a-z-]*"
  all=$({ grep -rcE "$1" doc/reference doc/how-to doc/tutorials --include='*.md' 2> /dev/null |
    grep -vE "(parameters|glossary${3:+|$examples})\\.md:|:0\$" | sort -t : -k2,2nr -k1,1 | cut -d : -f 1 | head -3; [[ ! -e $2 ]] || echo "$2"; } | awk '!seen[$0]++' | list 4)
  row page "$all"
}
source_() { # files
  local file text=
  for file; do text+="${text:+, }$file"; [[ $file != *.h || ! -e ${file%.h}.cpp ]] || text+=" and .cpp"; done
  row source "$text"
}
data() { # files; "none" is an answer, too
  local text
  text=$(printf '%s\n' "$@" | awk 'NF && !seen[$0]++' | list 9)
  row data "${text:-none}"
}
# The comment above a module's declaration, or that of a class: what it does.
purpose() { # header; class
  awk -v wanted="${2+^(class|struct|enum class) $2( |\$)}" '
    /^ *\/\/\/  / { next }  # an example
    /^ *\/\/\/( |$)/ { sub(/^ *\/\/\/ */, ""); text = text (text == "" || $0 == "" ? "" : " ") $0; next }
    (wanted == "" ? /^(MODULE\(|class )/ : $0 ~ wanted) && text != "" { print text; exit }
    { text = "" }' "$1"
}
# Headers of a module's own parts: what it includes that is no module and is not common to all, from its area or a library.
parts() {
  cat "$@" 2> /dev/null | sed -nE 's/^#include "([^"]*)".*/\1/p' | grep -vE "^(representations|framework|math|field|parameters|robot|motion)/" |
    while read -r header; do
      [[ -e src/$header && " $* " != *" src/$header "* ]] && ! grep -qE '^MODULE\(|OutputBase\(' "src/$header" && echo "src/$header"
    done | awk '!seen[$0]++'
}
# Files of the configuration that sources read.
reads() {
  grep -hoE 'config\.file\("[a-z_]+(/"|"\))|readWalkGaits\(config|readMotions\(config' "$@" 2> /dev/null |
    sed -E 's/.*"(.*)".*/\1/; s/readWalk.*/walking/; s/readMotions.*/motions\//' | sort -u | while read -r read; do
      if [[ $read == */ ]]; then find config -type d -path "*/${read%/}" | sed 's#$#/#'
      else find config -maxdepth 3 -name "$read.yaml" | grep -vE '^config/(walks|optimisation)/'; fi
    done | sort
}

about() { # kind, name, files
  local kind=$1 name=$2 file=$3
  shift 2
  local all=("$@") word="([\"'/=]|--[a-z-]+ )$name\b" stem files text piece pieces=()
  case $kind in
    module)
      if [[ $file == *.cpp ]]; then source_ "$file"; row line "[$name] in modules.cfg: doc/reference/modules-cfg.md"; stem=$(basename "$file" .cpp)
      else
        row does "$(purpose "$file")"
        source_ "$file"
        stem=$name
        mapfile -t pieces < <(parts "$file" "${file%.h}.cpp")
        row parts "$(printf '%s\n' "${pieces[@]}" | awk NF | list 8)"
        row requires "$(inputs "$file")"
        row provides "$(outputs "$file")"
      fi
      text=$(parametersOf "$stem")
      text=${text:-$(declared "$file")}
      row parameters "${text:-none}"
      # Its own file, and what it and its parts read.
      mapfile -t files < <(find config -name "$stem.yaml" | sort; reads "${file%.*}.cpp" "${pieces[@]/%.h/.cpp}")
      data "${files[@]}"
      row "runs by" "$(grep -rlE "^ *$name( |\$)" config --include='*.cfg' | sort | list 6)"
      tests "\b$stem\b" "tests/$(dirname "${file#src/}")/${stem}Test.cpp" '' "^#include \".*/$stem\.h\"|ModuleHarness<(.*::)?$stem>" '' "${pieces[@]}"
      text=$(pages "\b$stem\b" "" module)
      echo "${text:-  page        none: what it does stands above; doc/how-to/add-a-module.md says how one is made}"
      ;;
    representation)
      source_ "$file"
      row "provided by" "$(with PROVIDES "$name")"
      row "required by" "$(with '(REQUIRES|USES|REQUIRES_IF_PROVIDED)' "$name")"
      tests "\b$name\b" ''
      text=$(grep -rlE "^ *PROVIDES\($name\)" src/modules --include='*.h' | sed 's#.*/##; s#\.h$##' | paste -sd '|')
      pages "\b($name${text:+|$text})\b" doc/how-to/add-a-module.md
      ;;
    class)
      row does "$(purpose "$file" "$exact")"
      source_ "$file"
      row "included by" "$(grep -rlF "#include \"${file#src/}\"" src | grep -vxF "${file%.h}.cpp" | sort | list 9)"
      row parameters "$(declared "$file")"
      tests "#include \"${file#src/}\"" "$(sed 's#^src/#tests/#; s#\.h$#Test.cpp#' <<< "$file")"
      pages "\b$name\b" ""
      ;;
    motion | skill)
      stem=$(sed -nE 's/.*[ (](\w+)OutputBase\(.*/\1Output/p' "$file" | head -1)
      source_ "$file"
      row "provided by" "$(with PROVIDES "$stem" | sed -E 's#(\w+)#\1 (scripts/where.sh \1)#g')"
      pages "\b$name\b" doc/how-to/add-a-behaviour.md
      ;;
    "keyframe motion" | "excitation program")
      text=doc/how-to/add-a-motion.md stem="src/motion/, src/modules/motion/"
      [[ $kind == key* ]] || text=doc/reference/excitation-programs.md stem=src/gap/record/
      files=("config/optimisation/$name.yaml")
      [[ -e ${files[0]} ]] || files=()
      data "${all[@]}" "${files[@]}"
      row source "$stem"
      if [[ $kind == key* ]]; then
        stem=SpecialActions
        ! grep -qE '^(kick|ball):' "$file" || stem=KickMotion
        row "played by" "$stem (scripts/where.sh $stem)"
        row parameters "none: its times, angles and keys stand in its files ($text)"
      fi
      # A name of two words is no common word.
      [[ ! $name =~ [a-z][A-Z] ]] || word="\\b$name\\b"
      tests "$word" ''
      pages "\b$name\b" "$text"
      row results "$(grep -rlE "\b$name\b" doc/results 2> /dev/null | grep -v diary | sort | list 4)"
      ;;
    robot)
      mapfile -t files < <(find "config/robots/${name#simspark_}" -type f 2> /dev/null | sort)
      data "${all[@]}" "${files[@]}"
      row source "src/robot/"
      tests "$word" ''
      pages "\b$name\b" doc/reference/robot-files.md
      ;;
    effect*)
      source_ "${all[@]}"
      row does "$(sed -nE '/\.sentence = /,/",/p' "$file" | tr -d '\n' | sed -E 's/^[^"]*"//; s/" *"//g; s/",.*//')"
      row at "$(sed -nE 's/^ *\.sites = \{(.*)\},.*/\1/p' "$file" | sed 's/Site:://g')"
      row value "$(ofFile "$file")"
      text=tests
      [[ $kind == effect ]] || text=tests/simulation
      tests "\"$name\"|\b$(basename "$file" .cpp | sed 's/^./\L&/')\b" '' "$text" '' "tests/$(dirname "${file#src/}")"
      pages "\b$name\b" doc/how-to/add-an-effect.md
      ;;
    *)
      files=("${all[@]}")
      [[ ! -e ${file%.cpp}.h ]] || files=("${file%.cpp}.h")
      source_ "${files[@]}"
      row parameters "$(declared "${files[@]}" "$file" | head -1)"
      [[ $kind != platform ]] || { data "config/platforms/$name/modules.cfg"; word="\"$name\"|--platform $name"; }
      tests "$word|\b$(basename "$file" .cpp)\b" "tests/$(dirname "${file#src/}")/$(basename "$file" .cpp)Test.cpp"
      case $kind in
        optimiser) pages "\b$name\b" doc/how-to/add-an-optimiser.md ;;
        *engine*) pages "\b$name\b" doc/how-to/add-an-engine.md ;;
        platform) pages "\b$name\b" doc/how-to/add-a-platform.md ;;
        rule) pages "\b$name\b" doc/reference/rules.md ;;
        *) pages "\b$name\b" doc/how-to/optimise-a-motion.md ;;
      esac
      ;;
  esac
}

# One block for each kind and name; a name may be of several files.
cut -f 1,2 <<< "$found" | awk '!seen[$0]++' | while IFS=$'\t' read -r kind exact; do
  mapfile -t files < <(awk -F '\t' -v kind="$kind" -v name="$exact" '$1 == kind && $2 == name { print $3 }' <<< "$found")
  echo "$kind $exact"
  about "$kind" "$exact" "${files[@]}"
done
