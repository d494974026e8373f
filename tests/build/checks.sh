#!/usr/bin/env bash
# What sources and pages are checked for: floors, USES, circles, sizes, sentences.
source "$(dirname "$0")/project.bash"
writeSources

# Floors.
mkdir -p src/{walking,framework,representations,robot}
scripts/check_floors.sh || fail "clean tree refused"
printf '#include <vector>\n#include "math/One.h"\n#include "framework/Module.h"\n' > src/walking/Step.cpp
printf '#pragma once\n#include "math/Two.h"\n  #  include "robot/Joint.h"\n' > src/math/Up.h
printf '#include "../math/One.h"\n' > src/robot/Joint.cpp
text=$(scripts/check_floors.sh 2> floors.err)
expect "floors: status" $? 1
expect "floors: offenders" "$text" 'src/math/Up.h:3: src/math must not look up to "robot/Joint.h"
src/robot/Joint.cpp:1: relative include "../math/One.h": write the path from src/
src/walking/Step.cpp:3: src/walking may include parameters, math, robot and optimization only, not "framework/Module.h"'
expect "floors: count" "$(cat floors.err)" "check_floors: 3 include(s) point up"
rm -r src/walking src/math/Up.h src/robot

# Platforms: their own modules alone see them and their wires.
mkdir -p src/modules/{motion,simspark,nao} src/simspark
printf 'MAKE_PLATFORM("simspark", SimSpark)\n' > src/modules/simspark/SimSpark.cpp
printf '#include "simspark/Wire.h"\n#include "modules/simspark/Link.h"\n#include "modules/motion/Walk.h"\n' > src/modules/simspark/Send.cpp
scripts/check_floors.sh || fail "a platform of its own modules refused"
printf '#include "math/One.h"\n#include "simspark/Wire.h"\n' > src/modules/motion/Walk.cpp
printf '#include "modules/simspark/Link.h"\n' > src/modules/nao/Nao.cpp
text=$(scripts/check_floors.sh)
expect "platforms: status" $? 1
expect "platforms" "$text" 'src/modules/motion/Walk.cpp:2: only modules of the platform simspark include "simspark/Wire.h"
src/modules/nao/Nao.cpp:1: only modules of the platform simspark include "modules/simspark/Link.h"'
rm -r src/modules/{simspark,motion,nao} src/simspark

# USES is what a folder includes from: directly, or by way of what it uses.
mkdir -p src/{robot,record}
printf 'plumbline_library(robot\n  USES math # numbers\n  EXTERNALS yaml)\n' > src/robot/CMakeLists.txt
printf 'plumbline_library(record REGISTERS USES robot EXTERNALS fmt)\n' > src/record/CMakeLists.txt
printf '#include "math/One.h"\n' > src/robot/Joint.h
printf '#include "robot/Joint.h"\n#include "math/Two.h"\n' > src/record/Log.cpp
text=$(scripts/check_floors.sh) || fail "USES that fit refused: $text"
# The page's table has the same.
mkdir -p doc
printf '| `src/math/` | numbers | - |\n| `src/modules/` | modules | math |\n| `src/robot/` | a robot | math (poses) |\n| `src/record/` | logs | robot |\n' > doc/architecture.md
text=$(scripts/check_floors.sh) || fail "a table that fits refused: $text"
printf '| `src/math/` | numbers | - |\n| `src/modules/` | modules | math |\n| `src/record/` | logs | robot, math |\n' > doc/architecture.md
text=$(scripts/check_floors.sh)
expect "table: status" $? 1
expect "table" "$text" 'doc/architecture.md:3: src/record uses robot, not math, robot
doc/architecture.md: the table of folders lacks src/robot/'
rm -r doc
printf 'plumbline_library(robot EXTERNALS yaml)\n' > src/robot/CMakeLists.txt
printf 'plumbline_library(record\n  USES robot\n    modules)\n' > src/record/CMakeLists.txt
text=$(scripts/check_floors.sh)
expect "USES: status" $? 1
expect "USES" "$text" 'src/record/CMakeLists.txt:3: src/record includes nothing from src/modules: take modules out of USES
src/robot/Joint.h:1: src/robot does not use "math/One.h": add math to USES in src/robot/CMakeLists.txt'
rm -r src/robot src/record

# The drawing of the floors: a box for each folder, and an arrow for each include that no other way replaces.
mkdir -p src/robot
printf '#include "math/One.h"\n' > src/robot/Joint.h
scripts/draw_floors.sh > floors.svg || fail "the floors are not drawn"
contains "a box" "$(cat floors.svg)" "<title>robot</title>"
contains "an arrow" "$(cat floors.svg)" "<title>robot&#45;&gt;math</title>"
text=$(scripts/draw_floors.sh nowhere 2>&1)
expect "no tree: status" $? 2
expect "no tree" "$text" "draw_floors.sh: nowhere has no folder src"
rm -r src/robot floors.svg

