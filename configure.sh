#!/usr/bin/env bash
# Configures one target in build/<target>/ by CMake: its flags stand in CMakePresets.json (or in your own
# CMakeUserPresets.json), its sources are found. The target configured last is what `make` builds; what is given here
# is remembered until the target is configured again.
#
#   ./configure.sh [--target NAME] [OPTION]... [-DNAME=VALUE]...
#
#   --target NAME       the target; without it the one configured last, or SimRelease
#   --cxx COMPILER      the compiler of C++
#   --cppflags FLAGS    more flags of the compiler; --cxxflags is the same
#   --ldflags FLAGS     more flags of the linker
#   --outputDir DIR     where programs go
#   --prefix DIR        where `make install` installs to [/usr/local]
#   -DNAME=VALUE        a setting of CMake's or of CMakeLists.txt's
# An option may be written --NAME VALUE, --NAME=VALUE or --NAME+ VALUE, and --output-dir for --outputDir.
#
#   ./configure.sh --target SimRelease --cppflags -DTRACE
#   ./configure.sh --target SimDebug
set -euo pipefail
cd "${BASH_SOURCE[0]%/*}" 2> /dev/null || cd .
root=$PWD
fail() { echo "configure.sh: $*" >&2; exit 2; }
targets() { scripts/list_targets.sh; }

target="" default=1 options=() flags="" linkerFlags=""
given=("$@")
while (($#)); do
  argument=$1
  case $argument in
    -h | --help) sed -n '2,/^set /{/^set /d;s/^# \{0,1\}//p}' configure.sh; echo "targets: $(targets | tr '\n' ' ')"; exit 0 ;;
    --again) default="" given=("${given[@]:1}"); shift; continue ;; # for scripts/build.sh: leaves the default target as it is
    -D?*=*) options+=("$argument"); shift; continue ;;
    --*=*) value=${argument#*=} argument=${argument%%=*}; shift ;;
    --*) (($# > 1)) || fail "option $argument needs a value"
      value=$2; shift 2 ;;
    *) fail "argument '$argument' is no option; options are --NAME VALUE and -DNAME=VALUE, see --help" ;;
  esac
  case ${argument%+} in
    --target) target=$value ;;
    --cxx) command -v "$value" > /dev/null || fail "--cxx: no compiler $value here"
      options+=("-DCMAKE_CXX_COMPILER=$value") ;;
    --cppflags | --cxxflags | --flags) flags+=" $value" ;;
    --ldflags) linkerFlags+=" $value" ;;
    --outputDir | --output-dir) [[ $value == /* ]] || value=$root/$value
      options+=("-DPLUMBLINE_PROGRAMS=$value") ;;
    --prefix) [[ $value == /* ]] || value=$root/$value
      options+=("-DCMAKE_INSTALL_PREFIX=$value") ;;
    *) fail "unknown option $argument; see --help" ;;
  esac
done
if [[ ! $target ]]; then
  target=SimRelease
  [[ -f build/default ]] && target=$(< build/default)
fi
known=$(targets)
[[ $'\n'$known$'\n' == *$'\n'$target$'\n'* ]] ||
  fail "no target '$target': there is ${known//$'\n'/ }; a preset of that name in CMakeUserPresets.json makes one"
[[ $flags ]] && options+=("-DCMAKE_CXX_FLAGS=${flags# }")
[[ $linkerFlags ]] && options+=("-DCMAKE_EXE_LINKER_FLAGS=${linkerFlags# }")
for tool in cmake ninja; do
  command -v $tool > /dev/null || fail "no $tool: \`make packages\` installs what scripts/packages.txt lists"
done

build=build/$target
mkdir -p "$build"
# As --fresh does, but what was compiled stays, with the headers that are.
rm -rf "$build/cmake/CMakeCache.txt" "$build"/cmake/CMakeFiles/[0-9]*
cmake --preset "$target" "${options[@]}" > "$build/configure.log" 2>&1 || {
  grep -A12 -m1 'CMake Error' "$build/configure.log" >&2 || tail -5 "$build/configure.log" >&2
  rm -f "$build/presets"
  fail "CMake could not configure $target; see $build/configure.log"
}
sed -n 's/^-- \(.* is left out: .*\)/\1/p' "$build/configure.log"
cat CMakePresets.json CMakeUserPresets.json > "$build/presets" 2> /dev/null || true
if ((${#given[@]})); then printf '%s\0' "${given[@]}"; fi > "$build/arguments"
if [[ $default ]]; then
  echo "$target" > build/default
  echo "Configured $target. Build it with: make $target"
fi
if [[ $default || ! -e compile_commands.json ]]; then scripts/compile_commands.sh "$target"; fi
