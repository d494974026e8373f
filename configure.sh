#!/usr/bin/env bash
# Finds the sources of one target and writes build/<target>/: one dependency file per object (it holds the
# rule that compiles the object, and every compile writes it anew) and target.mk, which the Makefile includes.
# Nothing here compiles, so it runs in a blink and before any compiler is installed.
#
#   ./configure.sh [--target NAME] [--SETTING VALUE]... [--SETTING+ MORE]...
#
# adds or renews one target; the others stay as they are. The target configured last is what `make` builds.
# A setting's value is, in this order: what follows here, scripts/targets/<target>.settings, the arguments.
set -euo pipefail
cd "${BASH_SOURCE[0]%/*}" 2>/dev/null || cd .
export LC_ALL=C

# ---- settings --------------------------------------------------------------------------------------------
target=""                         # name of the target; empty: the one configured last, or SimRelease
output=""                         # the one thing built: program, x.a or x.so; empty: the outputs by folder, below
sourceDirs="src"                  # where sources are looked for
ignoredDirs=""                    # folders and files left out
library="libplumbline.a"          # of all sourceDirs except the two that follow; .a or .so
moduleDirs="src/modules"          # modules register themselves: their library is linked whole
moduleLibrary="libmodules.a"      # name of that library
programDirs="src/main utils"          # here each source, and each folder of sources, is a program
programsWithModules="agent"       # programs that link the modules
testDirs="tests"                  # here each folder of sources is a test program
benchDir="tests/bench"            # here each source, and each folder of sources, is a benchmark
supportDir="tests/support"        # sources shared by tests and benchmarks
testsWithModules="modules endtoend"        # tests and benchmarks that link the modules
outputDir=""                      # where programs go; empty: build/<target>/bin
libraryDir=""                     # where libraries go; empty: build/<target>/lib
depends=""                        # targets built first; the libraries they build are linked
includedMakefiles="scripts/make/flexbison.mk"      # rules for files that do not exist yet
generators="y:tab.cpp,tab.h l:lex.cpp"             # X.y makes build/generated/<folder>/X.tab.cpp and X.tab.h
generatedFiles=""                 # further generated sources, compiled though they do not exist yet
cxx="g++"                         # compiler and linker of C++
cc="gcc"                          # compiler of C
cppflags=""                       # preprocessor, C and C++
includeDirs="src tests build/generated/src"        # -I
systemIncludeDirs="/usr/include/eigen3"            # -isystem: no warnings from there, no dependencies on it
warnings="-Wall -Wextra -Wpedantic -Werror"        # C and C++
flags=""                          # code generation, C and C++, also given to the linker
cxxflags="-std=c++20"             # C++ alone
precompiled=""                    # a header compiled once and put before every C++ source; empty: none
together="1"                      # about so many neighbouring C++ sources are compiled in one go
cflags="-std=c11"                 # C alone
generatedFlags="-w"               # added for generated sources: nobody mends their warnings
ldflags="-Wl,--as-needed"         # linker
libraries=""                      # linked into everything
testLibraries="-lgtest_main -lgtest"               # linked into tests as well
benchLibraries="-lbenchmark_main -lbenchmark -lgtest"  # linked into benchmarks as well
# ----------------------------------------------------------------------------------------------------------
readonly self=configure.sh
mapfile -t settingNames < <(sed -n '/^# ---- settings/,/^# ------/s/^\([a-zA-Z]*\)=.*/\1/p' $self)

fail() { echo "$self: $*" >&2; exit 2; }

usage() {
  sed -n '2,/^set /{/^set /d;s/^# \{0,1\}//p}' $self
  echo; echo "Settings (--source-dirs and --sourceDirs are the same):"
  sed -n '/^# ---- settings/,/^# ------/s/^\([a-zA-Z]*\)=\("[^"]*"\) *# \(.*\)/  --\1 \2\n        \3/p' $self
}

