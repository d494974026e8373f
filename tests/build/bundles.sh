#!/usr/bin/env bash
# Sources compiled in one go: when they change, come and go, when their names meet, and when one is wrong.
source "$(dirname "$0")/project.bash"
writeSources
sed -i 's/"PLUMBLINE_BUNDLE": "1"/"PLUMBLINE_BUNDLE": "3"/; s/"PLUMBLINE_ALONE": "modules[^"]*"/"PLUMBLINE_ALONE": ""/' CMakePresets.json

builds SimRelease
expect "neighbours are compiled in one go" "$(compiled)" "src/main/agent 1 src/main/tool 1 src/math 1 src/modules/perception 1"
expect "modules" "$(bin/agent)" "1 modules"
expect "the library serves" "$(bin/tool)" "two 2"
builds SimRelease
expect "nothing changed" "$log" "Nothing to be done for SimRelease."
contains "editors see each source" "$(cat compile_commands.json)" '/src/math/One.cpp"'
lacks "editors see each source alone" "$(cat compile_commands.json)" Unity
lacks "editors and clang-tidy, which are not GCC, are spared its collector" "$(cat compile_commands.json)" ggc-

# A source or a header: its bundle alone.
printf '// changed\n' >> src/math/One.h
builds SimRelease
expect "changed header" "$(compiled)" "src/math 1"
sed -i 's/1;/2;/' src/math/One.cpp
builds SimRelease
expect "changed source" "$(compiled)" "src/math 1"
expect "its value" "$(bin/tool)" "two 4"

# One source is edited: it is compiled, and the others once beside it.
edit() { sed -i "s/return [0-9]*;/return $1;/" src/math/One.cpp; }
parts() { stat -c '%n %y' "$(find build/SimRelease/cmake/src/math -name '*.edited')"/*.o; }
edit 4
builds SimRelease
before=$(parts)
expect "edited" "$(bin/tool)" "two 8"
edit 5
builds SimRelease
expect "edited again" "$(bin/tool)" "two 10"
expect "its others are as they were" "$(grep others <<< "$before")" "$(parts | grep others)"
[[ $(grep one.o <<< "$before") != "$(parts | grep one.o)" ]] || fail "it was not compiled"
printf '// changed\n' >> src/math/Two.h
edit 6
builds SimRelease
[[ $(grep others <<< "$before") != "$(parts | grep others)" ]] || fail "a header of the others was overlooked"
expect "edited with a header" "$(bin/tool)" "two 12"
sed -i 's/one() + one()/one() + one() + 1/' src/math/Two.cpp
builds SimRelease
expect "another one is edited" "$(bin/tool)" "two 13"
sed -i 's/ + 1//' src/math/Two.cpp
edit 2
builds SimRelease
expect "two at once: the bundle" "$(bin/tool)" "two 4"
expect "no parts are left" "$(find build/SimRelease/cmake/src/math -name '*.edited')" ""
sed -i 's/return 2/return two/' src/math/One.cpp
build SimRelease
expect "a wrong edit fails" "$status" 2
contains "and says where" "$log" "src/math/One.cpp:2:"
edit() { sed -i "s/return [0-9a-z]*;/return $1;/" src/math/One.cpp; }
edit 2
builds SimRelease
expect "and is mended" "$(bin/tool)" "two 4"
builds SimRelease
expect "nothing changed after an edit" "$log" "Nothing to be done for SimRelease."

# The others of a large bundle are compiled in parts, and only those that change are compiled again.
for name in Third Fourth Fifth; do printf 'int %s() { return 1; }\n' $name > src/math/$name.cpp; done
sed -i 's/"PLUMBLINE_BUNDLE": "3"/"PLUMBLINE_BUNDLE": "6"/' CMakePresets.json
builds SimRelease
edit 3
builds SimRelease
before=$(parts)
expect "four parts and the edited one" "$(wc -l <<< "$before")" 5
expect "edited beside parts" "$(bin/tool)" "two 6"
printf '// changed\n' >> src/math/Two.h
edit 2
builds SimRelease
expect "one part includes what changed" "$(grep others <<< "$before" | grep -vxFf <(parts) | wc -l)" 1
expect "edited beside a changed part" "$(bin/tool)" "two 4"
rm src/math/Third.cpp src/math/Fourth.cpp src/math/Fifth.cpp
sed -i 's/"PLUMBLINE_BUNDLE": "6"/"PLUMBLINE_BUNDLE": "3"/' CMakePresets.json
builds SimRelease

# Names that meet: the halves, and their dependencies are known all the same.
printf '#include "math/One.h"\nnamespace { int helper() { return 1; } }\nint one() { return helper(); }\n' > src/math/One.cpp
printf '#include "math/One.h"\n#include "math/Two.h"\nnamespace { int helper() { return 2; } }\nint two() { return one() * helper(); }\n' > src/math/Two.cpp
builds SimRelease
contains "names that meet are listed" "$log" "unity_math-1_cxx.cxx: in halves, as: "
contains "which ones" "$log" "helper"
expect "each has its own" "$(bin/tool)" "two 2"
builds SimRelease
expect "nothing changed after halves" "$log" "Nothing to be done for SimRelease."
printf '// changed\n' >> src/math/Registry.h
builds SimRelease
contains "a header of one of them" "$(compiled)" "src/math 1"
sed -i 's/return 2/return 3/' src/math/Two.cpp
builds SimRelease
expect "a source of them" "$(bin/tool)" "two 3"

# An error names the source alone, and what was built stays away.
sed -i 's/return 3/return three/' src/math/Two.cpp
build SimRelease
expect "a wrong source fails" "$status" 2
contains "the wrong source" "$log" "src/math/Two.cpp:3:"
expect "it is said once" "$(grep -c "error:.*three" <<< "$log")" 1
sed -i 's/return three/return 3/' src/math/Two.cpp
builds SimRelease

# Files come and go, without a word to other folders.
mkdir -p src/math/apart
for name in More Most; do printf 'int %s() { return 1; }\n' $name > src/math/$name.cpp; done
for name in A B; do printf 'int apart%s() { return 1; }\n' $name > src/math/apart/$name.cpp; done
builds SimRelease
contains "two bundles" "$(compiled)" "src/math 2"
printf 'int another() { return 1; }\n' > src/math/apart/Another.cpp
builds SimRelease
expect "another file in a folder" "$(compiled)" "src/math/apart 1"
rm src/math/Most.cpp src/math/More.cpp
builds SimRelease
lacks "a file less in a folder" "$(compiled)" apart
expect "works" "$(bin/tool)" "two 3"
finish
