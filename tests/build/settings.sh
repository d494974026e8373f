#!/usr/bin/env bash
# Settings: defaults, targets' files, arguments; several targets side by side; what is refused.
source "$(dirname "$0")/project.bash"
writeSources
printf '#include <cstdio>\nint main() { std::printf("%%d\\n", VALUE); }\n' > src/main/tool.cpp

# As on a fresh machine: what only benchmarks need is not there.
sed -i 's|/usr/include/mujoco|no/mujoco|' scripts/targets/common.sh
./configure.sh --target SimRelease --cppflags+ "-DVALUE=1" > out.txt
expect "configure without MuJoCo" $? 0
expect "configure says what it did" "$(cat out.txt)" "Configured SimRelease: 7 sources. Build it with: make SimRelease"
builds
expect "argument" "$(bin/tool)" 1
./configure.sh --target=SimRelease --cppflags="-DVALUE=2" > /dev/null
builds
contains "new flags compile anew" "$(compiled)" "src/math/One.cpp"
expect "new argument" "$(bin/tool)" 2
touch src/math/New.cpp
builds
expect "arguments survive a new file" "$(compiled)" src/math/New.cpp
expect "arguments survive" "$(bin/tool)" 2

# A new target is one settings file. It disturbs no other.
before=$(cd build/SimRelease && find . -type f -exec stat -c '%n %Y' {} + | sort)
cat > scripts/targets/Nao.settings << 'E'
cppflags="-DVALUE=3"
flags="-O1"
ignoredDirs="src/modules/perception src/main/agent.cpp"
programsWithModules=""
E
builds Nao
expect "settings file" "$(build/Nao/bin/tool)" 3
missing build/Nao/bin/agent
missing build/Nao/lib/libmodules.a
expect "others stay" "$(cd build/SimRelease && find . -type f -exec stat -c '%n %Y' {} + | sort)" "$before"
expect "building is not configuring: the default stays" "$(cat build/default)" SimRelease
./configure.sh --target Nao --cppflags "-DVALUE=4" > /dev/null
builds
expect "configuring sets the default; arguments win over the file" "$(build/Nao/bin/tool)" 4
sed -i 's/-O1/-O2/' scripts/targets/Nao.settings
builds
contains "a changed settings file compiles anew" "$(compiled)" src/math/One.cpp
builds all
expect "all: every configured target" "$(compiled)" ""
touch src/math/One.cpp
builds all
expect "all compiles in each" "$(compiled)" "src/math/One.cpp src/math/One.cpp"
contains "help lists targets" "$(make help)" "Fuzz, Nao, SimDebug, SimRelease, SimSanitize"

# Warnings are errors in the debug build, but not in generated sources (see generated.sh).
printf 'int unusedArgument(int a) { return 0; }\n' > src/math/Warn.cpp
sed -i 's/VALUE/0/' src/main/tool.cpp
build SimDebug
expect "a warning fails SimDebug" "$status" 2
contains "its name" "$log" "unused parameter"
rm src/math/Warn.cpp
builds SimDebug

# Refused: one line, exit 2, nothing written.
refused() { # what, wanted text, arguments...
  local what=$1 wanted=$2 text
  shift 2
  text=$(./configure.sh "$@" 2>&1)
  expect "$what: status" $? 2
  expect "$what" "$text" "$wanted"
}
refused "unknown target" "configure.sh: no target 'Moon': there is Fuzz Nao SimDebug SimRelease SimSanitize; write scripts/targets/Moon.settings or give --output NAME" --target Moon
missing build/Moon
refused "unknown option" "configure.sh: unknown option --colour; see --help" --colour red
refused "no value" "configure.sh: option --cxx needs a value" --target SimRelease --cxx
refused "no option" "configure.sh: argument 'SimRelease' is no option; options are --SETTING VALUE, see --help" SimRelease
refused "bad name" "configure.sh: target '../x': a name is letters and digits" --target ../x
refused "no makefile" "configure.sh: includedMakefiles: no file gone.mk" --target SimRelease --included-makefiles gone.mk
refused "no sources" "configure.sh: target Empty: no sources in none" --target Empty --output empty --source-dirs none
touch "src/math/A b.cpp"
refused "blank in a name" "configure.sh: source 'src/math/A b.cpp': make takes letters, digits and _ . + - in a name; rename it" --target SimRelease
rm "src/math/A b.cpp"
./configure.sh --target Cross --output cross --cxx no-such-g++ > /dev/null
build Cross
expect "no compiler: status" "$status" 2
contains "no compiler" "$log" "no compiler no-such-g++ for Cross: \`make packages\` installs what scripts/packages.txt lists"
contains "configure --help" "$(./configure.sh --help)" "--ignoredDirs"
finish
