# For the tests of the build: a small project in a folder of its own, built by the real scripts.
# Sourced by tests/build/*.sh; the working directory becomes that project.
set -uo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../support/far-off.bash"
repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES JOBS V
export CCACHE="" LC_ALL=C
project=$(mktemp -d "${TMPDIR:-/tmp}/plumbline build XXXXXX") # with spaces: the path of a clone is not ours to choose
trap 'rm -rf "$project"' EXIT
cp -r "$repository"/{configure.sh,Makefile,scripts,cmake,CMakeLists.txt,CMakePresets.json} "$project/"
cd "$project" || exit 1
# Each source by itself tells what a change compiles; no headers of others are compiled.
sed -i 's/"PLUMBLINE_BUNDLE": "[0-9]*"/"PLUMBLINE_BUNDLE": "1"/; s/"PLUMBLINE_PRECOMPILE": "ON"/"PLUMBLINE_PRECOMPILE": "OFF"/' CMakePresets.json
mkdir -p bin config src/math src/modules/perception src/main tests/math utils
cp "$repository"/bin/*.sh bin/
for file in src/CMakeLists.txt src/main/CMakeLists.txt src/modules/CMakeLists.txt utils/CMakeLists.txt tests/CMakeLists.txt; do
  cp "$repository/$file" "$file"
done
echo 'plumbline_library(math)' > src/math/CMakeLists.txt
echo 'plumbline_library(modules REGISTERS USES math)' > src/modules/CMakeLists.txt

checks=0
fail() { echo "FAILED at ${BASH_SOURCE[-1]##*/}:${BASH_LINENO[-2]}: $*" >&2; exit 1; }

# Runs make; keeps its output in $log and its status in $status.
build() { log=$(make "$@" 2>&1); status=$?; }
builds() { build "$@"; ((status == 0)) || fail "make $* failed: $log"; }

# The sources compiled by the last make, sorted, in one line.
compiled() { sed -n 's/^\[ *[0-9]*\/[0-9]*\] C++ *//p' <<< "$log" | sort | tr '\n' ' ' | sed 's/ $//'; }
linked() { sed -n 's/^\[ *[0-9]*\/[0-9]*\] LINK *//p' <<< "$log" | sort | tr '\n' ' ' | sed 's/ $//'; }

# expect WHAT IS WANTED
expect() { [[ $2 == "$3" ]] || fail "$1: is '$2', should be '$3'"; checks=$((checks + 1)); }
contains() { [[ $2 == *"$3"* ]] || fail "$1: '$2' does not contain '$3'"; checks=$((checks + 1)); }
lacks() { [[ $2 != *"$3"* ]] || fail "$1: '$2' contains '$3'"; checks=$((checks + 1)); }
exists() { [[ -e $1 ]] || fail "no $1"; checks=$((checks + 1)); }
missing() { [[ ! -e $1 ]] || fail "$1 is still there"; checks=$((checks + 1)); }

# Two sources in the library, one module that registers itself, two programs, one test.
writeSources() {
  cat > src/math/One.h << 'H'
#pragma once
int one();
H
  printf '#include "math/One.h"\nint one() { return 1; }\n' > src/math/One.cpp
  printf '#pragma once\nint two();\n' > src/math/Two.h
  printf '#include "math/Two.h"\n#include "math/One.h"\nint two() { return one() + one(); }\n' > src/math/Two.cpp
  printf '#pragma once\nint& registered();\n' > src/math/Registry.h
  printf '#include "math/Registry.h"\nint& registered() { static int n = 0; return n; }\n' > src/math/Registry.cpp
  printf '#pragma once\n' > src/modules/Loader.h
  printf '#include "math/Registry.h"\nnamespace { const int loader = ++registered(); }\n' > src/modules/perception/Seer.cpp
  printf '#include <cstdio>\n#include "math/Registry.h"\n#include "modules/Loader.h"\nint main() { std::printf("%%d modules\\n", registered()); }\n' > src/main/agent.cpp
  printf '#include <cstdio>\n#include "math/Two.h"\nint main() { std::printf("two %%d\\n", two()); }\n' > src/main/tool.cpp
  printf '#include "math/Two.h"\n#include <gtest/gtest.h>\nTEST(Two, isTwo) { EXPECT_EQ(two(), 2); }\n' > tests/math/TwoTest.cpp
}

finish() { echo "$checks checks passed"; }
