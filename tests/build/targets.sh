#!/usr/bin/env bash
# Targets and what configure.sh takes; several targets side by side; what is refused.
source "$(dirname "$0")/project.bash"
writeSources
printf '#include <cstdio>\nint main() { std::printf("%%d\\n", VALUE); }\n' > src/main/tool.cpp

expect "configure says what it did" "$(./configure.sh --target SimRelease --cppflags+ "-DVALUE=1")" "Configured SimRelease. Build it with: make SimRelease"
builds
expect "argument" "$(bin/tool)" 1
./configure.sh --target=SimRelease --cppflags="-DVALUE=2" > /dev/null
builds
contains "new flags compile anew" "$(compiled)" "src/math/One.cpp"
expect "new argument" "$(bin/tool)" 2
touch src/math/New.cpp
builds
expect "arguments survive a new file" "$(compiled)" src/math/New.cpp

# A target of one's own is a preset. It disturbs no other, and another's arguments survive it.
cat > CMakeUserPresets.json << 'J'
{"version": 6, "configurePresets": [
  {"name": "Nao", "inherits": "common", "cacheVariables": {"CMAKE_CXX_FLAGS_NAO": "-O1 -DVALUE=3"}}
]}
J
builds Nao
expect "a preset" "$(build/Nao/bin/tool)" 3
expect "building is not configuring: the default stays" "$(cat build/default)" SimRelease
builds
expect "others stay" "$(compiled)" ""
expect "their arguments too" "$(bin/tool)" 2
sed -i 's/VALUE=3/VALUE=5/' CMakeUserPresets.json
builds Nao
expect "a changed preset" "$(build/Nao/bin/tool)" 5
./configure.sh --target Nao --outputDir "elsewhere" > /dev/null
builds
expect "configuring sets the default; where programs go" "$(elsewhere/tool)" 5
contains "help lists targets" "$(make help)" "Coverage, Fuzz, Nao, SimDebug, SimRelease, SimSanitize, SimThread"
contains "the flags that keep bytes" "$(grep '"command"' build/SimRelease/compile_commands.json | head -1)" "-O2 -g1 -ffp-contract=off -fno-math-errno -fno-trapping-math"

# Warnings are errors.
printf 'int unusedArgument(int a) { return 0; }\n' > src/math/Warn.cpp
build Nao
expect "a warning fails" "$status" 2
contains "its name" "$log" "unused parameter"
rm src/math/Warn.cpp

# Refused: one line, exit 2, nothing written.
refused() { # what, wanted text, arguments...
  local what=$1 wanted=$2 text
  shift 2
  text=$(./configure.sh "$@" 2>&1)
  expect "$what: status" $? 2
  expect "$what" "$text" "$wanted"
}
refused "unknown target" "configure.sh: no target 'Moon': there is Coverage Fuzz Nao SimDebug SimRelease SimSanitize SimThread; a preset of that name in CMakeUserPresets.json makes one" --target Moon
missing build/Moon
refused "unknown option" "configure.sh: unknown option --colour; see --help" --colour red
refused "no value" "configure.sh: option --cxx needs a value" --target SimRelease --cxx
refused "no compiler" "configure.sh: --cxx: no compiler no-such-g++ here" --target SimRelease --cxx no-such-g++
refused "no option" "configure.sh: argument 'SimRelease' is no option; options are --NAME VALUE and -DNAME=VALUE, see --help" SimRelease
expect "a refusal leaves the default" "$(cat build/default)" Nao
contains "configure --help" "$(./configure.sh --help)" "targets: Coverage Fuzz"
build Moon
expect "make of an unknown target: status" "$status" 2
contains "make of an unknown target" "$log" "no target 'Moon'"

# Without CMake, the error says how to get it.
mkdir tools
for tool in bash sed awk cat sort env dirname; do ln -s "$(command -v $tool)" tools/$tool; done
text=$(PATH=$project/tools ./configure.sh --target SimRelease 2>&1)
expect "no CMake" "$text" "configure.sh: no cmake: \`make packages\` installs what scripts/packages.txt lists"
finish
