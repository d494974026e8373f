#!/usr/bin/env bash
# What make builds when files change, come and go.
source "$(dirname "$0")/project.bash"
writeSources

builds SimRelease
expect "first build compiles" "$(compiled)" \
  "src/main/agent.cpp src/main/tool.cpp src/math/One.cpp src/math/Registry.cpp src/math/Two.cpp src/modules/perception/Seer.cpp"
expect "first build links" "$(linked)" "bin/agent bin/tool"
expect "the modules are linked whole" "$(bin/agent)" "1 modules"
expect "the library serves" "$(bin/tool)" "two 2"

builds SimRelease
expect "nothing changed: nothing runs" "$log" "make: Nothing to be done for 'SimRelease'."
build -q SimRelease
expect "nothing changed: make -q" "$status" 0

# One changed module: one compile, one link.
printf '#include "math/Registry.h"\nnamespace { const int loader = registered() += 3; }\n' > src/modules/perception/Seer.cpp
builds SimRelease
expect "changed module compiles" "$(compiled)" "src/modules/perception/Seer.cpp"
expect "changed module links" "$(linked)" "bin/agent"
expect "changed module counts" "$(bin/agent)" "3 modules"

# A header: exactly those that include it.
printf '// changed\n' >> src/math/One.h
builds SimRelease
expect "changed header" "$(compiled)" "src/math/One.cpp src/math/Two.cpp"

# A header included anew by one source is known after one compile.
printf '#pragma once\ninline int three() { return 3; }\n' > src/math/Three.h
printf '#include "math/One.h"\n#include "math/Three.h"\nint one() { return three() - 2; }\n' > src/math/One.cpp
builds SimRelease
expect "changed source" "$(compiled)" "src/math/One.cpp"
printf '#pragma once\ninline int three() { return 4; }\n' > src/math/Three.h
builds SimRelease
expect "newly included header" "$(compiled)" "src/math/One.cpp"
expect "its value" "$(bin/tool)" "two 4"

# A header that went together with its includes is no error.
rm src/math/Three.h
printf '#include "math/One.h"\nint one() { return 1; }\n' > src/math/One.cpp
builds SimRelease
expect "header removed" "$(compiled)" "src/math/One.cpp"

# Files come: a module, a program, and a whole folder.
mkdir -p src/robot
printf '#include "math/Registry.h"\nnamespace { const int loader = ++registered(); }\n' > src/modules/perception/Hearer.cpp
printf 'int unused() { return 0; }\n' > src/robot/Unused.cpp
printf 'int main() { return 0; }\n' > src/main/extra.cpp
builds SimRelease
expect "added files" "$(compiled)" "src/main/extra.cpp src/modules/perception/Hearer.cpp src/robot/Unused.cpp"
expect "added module counts" "$(bin/agent)" "4 modules"
exists bin/extra
contains "compile_commands.json" "$(cat compile_commands.json)" '"file":"src/robot/Unused.cpp"'

# Files go, and take object, dependencies and program along.
rm -r src/modules/perception/Hearer.cpp src/main/extra.cpp src/robot
builds SimRelease
expect "removed files: nothing to compile" "$(compiled)" ""
expect "removed module is gone" "$(bin/agent)" "3 modules"
missing bin/extra
missing build/SimRelease/obj/src/modules/perception/Hearer.cpp.o
missing build/SimRelease/obj/src/modules/perception/Hearer.cpp.d
lacks "compile_commands.json" "$(cat compile_commands.json)" Unused.cpp

# A failed compile is repeated until it succeeds.
cp src/math/One.cpp one.txt
echo 'int broken(' >> src/math/One.cpp
build SimRelease
expect "broken source fails" "$status" 2
build SimRelease
expect "broken source fails again" "$status" 2
cp one.txt src/math/One.cpp
builds SimRelease
expect "mended source" "$(compiled)" "src/math/One.cpp"

# Test programs.
builds SimRelease-tests
expect "tests compile" "$(compiled)" "tests/math/TwoTest.cpp"
exists build/SimRelease/tests/math
printf '#include "math/One.h"\n#include <gtest/gtest.h>\nTEST(One, isOne) { EXPECT_EQ(one(), 1); }\n' > tests/math/OneTest.cpp
builds SimRelease-test-math
expect "added test" "$(compiled)" "tests/math/OneTest.cpp"

builds clean
missing build
missing bin/agent
missing compile_commands.json
finish
