#!/usr/bin/env bash
# How long make takes when nothing changed, and when one module did: in a copy, so that the tree stays as it is.
set -euo pipefail
root=$(cd "$(dirname "$0")/../../.." && pwd)
unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES
cd "$root"
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
mkdir -p "$copy/bin" "$copy/build"
cp -a configure.sh Makefile CMakeLists.txt CMakePresets.json cmake scripts src utils tests "$copy/"
cp -a bin/*.sh "$copy/bin/"
cd "$copy"
make SimRelease > /dev/null # from the compiler cache, where there is one
export CCACHE="" # what the compiler takes
seconds() { local start end; start=$(date +%s%N); make SimRelease > log.txt; end=$(date +%s%N); awk "BEGIN { print ($end - $start) / 1e9 }"; }
nothing=$(seconds)
grep -q "^Nothing to be done" log.txt
module=$(find src/modules -name '*.cpp' | LC_ALL=C sort | head -1)
one=0 lines=""
if [[ $module ]]; then
  echo "// changed" >> "$module"
  one=$(seconds)
  lines=$(grep -c 'C++' log.txt)
  ((lines == 1))
fi
mkdir -p "$root/build/bench"
cat > "$root/build/bench/build.json" << E
[
  {"name": "build.make_nothing_changed", "value": $nothing, "unit": "s", "better": "lower", "target": 1},
  {"name": "build.make_one_module_changed", "value": $one, "unit": "s", "better": "lower"}
]
E