# Circles of folders.
mkdir -p src/math/a src/math/b
printf '#include "math/b/B.h"\n' > src/math/a/A.h
printf '#include "math/One.h"\n' > src/math/b/B.h
scripts/check_floors.sh || fail "no circle refused"
printf '#include "math/a/A.h"\n' > src/math/One.cpp
printf '#include "math/a/A.h"\n' > src/math/b/B.h
text=$(scripts/check_floors.sh)
expect "circle: status" $? 1
expect "circle" "$text" 'src/math/a/A.h:1: src/math/a and src/math/b are in a circle of folders
src/math/b/B.h:1: src/math/b and src/math/a are in a circle of folders'
rm -r src/math/a src/math/b
writeSources

# Names of headers.
mkdir -p src/math/other
printf '#pragma once\n' > src/math/other/One.h
text=$(scripts/check_floors.sh)
expect "names: status" $? 1
expect "names" "$text" 'src/math/other/One.h:1: src/math/One.h has this name too'
rm -r src/math/other

# Sizes.
scripts/check_sizes.sh > /dev/null || fail "short files refused"
yes '//' | head -450 > src/math/Long.h
expect "450 lines" "$(scripts/check_sizes.sh)" "src/math/Long.h: 450 lines: does it hold one idea?"
yes '//' | head -601 > src/math/Long.h
text=$(scripts/check_sizes.sh)
expect "601 lines: status" $? 1
expect "601 lines" "$text" "src/math/Long.h: 601 lines, more than 600: split it"
rm src/math/Long.h
mkdir -p doc/decisions
{ seq -s ' ' 700; printf '\n    a formula, %s\n' "$(seq -s ' ' 50)"; } > doc/decisions/0001-short.md
scripts/check_sizes.sh > /dev/null || fail "a decision record of 700 words refused"
seq -s ' ' 701 > doc/decisions/0001-short.md
text=$(scripts/check_sizes.sh)
expect "a long decision record: status" $? 1
expect "a long decision record" "$text" "doc/decisions/0001-short.md: 701 words, more than 700: move figures and what was tried to doc/results/"
rm -r doc

# Sentences.
words() { seq -s ' ' "$1" | tr -d '\n'; }
mkdir -p doc/results
scripts/check_sentences.sh || fail "a tree without pages refused"
{
  printf '# %s\n\n' "$(words 40)"
  printf '%s.\n' "$(words 35)"
  printf '%s\n%s. Short (%s). `%s` [a](%s).\n\n' "$(words 20)" "$(words 15)" "$(words 20)" "$(words 50)" "$(words 40)"
  printf -- '- %s\n- %s:\n\n| %s |\n\n' "$(words 20)" "$(words 20)" "$(words 40)"
  printf '    %s\n\n```\n%s\n```\n' "$(words 40)" "$(words 40)"
} > doc/good.md
printf '%s.\n' "$(words 40)" > doc/results/measured.md
{
  printf '/// %s\n/// %s.\nint one();  ///< %s\nint two();  ///< %s\n' "$(words 20)" "$(words 15)" "$(words 20)" "$(words 20)"
  printf 'const char* const url = "http://%s";\n/* %s. */\n\n// %s\n\n// %s\n' "$(words 40)" "$(words 30)" "$(words 20)" "$(words 20)"
} > src/math/Good.h
scripts/check_sentences.sh || fail "short sentences refused"
printf 'One. %s\n%s, e.g. this.\n\n- Short.\n- In a list:\n  %s.\n' "$(words 20)" "$(words 20)" "$(words 36)" > doc/long.md
printf '// One. Two\n// %s.\nint one();  ///< %s\n            ///< %s\n/* %s\n * %s */\n' \
  "$(words 35)" "$(words 20)" "$(words 20)" "$(words 20)" "$(words 17)" > src/math/Long.h
printf '#!/bin/sh\n# %s\n# %s.\necho x # %s\n' "$(words 20)" "$(words 20)" "$(words 30)" > scripts/long.sh
printf 'a: 1  # %s\n      # %s\n' "$(words 20)" "$(words 20)" > config/long.yaml
printf '%s.\n' "$(words 36)" > doc/results/a-diary.md
text=$(scripts/check_sentences.sh)
expect "sentences: status" $? 1
expect "sentences" "$text" 'config/long.yaml:1: 40 words in a sentence, more than 35: split it
doc/long.md:1: 42 words in a sentence, more than 35: split it
doc/long.md:5: 39 words in a sentence, more than 35: split it
doc/results/a-diary.md:1: 36 words in a sentence, more than 35: split it
scripts/long.sh:2: 40 words in a sentence, more than 35: split it
src/math/Long.h:1: 36 words in a sentence, more than 35: split it
src/math/Long.h:3: 40 words in a sentence, more than 35: split it
src/math/Long.h:5: 37 words in a sentence, more than 35: split it'
rm -r doc src/math/Good.h src/math/Long.h scripts/long.sh config/long.yaml
finish
