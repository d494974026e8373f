#!/usr/bin/env bash
# The scripts behind make: modules and their tests, where something is, the test runner, the packages.
source "$(dirname "$0")/project.bash"
writeSources

# Modules and their tests.
mkdir -p tests/modules/perception
cat > src/modules/perception/Seer.h << 'H'
#pragma once
MODULE(Seer)
  REQUIRES(Picture)
  REQUIRES_ALL(Eye)
  USES(Glance)
  REQUIRES_IF_PROVIDED(Lamp)
  PROVIDES(Sight)
  PARAMETER(double, focus, 0.5, "m", Range(0, 1), "of the eye")
END_MODULE
H
text=$(scripts/check_floors.sh)
expect "modules: status" $? 1
expect "modules" "$text" 'src/modules/perception/Seer.h:1: this module has no test tests/modules/perception/SeerTest.cpp'
printf '#include "modules/perception/Seer.h"\n' > tests/modules/perception/SeerTest.cpp
scripts/check_floors.sh || fail "a module with its test refused"

# Where something is.
mkdir -p config/{modules,motions,robots/type3/motions,platforms/rig} doc/{reference,decisions,results} tests/{e2e,support,data/samples} src/representations/perception
mkdir -p {src,tests}/modules/perception/eye
sed -i '/^MODULE/i #include "modules/perception/eye/Lens.h"\n#include "representations/perception/Sight.h"\n\n/// Sees what\n/// is far.' src/modules/perception/Seer.h
printf '/// Bends light.\nclass Lens {};\n' > src/modules/perception/eye/Lens.h
printf '#include "modules/perception/eye/Lens.h"\n' |
  tee tests/modules/perception/eye/LensTest.cpp > tests/modules/perception/ViewTest.cpp
