#!/usr/bin/env bash
# What make builds when files change, come and go.
source "$(dirname "$0")/project.bash"
writeSources

builds SimRelease
expect "first build compiles" "$(compiled)" \
  "src/main/agent.cpp src/main/tool.cpp src/math/One.cpp src/math/Registry.cpp src/math/Two.cpp src/modules/perception/Seer.cpp"
expect "first build links" "$(linked)" "bin/agent bin/tool"
expect "what registers itself is linked whole" "$(bin/agent)" "1 modules"
expect "the library serves" "$(bin/tool)" "two 2"
expect "a program that includes no module links none" "$(nm -C bin/tool | grep -c registered)" 0
contains "lines tell how far it is" "$log" "[10/10] "
builds SimRelease
expect "nothing changed: nothing runs" "$log" "Nothing to be done for SimRelease."

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

# A header included anew by one source is known after one compile; one that went with its includes is no error.
printf '#pragma once\ninline int three() { return 3; }\n' > src/math/Three.h
printf '#include "math/One.h"\n#include "math/Three.h"\nint one() { return three() - 2; }\n' > src/math/One.cpp
builds SimRelease
printf '#pragma once\ninline int three() { return 4; }\n' > src/math/Three.h
builds SimRelease
expect "newly included header" "$(compiled)" "src/math/One.cpp"
expect "its value" "$(bin/tool)" "two 4"
rm src/math/Three.h
printf '#include "math/One.h"\nint one() { return 1; }\n' > src/math/One.cpp
builds SimRelease
expect "header removed" "$(compiled)" "src/math/One.cpp"

# Files come: a module, a program, a test; and a whole folder.
mkdir -p src/robot
echo 'plumbline_library(robot USES math)' > src/robot/CMakeLists.txt
printf '#pragma once\nint joints();\n' > src/robot/Joints.h
printf '#include "robot/Joints.h"\n#include "math/Two.h"\nint joints() { return two() + 20; }\n' > src/robot/Joints.cpp
printf '#include "math/Registry.h"\nnamespace { const int loader = ++registered(); }\n' > src/modules/perception/Hearer.cpp
printf 'int main() { return 0; }\n' > src/main/extra.cpp
builds SimRelease
expect "added files" "$(compiled)" "src/main/extra.cpp src/modules/perception/Hearer.cpp src/robot/Joints.cpp"
expect "added module counts" "$(bin/agent)" "4 modules"
exists bin/extra
contains "compile_commands.json" "$(cat compile_commands.json)" '/src/robot/Joints.cpp"'

# A program links the libraries whose headers it includes, from the moment that it includes them.
printf '#include <cstdio>\n#include "robot/Joints.h"\nint main() { std::printf("%%d joints\\n", joints()); }\n' > src/main/tool.cpp
builds SimRelease
expect "another library" "$(bin/tool)" "22 joints"
rm -r src/robot
writeSources

# Files go.
rm src/modules/perception/Hearer.cpp src/main/extra.cpp
printf '#include "math/Registry.h"\nnamespace { const int loader = registered() += 3; }\n' > src/modules/perception/Seer.cpp
builds SimRelease
expect "removed module is gone" "$(bin/agent)" "3 modules"
lacks "compile_commands.json" "$(cat compile_commands.json)" Joints.cpp

# A folder without its line is an error.
mkdir src/vision
printf 'int see() { return 1; }\n' > src/vision/See.cpp
build SimRelease
expect "a folder without CMakeLists.txt: status" "$status" 2
contains "a folder without CMakeLists.txt" "$log" "src/vision has no CMakeLists.txt: one line"
rm -r src/vision

# A failed compile is repeated until it succeeds.
cp src/math/One.cpp one.txt
echo 'int broken(' >> src/math/One.cpp
for i in 1 2; do
  build SimRelease
  expect "broken source fails" "$status" 2
  contains "where" "$log" "src/math/One.cpp:3:"
done
cp one.txt src/math/One.cpp
builds SimRelease

# Test programs.
builds SimRelease-tests
expect "tests compile" "$(compiled)" "tests/math/TwoTest.cpp"
exists build/SimRelease/tests/math
printf '#include "math/One.h"\n#include <gtest/gtest.h>\nTEST(One, isOne) { EXPECT_EQ(one(), 1); }\n' > tests/math/OneTest.cpp
builds SimRelease-test-math
expect "added test" "$(compiled)" "tests/math/OneTest.cpp"
expect "CTest knows the tests" "$(ctest --test-dir build/SimRelease/cmake 2>&1 | grep '^100%')" "100% tests passed, 0 tests failed out of 1"

# In a terminal, where CMake writes in colours, its own lines are left out as well.
touch tests/script.txt
log=$(TERM=xterm script -qec "make SimRelease" /dev/null < /dev/null 2>&1 | tr -d '\r')
expect "a terminal shows none of CMake's lines" "$log" "Nothing to be done for SimRelease."

builds clean
missing build
missing bin/agent
missing compile_commands.json
exists bin/start.sh
finish
