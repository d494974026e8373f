#!/usr/bin/env bash
# Generated sources: flex and bison, and a rule of one's own.
source "$(dirname "$0")/project.bash"
mkdir -p src/words
cat > src/words/Sum.y << 'E'
%define api.prefix {sum}
%code requires { int sumOf(const char* text); }
%code { int sumlex(); void sumerror(const char*); int total = 0; void sumStart(const char*); }
%define api.value.type {int}
%token NUMBER
%%
list: %empty | list NUMBER { total += $2; };
%%
void sumerror(const char*) {}
int sumOf(const char* text) { sumStart(text); total = 0; return sumparse() == 0 ? total : -1; }
E
cat > src/words/Sum.l << 'E'
%option noyywrap prefix="sum" nounput noinput
%{
#include "words/Sum.tab.h"
#include <cstdlib>
#define YYSTYPE SUMSTYPE
%}
%%
[0-9]+ { sumlval = std::atoi(sumtext); return NUMBER; }
[ \n]+ { }
%%
void sumStart(const char* text) { sum_scan_string(text); }
E
printf '#include <cstdio>\n#include "words/Sum.tab.h"\nint main() { std::printf("%%d\\n", sumOf("1 2 39")); }\n' > src/main/tool.cpp

builds -j2 SimRelease
contains "bison runs" "$log" "  BISON src/words/Sum.y"
contains "flex runs" "$log" "  FLEX  src/words/Sum.l"
exists build/generated/src/words/Sum.tab.h
exists build/generated/src/words/Sum.lex.cpp
expect "the parser works" "$(bin/tool)" 42
builds SimRelease
expect "nothing changed" "$log" "make: Nothing to be done for 'SimRelease'."

sed -i 's/total = 0; return/total = 100; return/' src/words/Sum.y
builds SimRelease
contains "changed grammar" "$log" "  BISON src/words/Sum.y"
lacks "changed grammar leaves the scanner's input alone" "$log" FLEX
expect "changed grammar takes effect" "$(bin/tool)" 142

# A second target uses the same generated sources.
builds SimDebug
lacks "generated once" "$log" BISON
expect "second target" "$(build/SimDebug/bin/tool)" 142

# A rule of one's own, listed by settings.
cat > own.mk << 'E'
build/generated/src/words/Answer.h: answer.txt
	@mkdir -p $(@D); echo "inline int answer() { return $$(cat $<); }" > $@
build/generated/src/words/Extra.cpp: answer.txt
	@mkdir -p $(@D); echo "int extra() { return $$(cat $<) + 1; }" > $@
E
echo 7 > answer.txt
printf '#include <cstdio>\n#include "words/Answer.h"\nint extra();\nint main() { std::printf("%%d %%d\\n", answer(), extra()); }\n' > src/main/tool.cpp
./configure.sh --target SimRelease --included-makefiles+ own.mk \
  --generated-files "build/generated/src/words/Answer.h build/generated/src/words/Extra.cpp" > /dev/null
builds SimRelease
expect "own rule" "$(bin/tool)" "7 8"
echo 8 > answer.txt
builds SimRelease
expect "own rule again" "$(bin/tool)" "8 9"

# Removed: its objects go, the tree still builds.
rm src/words/Sum.*
builds SimRelease
missing build/SimRelease/obj/generated/src/words/Sum.tab.cpp.o
finish
