#!/usr/bin/env bash
# Generated sources: flex and bison.
source "$(dirname "$0")/project.bash"
mkdir -p src/words
echo 'plumbline_library(words)' > src/words/CMakeLists.txt
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
contains "bison runs" "$log" "BISON src/words/Sum.y"
contains "flex runs" "$log" "FLEX  src/words/Sum.l"
exists build/SimRelease/cmake/generated/src/words/Sum.tab.h
exists build/SimRelease/cmake/generated/src/words/Sum.lex.cpp
expect "the parser works" "$(bin/tool)" 42
builds SimRelease
expect "nothing changed" "$log" "Nothing to be done for SimRelease."

sed -i 's/total = 0; return/total = 100; return/' src/words/Sum.y
builds SimRelease
contains "changed grammar" "$log" "BISON src/words/Sum.y"
lacks "changed grammar leaves the scanner's input alone" "$log" FLEX
expect "changed grammar takes effect" "$(bin/tool)" 142

# Removed: the tree still builds.
rm -r src/words
printf 'int main() { return 0; }\n' > src/main/tool.cpp
builds SimRelease
finish