# Sets variables from "--name value" pairs; "--name+ value" appends.
applyArguments() {
  while (($#)); do
    local argument=$1 name append="" value
    [[ $argument == --* ]] || fail "argument '$argument' is no option; options are --SETTING VALUE, see --help"
    if [[ $argument == --*=* ]]; then
      value=${argument#*=}; name=${argument%%=*}; shift
    else
      (($# > 1)) || fail "option $argument needs a value"
      name=$argument; value=$2; shift 2
    fi
    name=${name#--}
    [[ $name == *+ ]] && append=1 name=${name%+}
    while [[ $name =~ ^([^-]*)-(.)(.*)$ ]]; do name=${BASH_REMATCH[1]}${BASH_REMATCH[2]^}${BASH_REMATCH[3]}; done
    [[ " ${settingNames[*]} " == *" $name "* ]] || fail "unknown option $argument; see --help"
    if [[ $append ]]; then printf -v "$name" '%s %s' "${!name}" "$value"; else printf -v "$name" '%s' "$value"; fi
  done
}

# Writes standard input to a file, but leaves the file (and its time) alone when nothing changes.
writeIfChanged() {
  local new; new=$(cat; echo x); new=${new%x}
  [[ -f $1 && $(cat "$1"; echo x) == "${new}x" ]] && return
  printf '%s' "$new" > "$1.new" && mv -f "$1.new" "$1"
}

# All sources and the inputs of generators below the given folders, sorted.
findSources() {
  local directories=() directory prune=(-name '.?*')
  for directory in $sourceDirs $moduleDirs $programDirs $testDirs $benchDir $supportDir; do
    [[ -d $directory ]] && directories+=("$directory")
  done
  ((${#directories[@]})) || return 0
  for directory in $ignoredDirs; do prune+=(-o -path "${directory%/}"); done
  local suffix names=(-name '*.cpp' -o -name '*.cc' -o -name '*.c')
  for suffix in $generators; do names+=(-o -name "*.${suffix%%:*}"); done
  find "${directories[@]}" \( "${prune[@]}" \) -prune -o -type f \( "${names[@]}" \) -print | sort -u
}

# ---- what to do ------------------------------------------------------------------------------------------
refresh=""
case ${1-} in
  -h | --help) usage; exit 0 ;;
  --refresh) # for the Makefile: --refresh TARGET...; renews those whose file list changed, prints them and
    shift    # the targets they depend on, each after its own dependencies
    declare -A seen=()
    visit() {
      [[ ${seen[$1]-} ]] && return
      seen[$1]=1
      ./$self --refresh-one "$1" || exit 2
      local d; for d in $(cat "build/$1/depends"); do visit "$d"; done
      echo "$1"
    }
    for t in "$@"; do visit "$t"; done
    exit 0 ;;
  --refresh-one)
    refresh=1
    arguments=(--target "$2")
    [[ -f build/$2/arguments ]] && mapfile -d '' -t arguments < "build/$2/arguments" ;;
  *) arguments=("$@") ;;
esac

applyArguments "${arguments[@]}"
if [[ -z $target ]]; then
  target=SimRelease
  [[ -f build/default ]] && target=$(< build/default)
fi
[[ $target =~ ^[A-Za-z][A-Za-z0-9_]*$ ]] || fail "target '$target': a name is letters and digits"
settingsFile=scripts/targets/$target.settings
if [[ -f $settingsFile ]]; then
  # shellcheck disable=SC1090
  source "$settingsFile"
  applyArguments "${arguments[@]}" # again: arguments win over the file
elif [[ -z $output ]]; then
  known=(scripts/targets/*.settings); known=("${known[@]##*/}")
  fail "no target '$target': there is ${known[*]%.settings}; write $settingsFile or give --output NAME"
fi
[[ ! $precompiled || -f $precompiled ]] || fail "precompiled: no file $precompiled"
for makefile in $includedMakefiles; do [[ -f $makefile ]] || fail "includedMakefiles: no file $makefile"; done

build=build/$target
[[ $outputDir ]] || outputDir=$build/bin
[[ $libraryDir ]] || libraryDir=$build/lib
if [[ $output ]]; then # one output takes everything
  moduleDirs="" programDirs="" testDirs="" benchDir="" supportDir=""
fi

mapfile -t found < <(findSources)
for path in "${found[@]}"; do
  [[ $path == *[!a-zA-Z0-9_./+-]* ]] && fail "source '$path': make takes letters, digits and _ . + - in a name; rename it"
done
# Unchanged since the last time? Then nothing is written. The list holds the file names and the settings.
state=$(printf '%s\n' "${found[@]}"; for name in "${settingNames[@]}"; do printf '%s=%s\n' "$name" "${!name}"; done)
if [[ $refresh && -f $build/state && $build/target.mk -nt $self && $build/target.mk -nt scripts/make/write_target.sh &&
  $(< "$build/state") == "$state" ]]; then exit 0; fi

mkdir -p "$build"
# shellcheck source=scripts/make/write_target.sh
source scripts/make/write_target.sh
writeTarget

if ((${#arguments[@]})); then printf '%s\0' "${arguments[@]}"; fi > "$build/arguments"
if [[ ! $refresh ]]; then echo "$target" > build/default; fi
if [[ ! $refresh || ! -f compile_commands.json || $(cat build/default 2>/dev/null || echo "$target") == "$target" ]]; then
  writeCompileCommands
fi
printf '%s\n' "$state" > "$build/state"
[[ $refresh ]] || echo "Configured $target: ${#sources[@]} sources. Build it with: make $target"
