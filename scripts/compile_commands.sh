#!/usr/bin/env bash
# Links compile_commands.json in the root to one of a target in which each source is compiled by itself, for editors and
# clang-tidy: CMake's own names the bundles in which the sources are compiled.
#   scripts/compile_commands.sh TARGET
# Example: scripts/compile_commands.sh SimRelease
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
from=build/$1/cmake/compile_commands.json to=build/$1/compile_commands.json
[[ -f $from ]] || { echo "compile_commands.sh: no $from: ./configure.sh --target $1 makes it" >&2; exit 2; }
awk '
  function entry(command, path) { printf "%s{\n  \"directory\": %s,\n  \"command\": %s,\n  \"file\": \"%s\"\n}", (count++ ? ",\n" : "[\n"), directory, command, path }
  function text(line) { sub(/^ *"[a-z]*": */, "", line); sub(/,$/, "", line); return line }
  /^ *"directory":/ { directory = text($0) }
  /^ *"command":/ {
    command = text($0)
    sub(/ -o [^ ]* -c /, " -c ", command)
    gsub(/-include [^ ]*cmake_pch\.hxx|-Winvalid-pch|-fpch-preprocess|--param=ggc[^ ]*/, "", command)
    gsub(/[^ "]*\/cmake\/compile_bundle\.sh |[^ "]*\/ccache /, "", command)
  }
  /^ *"file":/ {
    path = text($0); gsub(/"/, "", path)
    if (path !~ /\/Unity\/unity_[^\/]*$/) { if (path !~ /cmake_pch|precompiled_[a-z]*\.cpp$/) entry(command, path); next }
    bundle = path
    while ((getline line < bundle) > 0)
      if (match(line, /^#include "[^"]*"/)) {
        path = substr(line, 11, RLENGTH - 11)
        own = command
        at = index(own, bundle)
        entry(substr(own, 1, at - 1) path substr(own, at + length(bundle)), path)
      }
    close(bundle)
  }
  END { print "\n]" }' "$from" > "$to.new"
mv -f "$to.new" "$to"
ln -sfn "$to" compile_commands.json
