#!/usr/bin/env bash
# Sources compiled in one go: when they change, come and go, when their names meet, and when one is wrong.
source "$(dirname "$0")/project.bash"
writeSources
printf 'together="3"\ncxxflags="-std=c++20"\n' > scripts/targets/Fast.settings

builds Fast
expect "neighbours are compiled in one go" "$(compiled)" \
  "build/Fast/together/agent.program.src-main0.cpp build/Fast/together/libmodules.a.modules.src-modules-perception0.cpp build/Fast/together/libplumbline.a.library.src-math0.cpp build/Fast/together/tool.program.src-main0.cpp"
expect "modules" "$(build/Fast/bin/agent)" "1 modules"
expect "the library serves" "$(build/Fast/bin/tool)" "two 2"
builds Fast
expect "nothing changed" "$log" "make: Nothing to be done for 'Fast'."

# A source or a header: its bundle alone.
printf '// changed\n' >> src/math/One.h
builds Fast
expect "changed header" "$(compiled)" build/Fast/together/libplumbline.a.library.src-math0.cpp
sed -i 's/1;/2;/' src/math/One.cpp
builds Fast
expect "changed source" "$(compiled)" build/Fast/together/libplumbline.a.library.src-math0.cpp
expect "its value" "$(build/Fast/bin/tool)" "two 4"

# Names that meet: the halves, and their dependencies are known all the same.
printf '#include "math/One.h"\nnamespace { int helper() { return 1; } }\nint one() { return helper(); }\n' > src/math/One.cpp
printf '#include "math/One.h"\n#include "math/Two.h"\nnamespace { int helper() { return 2; } }\nint two() { return one() * helper(); }\n' > src/math/Two.cpp
builds Fast
contains "names that meet are told" "$log" "together/libplumbline.a.library.src-math0.cpp: in halves, as: "
contains "which ones" "$log" "helper"
expect "each has its own" "$(build/Fast/bin/tool)" "two 2"
builds Fast
expect "nothing changed after halves" "$log" "make: Nothing to be done for 'Fast'."
printf '// changed\n' >> src/math/Registry.h
builds Fast
contains "a header of one of them" "$(compiled)" build/Fast/together/libplumbline.a.library.src-math0.cpp
sed -i 's/return 2/return 3/' src/math/Two.cpp
builds Fast
expect "a source of them" "$(build/Fast/bin/tool)" "two 3"

# An error is told of the source alone, and what was built stays away.
sed -i 's/return 3/return three/' src/math/Two.cpp
build Fast
((status != 0)) || fail "a wrong source is built"
contains "the wrong source" "$log" "src/math/Two.cpp:3:"
expect "it is told once" "$(grep -c "error:.*three" <<< "$log")" 1
sed -i 's/return three/return 3/' src/math/Two.cpp
builds Fast

# Files come and go, without a word to other folders.
for name in More Most; do printf 'int %s() { return 1; }\n' $name > src/math/$name.cpp; done
mkdir src/apart src/math/sub
printf 'int sub() { return 1; }\n' > src/math/sub/Sub.cpp
for name in A B C; do printf 'int apart%s() { return 1; }\n' $name > src/apart/$name.cpp; done
builds Fast
exists build/Fast/obj/together/libplumbline.a.library.src-math1.o
printf 'int another() { return 1; }\n' > src/apart/Another.cpp
builds Fast
expect "another file in a folder" "$(compiled)" build/Fast/together/libplumbline.a.library.src-apart0.cpp
rm src/math/Most.cpp src/math/sub/Sub.cpp
builds Fast
lacks "a file less in a folder" "$(compiled)" apart
./configure.sh --target Fast > /dev/null
contains "compile_commands.json" "$(cat compile_commands.json)" '"file":"src/math/More.cpp"'
rm src/math/More.cpp
builds Fast
missing build/Fast/obj/together/libplumbline.a.library.src-math1.o
expect "works" "$(build/Fast/bin/tool)" "two 3"
rm src/math/Two.cpp src/math/Two.h src/main/tool.cpp
sed -i 's/helper() { return 1/helper() { return 7/' src/math/One.cpp
builds Fast
missing build/Fast/bin/tool
finish
