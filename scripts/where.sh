#!/usr/bin/env bash
# Tells where something is: its source, what it requires and provides, its parameters, data, tests, page and results.
#   scripts/where.sh NAME    a module, representation, motion, skill, effect, optimiser, engine, robot, platform, rule,
#                            task of a search, excitation program, or else a class of a library
# Tests that name it come first. Below them stand those that reach it otherwise: through its parts, through fixtures that name it,
# over all of its kind, and in agents that run it.
# A name that there is not: status 2, and the nearest names.
# Example: scripts/where.sh SkillGetBall
set -uo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
source "$(dirname "${BASH_SOURCE[0]}")/where_tests.bash"
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
    sed -E 's/^([^:]*):(MODULE|REPRESENTATION)(_OF)?\(([A-Za-z0-9_]+).*/\2\t\4\t\1/; s/^(MODULE|REPRESENTATION)/\L&/'
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
  mapfile -t files < <(grep -rlE '^MAKE_[A-Z_]+\(' src --include='*.cpp')
  ((${#files[@]} == 0)) || awk -f scripts/where_names.awk "${files[@]}"
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
[[ $found || $name != type[0-9]* ]] || { name=simspark_$name; found=$(named "$index"); } # a league's robot by its folder
[[ $found ]] || found=$(named "$(classes)")
if [[ ! $found ]]; then
  names=$({ echo "$index"; classes; } | cut -f 2 | sort -u)
  near=$(awk -v name="$name" -f scripts/where_near.awk <<< "$names")
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
with() { grep -rlE "^ *$1\($2\)" src/modules --include='*.h' | sed 's#.*/##; s#\.h$##' | sort | list 12; } # macro, name
parametersOf() { # section of doc/reference/parameters.md; many by group
  [[ -e doc/reference/parameters.md ]] || return 0
  awk -F ' *[|] *' -v wanted="## $1" '
    /^## / { here = $0 == wanted }
    here && /^[|] `/ {
      path = $2; gsub(/`/, "", path); group = path
      if (!sub(/\..*/, "", group)) group = "on its own"
      if (!(group in of)) order[++groups] = group
      ++of[group]
      text = text (n++ ? ", " : "") path "=" ($4 == "" ? "\"\"" : $4) ($5 == "" ? "" : " " $5) ($6 == "" ? "" : " (" $6 ")")
    }
    END {
      if (!n) exit
      page = "doc/reference/parameters.md#" tolower(substr(wanted, 4))
      gsub(/ … /, "…", text)
      if (n <= 45) { print text "; what each does: " page; exit }
      for (i = 1; i <= groups; ++i) many = many (i > 1 ? ", " : "") of[order[i]] " " order[i]
      print n ": " many "; each with unit and range: " page
    }' doc/reference/parameters.md
}
declared() { awk -f scripts/where_parameters.awk "$@" 2> /dev/null | awk -F = '!seen[$1]++' | list 30; } # sources
# What can be set in sources, or else in headers that they include: of the folder above, or else of theirs.
options() {
  local text headers folder sections
  text=$(declared "$@")
  folder=$(dirname "${1#src/}")
  for folder in "${folder%/*}" "$folder"; do
    mapfile -t headers < <(cat "$@" | sed -nE "s#^\#include \"($folder/[^/\"]*)\"#src/\1#p" | sort -u)
    [[ $text ]] || ((${#headers[@]} == 0)) || text=$(declared "${headers[@]}")
  done
  # Of a rule also those that many rules have.
  sections=$(sed -nE 's/^  PARAMETER_GROUP\([A-Za-z]*, ([a-zA-Z]*),.*/\1/p' src/simulation/referee/Rules.h 2> /dev/null |
    paste -sd '|')
  [[ $kind != rule || ! $sections ]] || sections=$(grep -ohE "\brules\.($sections)\b" "$@" | sed 's/rules\.//' | sort -u | list 9)
  [[ $kind != rule || ! $sections ]] || text+="${text:+, }what it uses of $sections in src/simulation/referee/Rules.h"
  row parameters "${text:-none}"
}
pages() { # pattern; the page of its kind. Those that name modules as examples come last.
  local all examples='(framework|modules-cfg|find-a-fault|debug-a-running-agent|log-and-replay|add-a-module)\.md:'
  all=$(grep -rcE "$1" doc/reference doc/how-to doc/tutorials doc/decisions --include='*.md' 2> /dev/null |
    grep -vE "(parameters|glossary)\\.md:|:0\$" | sort -t : -k2,2nr -k1,1)
  all=$(grep -vE "$examples" <<< "$all"; [[ ! -e $2 ]] || echo "$2"; grep -E "$examples" <<< "$all")
  row page "$(cut -d : -f 1 <<< "$all" | once | list 12)"
  row results "$(grep -rlE "$1" doc/results 2> /dev/null | grep -vE "/(gap-diary|coverage|mutation)\." | sort | list 6)"
}
source_() { # files
  local file text=
  for file; do text+="${text:+, }$file"; [[ $file != *.h || ! -e ${file%.h}.cpp ]] || text+=" and .cpp"; done
  row source "$text"
}
data() { # files; "none" is an answer, too
  local text
  text=$(printf '%s\n' "$@" | once | list 20)
  row data "${text:-none}"
}
# Files of the configuration that name something but for its own: pattern, its own files.
namedIn() { row "named in" "$(grep -rlE "$1" config --include='*.yaml' | grep -vxF "$(printf '%s\n' "${@:2}")" | sort | list 9)"; }
# The comment above a module's or a representation's declaration, or that of a class, else the header's first: what it does.
purpose() { # header; class
  awk -v wanted="${2+^(class|struct|enum class) $2( |\$)|^REPRESENTATION(_OF)?[(]$2[,)]}" '
    /^ *\/\/\/  / { next }  # an example
    /^ *\/\/\/( |$)/ { sub(/^ *\/\/\/ */, ""); text = text (text == "" || $0 == "" ? "" : " ") $0; next }
    (wanted == "" ? /^(MODULE\(|REPRESENTATION|class )/ : $0 ~ wanted) && text != "" { found = 1; print text; exit }
    text != "" && first == "" && !/^ *[^ ]* *= / { first = text }
    { text = "" }
    END { if (!found && wanted != "" && first != "") print first }' "$1"
}
# Headers of a module's own parts: what it includes that is no module and is not common to all, from its area or a library.
parts() {
  sed -nE 's/^#include "([^"]*)".*/\1/p' "$@" 2> /dev/null | grep -vE "^(representations|framework|math|field|parameters|robot)/" |
    while read -r header; do
      [[ -e src/$header && " $* " != *" src/$header "* ]] && ! grep -qE '^MODULE\(|OutputBase\(' "src/$header" && echo "src/$header"
    done | once
}
# Files of the configuration that sources read: by name, or in each folder of it.
reads() {
  local read calls='config\.file\("[a-z_]+(/"|"\))|readWalkGaits\(config|readMotions\(config|findMechanism\('
  calls+='|directory\) / "[a-z_.]+"'
  grep -hoE "$calls" "$@" 2> /dev/null |
    sed -E 's/.*"(.*)".*/\1/; s/readWalk.*/walking/; s/readMotions.*/motions\//; s/findMech.*/robots\//; s/\.yaml$//' | sort -u |
    while read -r read; do
      if [[ -d config/${read%/} ]]; then find config -type d -path "*/${read%/}" | sed 's#$#/#'
      else find config -maxdepth 3 -name "$read.yaml" | grep -vE '^config/(walks|optimisation)/'; fi
    done | sort -u
}

aboutModule() { # file
  local file=$1 own uses text files agents pieces=() stem=$name
  if [[ $file == *.cpp ]]; then
    stem=$(basename "$file" .cpp)
    [[ ! -e ${file%.cpp}.h ]] || row does "$(purpose "${file%.cpp}.h" "$stem")"
    source_ "$file"
    row line "[$name] in modules.cfg: doc/reference/modules-cfg.md"
  else
    row does "$(purpose "$file")"
    source_ "$file"
    mapfile -t pieces < <(parts "$file" "${file%.h}.cpp")
    row parts "$(printf '%s\n' "${pieces[@]}" | awk NF | list 9)"
    row requires "$(inputs "$file")"
    row provides "$(outputs "$file")"
    # Several representations may share a header, so the header's name is not always that of the representation.
    row "their files" "$(sed -nE 's#^\#include "([^"]*)".*#src/\1#p' "$file" | xargs grep -slE '^REPRESENTATION' | list 20)"
  fi
  text=$(parametersOf "$stem")
  text=${text:-$(declared -v macros=1 "$file")}
  # Its own file, and what it and its parts read.
  mapfile -t files < <(find config -name "$stem.yaml" | sort; reads "${file%.*}.cpp" "${pieces[@]/%.h/.cpp}")
  [[ $text || ${files[0]-} != */$stem.yaml ]] || text="the keys of ${files[0]}"
  row parameters "${text:-none}"
  data "${files[@]}"
  mapfile -t agents < <(grep -rlE "^ *$name( |\$)" config --include='*.cfg' | sort)
  row "runs by" "$(printf '%s\n' "${agents[@]}" | list 6)"
  word="\b$stem\b" own="tests/$(dirname "${file#src/}")/${stem}Test.cpp"
  # A unit test runs it by its header or by a line of a modules.cfg.
  uses="^#include \".*/$stem\.h\"|\b$stem\.yaml\b|ModuleHarness<(.*::)?$stem>"
  uses+="|(^|R\"\()$stem [A-Z][A-Za-z]+\$|\"$stem( [A-Z][A-Za-z]+)?\\\\n"
  # A play mode is called so, too, or it is a common word: then only where it is code.
  if [[ $stem =~ ^[A-Z][a-z]+$ ]] || grep -rqsF "\"$stem\"" src/simspark; then
    inScripts="([:/]|--[a-z-]+[= ])$stem\b|\b$stem(\.yaml|:| [A-Z])" word="[\`:/\"]$stem\b|$inScripts"
  fi
  tests
  text=$(pages "$word$([[ $name == "$stem" ]] || echo "|\`$name[ \`]")" "")
  echo "${text:-  page        none: what it does is said above; doc/how-to/add-a-module.md says how one is made}"
}

aboutRobot() { # file
  local file=$1 folder=${name#simspark_} files type word pieces=() traces
  mapfile -t files < <(echo "$file"; find config -type f \( -path "*/$folder/*" -o -path "*/$name/*" \) 2> /dev/null | sort)
  data "${files[@]}"
  traces=$(find tests/data -name "*_$folder.*" -o -name "*_${folder/type/t}.*" 2> /dev/null | sort)
  row recordings "$({ echo "$traces"; grep -rslE "\"robot\": *\"$name\"" tests/data --include=run.json | xargs -r dirname; } |
    awk NF | together | list 8)"
  row source "src/robot/$([[ $name == "$folder" ]] || echo ", src/simspark/LeagueRobots.h and .cpp")"
  row parameters "none: links, joints, limits and servos are in its file (doc/reference/robot-files.md)"
  namedIn "\b$name\b" "${files[@]}"
  word="\b$name\b"
  if [[ $name != "$folder" ]]; then
    type=${folder#type}
    word+="|robots/$name\b|(simsparkRobot|leagueRobot)\($type\)|Trial [a-z]+[({]$type[)}]|--type $type\b"
    traces=$(sed -E 's#.*/##; s#\..*##' <<< "$traces" | once | paste -sd '|')
    [[ ! $traces ]] || word+="|\b($traces)\b"
  fi
  tests
  pages "\b($name|$folder)\b" doc/reference/robot-files.md
}

aboutEffect() { # file
  local file=$1 word first under given=() label text pieces=()
  source_ "$file"
  # An effect of the league has unit and nominal value of that of the diagnosis.
  mapfile -t given < <(grep -rslF ".id = \"$name\"" src/gap/effects |
    xargs -r sed -nE 's/^ *\.(unit|nominal) = "?([^"]*)"?,.*/-v\n\1=\2/p')
  while IFS=$'\t' read -r label text; do row "$label" "$text"; done < <(awk "${given[@]}" -f scripts/where_effect.awk "$file")
  row data none
  namedIn "\b$name\b"
  under=tests first="tests/$(dirname "${file#src/}")"
  [[ $kind == effect ]] || under=tests/simulation
  # A name of two words is no common word.
  word="\"$name\"|\b$(basename "$file" .cpp | sed 's/^./\L&/')\b"
  [[ $name != *_* ]] || word="\b$name\b|$word"
  tests
  pages "\b$name\b" doc/how-to/add-an-effect.md
}

# What registers itself besides: optimisers, engines, platforms, rules, tasks.
aboutRegistered() { # file
  local file=$1 stem own word text=$name files pieces=() main=$1
  stem=$(basename "$file" .cpp) own="tests/$(dirname "${file#src/}")/${stem}Test.cpp"
  [[ ! -e ${file%.cpp}.h ]] || main=${file%.cpp}.h
  row does "$(purpose "$main" "$stem")"
  source_ "$main"
  word="([\"'/=]|, |--[a-z-]+ |for [a-z]+ in .* |for [a-z]+ in )$name\b|\b$name[\"'\`]|\b$stem\b"
  [[ ! $name =~ [a-z][A-Z] ]] || word="\b$name\b|\b$stem\b" # two words are no common word
  case $kind in
    platform)
      row modules "$(grep -rlE '^MODULE\(' "$(dirname "$file")" --include='*.h' | sed 's#.*/##; s#\.h$##' | sort | list 20)"
      row parameters "none: options stand in bin/agent --platform $name --help"
      agents=(config/platforms/"$name"/*)
      data "${agents[@]}"
      word="\"$name\"|--platform $name\b|#include \"$(dirname "${file#src/}")/"
      ;;
    rule)
      options "$file" "$main"
      data doc/reference/rules.yaml
      text="($name|$stem)"
      ;;
    task)
      row parameters "its options stand in the comment above and in bin/optserver --help"
      mapfile -t files < <(find config/optimisation -name "$name.yaml")
      data "${files[@]}"
      namedIn "^task: $name\b" "${files[@]}"
      word="task: *$name\b|--task $name\b|\b$stem\b" text="(task: $name|$stem)"
      ;;
    *)
      options "$main" "$file"
      row data none
      [[ $kind != optimiser ]] || namedIn "^optimizer: $name\b"
      [[ $kind != *engine* ]] || namedIn "engine: $name\b"
      ;;
  esac
  tests
  case $kind in
    optimiser) pages "\b$text\b" doc/how-to/add-an-optimiser.md ;;
    *engine*) pages "\b(${text}|${text^})\b" doc/how-to/add-an-engine.md ;;
    platform) pages "\b$text\b" doc/how-to/add-a-platform.md ;;
    rule) pages "\b$text\b" doc/reference/rules.md ;;
    *) pages "\b$text\b" doc/how-to/optimise-a-motion.md ;;
  esac
}

about() { # kind, name, files
  local kind=$1 name=$2 file=$3 all=("${@:3}") stem text page files
  local word own='' uses='' inScripts='' first='' under='' pieces=() agents=() # what tests() takes
  case $kind in
    module) aboutModule "$file" ;;
    representation)
      row does "$(purpose "$file" "$name")"
      source_ "$file"
      row fields "$(sed -nE "/^REPRESENTATION(_OF)?\\($name[,)]/,/^};/p" "$file" | grep -oE '\bSTREAM\("?\w+' |
        sed -E 's/.*\("?//' | list 30)"
      row "provided by" "$(with PROVIDES "$name")"
      row "required by" "$(with '(REQUIRES|REQUIRES_IF_PROVIDED)' "$name")"
      row "used by" "$(with USES "$name")"
      text=$(sed -nE 's/^REPRESENTATION_OF\(\w+, *(\w+)\).*/\1/p' "$file")
      namedIn "\b$name\b"
      row "of a kind" "${text:+$text, all of which are required by $(with '(REQUIRES_ALL|USES_ALL)' "$text")}"
      word="\b$name\b"
      tests
      text=$(grep -rlE "^ *PROVIDES\($name\)" src/modules --include='*.h' | sed 's#.*/##; s#\.h$##' | paste -sd '|')
      pages "\b($name${text:+|$text})\b" doc/how-to/add-a-module.md
      ;;
    class)
      row does "$(purpose "$file" "$name")"
      source_ "$file"
      row "included by" "$(grep -rlF "#include \"${file#src/}\"" src | grep -vxF "${file%.h}.cpp" | sort | list 9)"
      row parameters "$(declared "$file")"
      word="#include \"${file#src/}\"" own=$(sed 's#^src/#tests/#; s#\.h$#Test.cpp#' <<< "$file")
      tests
      text=$(pages "\b$name\b" "")
      echo "${text:-  page        none: what it does is said above}"
      ;;
    motion | skill)
      stem=$(sed -nE 's/.*[ (](\w+)OutputBase\(.*/\1Output/p' "$file" | head -1)
      row does "$(purpose "$file")"
      source_ "$file"
      text=$(with PROVIDES "$stem")
      row "provided by" "$(sed -E 's#(\w+)#\1 (its parameters and data: scripts/where.sh \1)#g' <<< "$text")"
      row tests "$(for stem in ${text//,/}; do find tests -name "${stem}Test.cpp"; done | list 9)"
      pages "([\`\"]|$kind )$name\b" doc/how-to/add-a-behaviour.md
      ;;
    "keyframe motion" | "excitation program")
      files=("config/optimisation/$name.yaml")
      [[ -e ${files[0]} ]] || files=()
      data "${all[@]}" "${files[@]}"
      # A name of two words is no common word.
      word="([\"'/=\`]|--[a-z-]+ )$name\b"
      [[ ! $name =~ [a-z][A-Z]|_ ]] || word="\\b$name\\b"
      if [[ $kind == key* ]]; then namedIn "[:[,] *$name\b" "${all[@]}" "${files[@]}"; else namedIn "\b$name\b" "${all[@]}"; fi
      if [[ $kind == key* ]]; then
        page=doc/how-to/add-a-motion.md stem=SpecialActions
        ! grep -qE '^(kick|ball):' "$file" || stem=KickMotion
        row source "src/motion/, src/modules/motion/"
        row mirrors "$(sed -nE 's/^mirror: *([A-Za-z0-9_]+).*/\1 (scripts\/where.sh \1)/p' "$file")"
        mapfile -t pieces < <(grep -rslF "\"$name\"" src/motion src/modules src/training src/trials | sort)
        row "chosen by" "$(printf '%s\n' "${pieces[@]}" | list 6)"
        pieces=("${pieces[@]/%.cpp/.h}")
        row "played by" "$stem (scripts/where.sh $stem)"
        row parameters "none: its times, angles and keys stand in its files ($page)"
      else
        page=doc/reference/excitation-programs.md
        row source src/gap/record/
        row "chosen by" "$(grep -rlE "\"$name\"" src --include='*.h' --include='*.cpp' | sort | list 6)"
        row parameters "none: all is in its file ($page)"
      fi
      tests
      pages "$word" "$page"
      ;;
    robot) aboutRobot "$file" ;;
    effect*) aboutEffect "$file" ;;
    *) aboutRegistered "$file" ;;
  esac
}

# One block for each kind and name; a name may be of several files.
cut -f 1,2 <<< "$found" | awk '!seen[$0]++' | while IFS=$'\t' read -r kind exact; do
  mapfile -t files < <(awk -F '\t' -v kind="$kind" -v name="$exact" '$1 == kind && $2 == name { print $3 }' <<< "$found")
  echo "$kind $exact"
  about "$kind" "$exact" "${files[@]}"
done