printf '// As Seer does.\n' > tests/modules/perception/OtherTest.cpp
printf 'config.file("worlds/" + name); config.file("glasses"); path(directory) / "night.yaml";\n' > src/modules/perception/Seer.cpp
mkdir -p config/worlds config/walks/type3
touch config/{glasses,night}.yaml config/walks/type3/glasses.yaml
printf 'far: 2\n' | tee config/Seer.yaml > config/robots/type3/Seer.yaml
printf 'Seer Sight\n' > config/modules/perception.cfg
printf 'include ../../modules/perception.cfg\n' > config/platforms/rig/modules.cfg
printf '## Seer\n\n| `focus` | double | 0.5 | m | 0 … 1 | of the eye |\n' > doc/reference/parameters.md
printf 'The `Seer` sees.\n' | tee doc/reference/{seeing,framework}.md doc/decisions/0001-eyes.md > doc/results/seen.md
printf 'A Seer of old.\n' > doc/reference/legends.md # a common word is no module
printf 'bin/agent --modules Seer\n' > tests/e2e/see.sh
# Tests that run it with others: by a fixture (a comment is none), as one of all, in agents of its platform.
printf 'std::string look() {\n  return R"(Seer Sight\n)";\n}\nstd::string lookAround() {\n  return look() + "";\n}\nint blind() {\n}\n' > tests/support/Eyes.cpp
printf '/// How it is used: ModuleHarness<Seer>\n' > tests/support/Harness.h
printf '#include "support/Harness.h"\n' > tests/modules/perception/PlainTest.cpp
for call in lookAround blind; do printf '#include "support/Eyes.h"\n%s();\n' $call > tests/modules/perception/${call^}Test.cpp; done
printf 'Registry::instance().modules()\n' > tests/modules/EachTest.cpp
printf 'constexpr const char* defaultPlatform = "rig";\n' >> src/main/agent.cpp
printf '"$bin/agent" --port 1\n' | tee tests/e2e/play.sh > tests/e2e/plod.sh
printf '"$bin/agent" --speed\n' > tests/e2e/wrong.sh
printf '/// Hears.\nREPRESENTATION(Sound)\n  STREAM(loud);\n};\n/// Is seen.\nREPRESENTATION(Sight)\n  void stream() { STREAM(far); }\n};\n' > src/representations/perception/Sight.h
printf 'keyframes:\n' > config/motions/blink.yaml
printf 'mirror: blink\n' > config/motions/blinkLeft.yaml
printf 'struct ClimbOptions {\n  int steps = 3;  ///< at a time\n};\n/// Goes up.\nclass Climb {};\n' > src/math/Climb.h
printf 'MAKE_OPTIMIZER(climb,\n               {"hill-climb", 5,\n' > src/math/Climb.cpp
text=$(scripts/where.sh Seer)
expect "where: status" $? 0
expect "where: a module" "$text" 'module Seer
  does        Sees what is far.
  source      src/modules/perception/Seer.h and .cpp
  parts       src/modules/perception/eye/Lens.h
  requires    Picture, all Eye, Glance (of the cycle before), Lamp (if provided)
  provides    Sight
  their files src/representations/perception/Sight.h
  parameters  focus=0.5 m (0…1); what each does: doc/reference/parameters.md#seer
  data        config/Seer.yaml, config/robots/type3/Seer.yaml, config/glasses.yaml, config/night.yaml, config/worlds/
  runs by     config/modules/perception.cfg
  tests       tests/modules/perception/SeerTest.cpp
    of parts  tests/modules/perception/eye/LensTest.cpp, tests/modules/perception/ViewTest.cpp
    fixtures  tests/modules/perception/LookAroundTest.cpp
    over all  tests/modules/EachTest.cpp
  end-to-end  tests/e2e/see.sh
    in agents tests/e2e/*.sh: play plod
  page        doc/decisions/0001-eyes.md, doc/reference/seeing.md, doc/reference/framework.md
  results     doc/results/seen.md'
rm -r doc/{reference/{seeing,framework,legends},decisions/*,results/*}.md config/Seer.yaml config/robots/type3/Seer.yaml config/{glasses,night}.yaml config/{worlds,walks}
contains "where: what there is not" "$(scripts/where.sh Seer)" "  data        none
"
contains "where: no page" "$(scripts/where.sh Seer)" "  page        none: what it does is said above; doc/how-to/add-a-module.md says how one is made"
rm -r doc
contains "where: parameters of the header" "$(scripts/where.sh Seer)" "  parameters  focus=0.5 m (0…1)"
contains "where: a representation" "$(scripts/where.sh sight)" 'representation Sight
  does        Is seen.
  source      src/representations/perception/Sight.h
  fields      far
  provided by Seer'
printf 'motion: blink\n' > config/Eyes.yaml
text=$(scripts/where.sh blink)
contains "where: a keyframe motion" "$text" "  data        config/motions/blink.yaml
  named in    config/Eyes.yaml"
mkdir src/motion
printf 'name = "blink";\n' > src/motion/Chooser.cpp
mkdir tests/motion
touch tests/motion/ChooserTest.cpp
contains "where: who chooses it" "$(scripts/where.sh blink)" "    of users  tests/motion/ChooserTest.cpp"
rm -r {src,tests}/motion
contains "where: its mirror image" "$(scripts/where.sh blinkLeft)" "  mirrors     blink (scripts/where.sh blink)"
mkdir -p src/{gap,simulation}/effects
printf 'const Effect wobble{\n    .id = "wobble",\n    .unit = "rad",\n    .sites = {Site::link, Site::joint},\n    .lower = 0,\n    .upper = 2,\n    .sentence = "The link of {at} wobbles, "\n                "and more than the model.",\n};\nMAKE_EFFECT(wobble);\n' > src/gap/effects/Wobble.cpp
printf '/// Wobbles.\nconst LeagueEffect wobble{\n    .id = "wobble",\n    .upper = 3,\n};\nMAKE_LEAGUE_EFFECT(wobble);\n' > src/simulation/effects/Wobble.cpp
printf 'for (const Effect* effect : effects())\n' > tests/math/AllEffectsTest.cpp
text=$(scripts/where.sh wobble)
contains "where: an effect" "$text" 'effect wobble
  source      src/gap/effects/Wobble.cpp
  does        The link of [its place] wobbles, and more than the model.
  at          link, joint
  parameters  its value, 0…2 rad; 0: none
  data        none
    over all  tests/math/AllEffectsTest.cpp'
contains "where: an effect of the league" "$text" 'effect of the league wobble
  source      src/simulation/effects/Wobble.cpp
  does        Wobbles.
  at          joint
  parameters  its value, 0…3 rad; 0: none'
rm -r src/{gap,simulation}
contains "where: what registers itself" "$(scripts/where.sh hill-climb)" "optimiser hill-climb
  does        Goes up.
  source      src/math/Climb.h and .cpp
  parameters  steps=3 (at a time)"
# A robot of the league: its own files, recordings of it, tests that try it and those that try all types.
touch config/robots/simspark_type3.json config/robots/type3/motions/blink.yaml tests/data/samples/agent_type3.txt
printf 'test(simsparkRobot(3));\n' > tests/math/ThirdTest.cpp
printf 'test(simsparkRobot(2));\n' > tests/math/SecondTest.cpp
printf 'type < numSimsparkTypes()\n' > tests/math/TypesTest.cpp
printf 'for type in 0 3; do\n' > tests/e2e/types.sh
printf 'for type in 0 1; do\n' > tests/e2e/twins.sh
expect "where: a robot by its folder" "$(scripts/where.sh type3)" 'robot simspark_type3
  data        config/robots/simspark_type3.json, config/robots/type3/motions/blink.yaml
  recordings  tests/data/samples/agent_type3.txt
  source      src/robot/, src/simspark/LeagueRobots.h and .cpp
  parameters  none: links, joints, limits and servos are in its file (doc/reference/robot-files.md)
  tests       tests/math/ThirdTest.cpp
    over all  tests/math/TypesTest.cpp
  end-to-end  tests/e2e/types.sh'
text=$(scripts/where.sh Seher 2>&1)
expect "where: no such name: status" $? 2
expect "where: no such name" "$text" 'where.sh: nothing is called "Seher"; did you mean Seer?'
expect "where: nothing near" "$(scripts/where.sh Quaternion 2>&1)" 'where.sh: nothing is called "Quaternion"; see the map in doc/architecture.md'
expect "where: a name is no pattern" "$(scripts/where.sh '*' 2>&1)" 'where.sh: nothing is called "*"; see the map in doc/architecture.md'
expect "where: a word in common" "$(scripts/where.sh HillStart 2>&1)" 'where.sh: nothing is called "HillStart"; did you mean hill-climb?'
expect "where: a class of a library" "$(scripts/where.sh lens)" 'class Lens
  does        Bends light.
  source      src/modules/perception/eye/Lens.h
  included by src/modules/perception/Seer.h
  tests       tests/modules/perception/eye/LensTest.cpp, tests/modules/perception/ViewTest.cpp
  page        none: what it does is said above'
for name in Seer Sight blink wobble hill-climb type3 lens; do scripts/where.sh $name; done > /dev/null 2> where.err
expect "where: nothing on standard error" "$(grep -v wobble where.err)" ""
expect "where: no name" "$(scripts/where.sh 2>&1)" 'where.sh: give a NAME; see where.sh --help'
expect "where: an option" "$(scripts/where.sh --foo 2>&1)" 'where.sh: no option --foo; see where.sh --help'
rm -r src/modules/perception/{Seer.h,Seer.cpp,eye} tests/{modules,e2e,support,data} tests/math/{AllEffects,Second,Third,Types}Test.cpp config/{modules,motions,robots,platforms} \
  config/Eyes.yaml src/representations src/math/Climb.{h,cpp}
writeSources

# A macro of several lines, limits on one side, choices, groups.
printf '  PARAMETER(std::vector<double>, x, (std::vector<double>{1, 2}), "m",\n            Range::atLeast(0), "places, in order")\n  PARAMETER_CHOICE(foot, "left",\n                   "which", "left", "right")\n  PARAMETER_GROUP(LegParameters, leg, "of a leg")\n' > Feet.h
expect "where: parameters" "$(awk -f scripts/where_parameters.awk Feet.h)" 'x=(std::vector<double>{1, 2}) m (0…)
foot=left (left, right)
leg (those of LegParameters)'
rm Feet.h

# The test runner adds up test cases and scripts, and says what failed.
printf '#!/usr/bin/env bash\ntrue\n' > tests/math/good.sh
chmod +x tests/math/good.sh
build test-math
expect "good tests: status" "$status" 0
expect "good tests: last line" "$(tail -1 <<< "$log")" "2 passed, 0 failed"
printf '#include <gtest/gtest.h>\nTEST(One, isTwo) { EXPECT_EQ(1, 2); }\nTEST(One, isOne) { EXPECT_EQ(1, 1); }\n' > tests/math/OneTest.cpp
printf '#!/usr/bin/env bash\necho oops at line 7; exit 3\n' > tests/math/good.sh
build test-math
expect "bad tests: status" "$status" 2
contains "bad tests: count" "$log" "2 passed, 2 failed"
contains "bad tests: log" "$log" "log: build/SimRelease/logs/math.log"
contains "bad tests: what" "$log" "One.isTwo"
contains "bad script: what" "$log" "oops at line 7"
# All tests: what failed beside others runs once more alone, and the second run counts; it is said, and can be turned off.
cat > tests/math/unsteady.sh << 'SH'
#!/usr/bin/env bash
[[ -e ran ]] || { touch ran; echo too busy; exit 3; }
SH
rm tests/math/OneTest.cpp
printf '#!/usr/bin/env bash\ntrue\n' > tests/math/good.sh
rm build/SimRelease/tests/math
all() { scripts/run_tests.sh --all 2>&1; }
sed -i 's/^longAreas=.*/longAreas=()/; s/^  check .*//' scripts/run_tests.sh
log=$(SECOND_RUN=no all)
expect "no second run: status" $? 1
contains "no second run: what" "$log" "too busy"
expect "no second run: last line" "$(tail -1 <<< "$log")" "2 passed, 1 failed"
rm ran
log=$(all)
expect "second run: status" $? 0
contains "second run: said at once" "$log" "again SimRelease math/unsteady.sh: failed, runs once more alone at the end"
contains "second run: said at the end" "$log" "passed  SimRelease math/unsteady.sh: build/SimRelease/logs/math-unsteady.sh.log.first"
expect "second run: last line" "$(tail -1 <<< "$log")" "3 passed, 0 failed; 1 of the programs and scripts passed only in a second run"
expect "second run: the first log" "$(cat build/SimRelease/logs/math-unsteady.sh.log.first)" "too busy"
printf '#!/usr/bin/env bash\necho wrong; exit 3\n' > tests/math/unsteady.sh
log=$(all)
expect "a failure stays one: status" $? 1
contains "a failure stays one: said at the end" "$log" "failed  SimRelease math/unsteady.sh: build/SimRelease/logs/math-unsteady.sh.log.first"
expect "a failure stays one: last line" "$(tail -1 <<< "$log")" "2 passed, 1 failed"
rm tests/math/unsteady.sh ran
# Some scripts are played by sanitized programs as well.
sed -i 's/^sanitizedScripts=.*/sanitizedScripts=(math\/good.sh)/; s/^sanitizedPrograms=.*/sanitizedPrograms=(tool)/' scripts/run_tests.sh
printf '#!/usr/bin/env bash\necho "$PLUMBLINE_BIN"; exec "$PLUMBLINE_BIN/tool"\n' > tests/math/good.sh
log=$(all)
expect "sanitized programs: last line" "$(tail -1 <<< "$log")" "3 passed, 0 failed"
expect "sanitized programs: which" "$(head -1 build/SimSanitize/logs/math-good.sh.log)" "$project/build/SimSanitize/bin"
expect "the release's programs, too" "$(head -1 build/SimRelease/logs/math-good.sh.log)" "$project/bin"
cp "$repository"/scripts/run_tests.sh scripts/
# A test program that dies counts as failed.
printf '#include <gtest/gtest.h>\n#include <cstdlib>\nTEST(One, dies) { std::abort(); }\n' > tests/math/OneTest.cpp
rm tests/math/good.sh
build test-math
expect "dying test: status" "$status" 2
contains "dying test: count" "$log" "0 passed, 1 failed"
# One that computes for ever is stopped by its CPU time, however busy the machine is; one that waits, in the end.
printf '#include <gtest/gtest.h>\n#include <unistd.h>\nTEST(One, hangs) { volatile bool on = true; while (on) {} }\n' > tests/math/OneTest.cpp
TEST_CPU_SECONDS=1 build test-math
contains "test that computes for ever" "$log" "stopped after 1 s of computing"
printf '#include <gtest/gtest.h>\n#include <unistd.h>\nTEST(One, waits) { sleep(60); }\n' > tests/math/OneTest.cpp
TEST_TIMEOUT=1 build test-math
contains "test that waits" "$log" "stopped after 1 s"

