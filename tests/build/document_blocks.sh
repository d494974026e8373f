#!/usr/bin/env bash
# Every block of C++ in README and doc/ compiles, with the flags of the tree and only what it includes. Those that extend.sh builds
# are left to it. A block for a file of tests/ sees what its page puts into src/. A part of a function or a class says in a comment
# before it what stands around it; a line of three dots is the block's place:
#   <!-- compiled in:
#   #include "framework/DebugSite.h"
#   void example(double variable) {
#   ...
#   }
#   -->
# Lines of the block that include something go before all that. In a block `{ ... }` is a body that the page leaves out.
source "$(dirname "$0")/../e2e/assert.bash"
source tests/build/blocks.bash
root=$PWD
commands=build/${PLUMBLINE_TARGET:-SimRelease}/cmake/compile_commands.json
[[ -f $commands ]] || fail "no $commands: make builds it"

# How a test is compiled, without headers compiled before: these would hide an include that is missing.
flags=$(grep -m1 "\"command\".* -I$root/tests .* -c " "$commands") || fail "no source of tests/ in $commands"
flags=$(sed -E 's/^ *"command": "//; s/ -o .*//; s/-include [^ ]*cmake_pch\.hxx|-Winvalid-pch|-fpch-preprocess|--param=ggc[^ ]*//g
  s/[^ ]*\/compile_bundle\.sh //; s/[^ ]*\/ccache //' <<< "$flags")
read -ra compiler <<< "$flags"

# Each block as a file whose lines are those of its page to the compiler; the list has page:line, the file, and what it is for.
takeUnits() { # page, folder, pages of extend.sh
  awk -v to="$2" -v extended=" $3 " '
    function wrong(line, text) { print FILENAME ":" line ": " text > "/dev/stderr"; bad = 1; exit 1 }
    function place(line) { return "#line " line " \"" FILENAME "\"\n" }
    !inside && !comment { line = $0; while (match(line, /`(src|tests)\/[A-Za-z0-9_\/]+\.(h|cpp)`/)) {
        file = substr(line, RSTART + 1, RLENGTH - 2); line = substr(line, RSTART + RLENGTH) } }
    /^<!-- compiled in:$/ { comment = FNR; around = place(FNR + 1); next }
    comment && /^-->$/ { comment = 0; framed = FNR; next }
    comment { around = around $0 "\n"; next }
    !inside && /^ *```(c|cc|cxx|h|hpp|c\+\+|C\+\+|CPP|Cpp)$/ { wrong(FNR, "a block of C++ begins with ```cpp") }
    !inside && /^ +```cpp$/ { wrong(FNR, "a block of C++ begins in the first column") }
    !inside && /^```cpp$/ { inside = 1; begin = FNR; text = place(FNR + 1); includes = ""; next }
    !inside && /^```/ { inside = 2; next }
    inside == 2 { if (/^```$/) inside = 0; next }
    inside && /^```$/ {
      inside = 0
      mine = file; file = ""
      if (mine ~ /^src\// && index(extended, " " FILENAME " ")) next
      if (around != "") {
        if (!sub(/\n *\.\.\.\n/, "\n\001", around)) wrong(framed, "no line of three dots for the block of line " begin)
        split(around, part, "\001")
        text = includes part[1] text place(framed) part[2]
      }
      around = ""
      name = to "/" FILENAME "-" begin ".cpp"; folder = name; sub(/\/[^\/]*$/, "", folder)
      if (system("mkdir -p \"" folder "\"")) exit 1
      printf "%s", text > name; close(name)
      print FILENAME ":" begin " " name " " mine
      next }
    inside && around != "" && /^#include / { includes = includes place(FNR) $0 "\n"; text = text "\n"; next }
    inside { gsub(/\{ \.\.\. \}/, "{}"); text = text $0 "\n"; next }
    NF && around != "" { wrong(framed, "what is compiled around a block has none below it") }
    END { if (!bad && (comment || around != "")) wrong(comment ? comment : framed, "what is compiled around a block has none below it") }' "$1"
}

# Compiles the blocks of the pages of a folder; what is wrong is printed. Leaves count and failed.
compileBlocks() { # folder
  local page pages ours where unit file
  cd "$1"
  mapfile -t pages < <(find README.md doc -name '*.md' | LC_ALL=C sort)
  count=0 failed=0
  for page in "${pages[@]}"; do
    takeUnits "$page" "$scratch/units" "${extendedPages[*]}" > "$scratch/list" || { failed=$((failed + 1)); continue; }
    [[ -s $scratch/list ]] || continue
    ours=$scratch/src/${page//\//-}
    mkdir -p "$ours"
    [[ " ${extendedPages[*]} " != *" $page "* ]] || takeBlocks "$page" "$ours"
    while read -r where unit file; do
      count=$((count + 1))
      # What a part of the code names and does not use is no fault of a page.
      (cd "$root" && within 120 "${compiler[@]}" "-I$ours" ${file:+"-I${file%/*}"} -Wno-unused -Wno-unused-parameter -fsyntax-only "$unit") \
        > "$scratch/log" 2>&1 && continue
      failed=$((failed + 1))
      echo "$where: this block does not compile:"
      # Lines of the page come first, also those that a macro's error names.
      { grep -F "$page:" "$scratch/log" || true; cat "$scratch/log"; } | grep -E '(error|warning|note): |required from' |
        awk '!seen[$0]++ && ++n <= 3' || tail -3 "$scratch/log"
    done < "$scratch/list"
  done
  cd "$root"
}

# What is wrong is said with its page and line.
mkdir -p "$scratch/pages/doc"
printf 'Text.\n\n```cpp\nint one = 1;\nint two = 2\n```\n' > "$scratch/pages/README.md"
printf '`src/math/One.cpp`:\n\n```cpp\nint one = "";\n```\n' > "$scratch/pages/doc/a.md"
printf '<!-- compiled in:\nint f(int a) {\n...\n}\n-->\n```cpp\n#include <string>\n\nreturn std::stoi("1") + b;\n```\n' > "$scratch/pages/doc/b.md"
printf '<!-- compiled in:\nint f(int a) {\n}\n-->\n```cpp\nreturn a;\n```\n' > "$scratch/pages/doc/c.md"
printf '<!-- compiled in:\n...\n-->\n```sh\n```\n' > "$scratch/pages/doc/d.md"
printf '\n```c++\nint one;\n```\n' > "$scratch/pages/doc/e.md"
printf -- '- item\n  ```cpp\n  int one;\n  ```\n' > "$scratch/pages/doc/f.md"
printf '```text\n  ```cpp\n```\n\n<!-- compiled in:\nint f(int a) {\n...\n}\n-->\n```cpp\nif (a) { ... }\nreturn a;\n```\n' > "$scratch/pages/doc/g.md"
compileBlocks "$scratch/pages" > "$scratch/wrong" 2>&1
expectEqual "$(grep -vE ': note: |In function' "$scratch/wrong" | sed 's/ error: .*/ error/')" "README.md:3: this block does not compile:
README.md:5:12: error
doc/a.md:3: this block does not compile:
doc/a.md:4:11: error
doc/b.md:6: this block does not compile:
doc/b.md:9:25: error
doc/c.md:4: no line of three dots for the block of line 5
doc/d.md:3: what is compiled around a block has none below it
doc/e.md:2: a block of C++ begins with \`\`\`cpp
doc/f.md:2: a block of C++ begins in the first column" "blocks that are wrong"
expectEqual "$count $failed" "4 7" "blocks and those that are wrong"

compileBlocks . >&2
((failed == 0)) || fail "$failed of $count blocks in the documents; see above"
((count)) || fail "no block was found"
echo "$count blocks compile"
