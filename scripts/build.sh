#!/usr/bin/env bash
# Builds goals of one target, which is configured first if that is due. `make TARGET` calls it.
#   scripts/build.sh TARGET [GOAL]...     goals are names of programs, tests, bench, test-AREA, bench-AREA [all programs]
# Variables: V=1 shows commands; JOBS is how many run at once [one per core]; CCACHE= goes without ccache.
# Example: scripts/build.sh SimRelease agent simulator
set -uo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
target=$1
shift
build=build/$target
# Arguments given to configure.sh last time hold until the next.
if [[ ! -f $build/cmake/build.ninja || ! -f $build/presets ]] ||
  ! cmp -s <(cat CMakePresets.json CMakeUserPresets.json 2> /dev/null) "$build/presets"; then
  arguments=(--target "$target")
  [[ -s $build/arguments ]] && mapfile -d '' -t arguments < "$build/arguments"
  ./configure.sh --again "${arguments[@]}" || exit 2
fi
cmake/uses.sh "$build/cmake/uses.txt"
if [[ ${CCACHE-yes} == "" ]]; then export CCACHE_DISABLE=1; fi
# What ccache must overlook to serve sources that use precompiled headers, and trees that stand elsewhere.
export CCACHE_SLOPPINESS=${CCACHE_SLOPPINESS:+$CCACHE_SLOPPINESS,}pch_defines,time_macros,include_file_mtime,include_file_ctime
export CCACHE_BASEDIR=${CCACHE_BASEDIR:-$PWD} CCACHE_NOHASHDIR=${CCACHE_NOHASHDIR:-1}

options=(-C "$build/cmake" -j "${JOBS:-$(nproc)}")
if [[ ${V-} ]]; then exec ninja "${options[@]}" -v "${@:-all}"; fi
# The same short lines for everything: [17/126] what it does, and to what.
awk=(awk)
[[ $(awk -W version 2> /dev/null) == mawk* ]] && awk+=(-W interactive) # otherwise it waits for whole blocks of lines
NINJA_STATUS='[%f/%t] ' ninja "${options[@]}" "${@:-all}" 2>&1 | "${awk[@]}" -v root="$PWD/" -v target="$target" '
  function short(text,   at) {
    while ((at = index(text, root)) > 0) text = substr(text, 1, at - 1) substr(text, at + length(root))
    return text
  }
  /^ninja: Entering directory/ || /^\[[0-9]+\/[0-9]+\] (Re-checking|Re-running)/ || /^(\033\[[0-9;]*m)?-- / { next }
  /^ninja: no work to do/ { print "Nothing to be done for " target "."; next }
  /^ninja: build stopped/ { next }
  /^FAILED: / { getline; next } # and the command; V=1 shows it
  match($0, /^\[[0-9]+\/[0-9]+\] /) {
    status = substr($0, 1, RLENGTH); what = substr($0, RLENGTH + 1)
    split(substr(status, 2), n, /[\/\]]/)
    status = sprintf("[%" length(n[2]) "d/%d]", n[1], n[2])
    path = what; sub(/.* /, "", path)
    if (what ~ /^Building CXX object .*(cmake_pch|precompiled_)/) { say("C++", "headers that are compiled once"); next }
    if (what ~ /^Building CXX object/) {
      sub(/\.o$/, "", path)
      folder = path; sub(/\/?CMakeFiles\/.*/, "", folder)
      of = path; sub(/.*CMakeFiles\//, "", of); sub(/\.dir\/.*/, "", of)
      name = path; sub(/.*\.dir\//, "", name)
      number = ""
      if (sub(/^Unity\/unity_/, "", name)) { number = name; sub(/.*-/, " ", number); sub(/_cxx.*/, "", number); sub(/-[0-9]+_cxx.*/, "", name) }
      if (sub(/^test-/, "", of)) { if (number != "") name = of }
      else if (sub(/^bench-/, "", of)) { folder = "tests/bench"; if (number != "") name = of; else sub(/^bench\//, "", name) }
      else if (of !~ /^plumbline_/ && number != "") name = of
      else if (folder ~ ("/" name "$")) name = ""
      say("C++", folder (name == "" ? "" : "/") name number); next
    }
    if (match(what, /^Linking CXX [a-z]+ (library )?/)) {
      tool = what ~ /static/ ? "AR" : "LINK"
      path = short(substr(what, RLENGTH + 1)); gsub(/"/, "", path)
      say(tool, path); next
    }
    if (match(what, /^\[[A-Z]+\]\[[^\]]*\]/)) {
      split(substr(what, 2), parts, /\]/)
      say(parts[1], substr(parts[2], 2)); next
    }
    say("RUN", short(what)); next
  }
  function say(tool, what) { printf "%s %-6s%s\n", status, tool, what; fflush() }
  { print short($0); fflush() }'
status=${PIPESTATUS[0]}
if [[ $(readlink compile_commands.json) == "$build/compile_commands.json" && build/$target/cmake/build.ninja -nt $build/compile_commands.json ]]; then
  scripts/compile_commands.sh "$target"
fi
exit "$((status ? 2 : 0))"