build test-moon
contains "unknown area" "$log" "run_tests.sh: no tests/moon; there is: math"
# A skipped test is not a passed one.
printf '#include <gtest/gtest.h>\nTEST(One, skips) { GTEST_SKIP(); }\nTEST(One, passes) {}\n' > tests/math/OneTest.cpp
rm tests/math/TwoTest.cpp
build test-math
contains "skipped test" "$log" "1 passed, 1 skipped"
expect "skipped test: last line" "$(tail -1 <<< "$log")" "1 passed, 0 failed"

# Packages: nothing missing is silent and quick; who may not install reads so in one line.
expect "nothing missing" "$(scripts/install_packages.sh 2>&1)" ""
expect "PACKAGES=no" "$(PACKAGES=no scripts/install_packages.sh no-such-list.txt 2>&1)" ""
mkdir elsewhere doc
cp "$repository/doc/dependencies.md" doc/
for tool in bash dirname sed tr cat env; do ln -s "$(command -v $tool)" elsewhere/$tool; done
text=$(env -i "PATH=$project/elsewhere" bash scripts/install_packages.sh 2>&1)
expect "no dpkg: status" $? 2
contains "no dpkg: what to do" "$text" "this is no Debian. Install these by hand, then make again with PACKAGES=no:"
contains "no dpkg: names" "$text" "libeigen3-dev"
contains "no dpkg: other names" "$text" "eigen3-devel"
rm -r elsewhere doc

# Help does nothing but print; a wrong word is named.
for script in scripts/*.sh; do
  [[ $script == scripts/run.sh ]] && continue # hands it on to bin/game
  text=$(within 100 bash "$script" --help 2>&1)
  expect "$script --help: status" $? 0
  contains "$script --help" "$text" "Example"
done
for script in build_page.sh format.sh; do
  text=$(bash scripts/$script --foo 2>&1)
  expect "$script --foo: status" $? 2
  expect "$script --foo" "$text" "$script: no option --foo; see $script --help"
done
text=$(bash scripts/check_sizes.sh --foo 2>&1)
expect "check_sizes.sh --foo" "$text" "check_sizes.sh: unexpected argument '--foo'; see check_sizes.sh --help"
text=$(bash scripts/check_sentences.sh --foo 2>&1)
expect "check_sentences.sh --foo" "$text" "check_sentences.sh: unexpected argument '--foo'; see check_sentences.sh --help"
text=$(bash scripts/optimise_walks.sh 7 2>&1)
expect "optimise_walks.sh 7" "$text" "optimise_walks.sh: no robot type '7'; see optimise_walks.sh --help"
echo "no-such-package-of-any-kind  # made up" > list.txt
mkdir tools
for tool in bash dirname sed tr cat dpkg-query env; do ln -s "$(command -v $tool)" tools/$tool; done
chmod -R a+rX "$project"
as=()
if ((EUID == 0)); then
  as=(setpriv --reuid=65534 --regid=65534 --clear-groups --)
  "${as[@]}" true 2> /dev/null || { echo "root cannot become nobody here: the rest is left out"; finish; exit 0; }
fi
as+=(env -i "PATH=$project/tools" bash scripts/install_packages.sh)
text=$("${as[@]}" list.txt 2>&1)
expect "no right to install: status" $? 2
expect "no right to install" "$text" "install_packages.sh: missing no-such-package-of-any-kind: neither root nor sudo; run as root: apt-get install no-such-package-of-any-kind"
text=$("${as[@]}" gone.txt 2>&1)
expect "no list: status" $? 2
expect "no list" "$text" "install_packages.sh: no file gone.txt"
finish
