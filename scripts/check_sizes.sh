#!/usr/bin/env bash
# Lists source files over 400 lines; one over 600 is a mistake and fails. So is a decision record of more than 700 words, formulas
# aside: its figures belong to a page of doc/results/, what was tried to a diary there.
# Example: scripts/check_sizes.sh
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
noArguments "$@"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
status=0
folders=()
for folder in src tests scripts utils cmake; do [[ -d $folder ]] && folders+=("$folder"); done
find "${folders[@]}" configure.sh Makefile -type f \( -name '*.h' -o -name '*.cpp' -o -name '*.c' \
  -o -name '*.sh' -o -name '*.py' -o -name '*.mk' -o -name Makefile -o -name CMakeLists.txt -o -name "*.cmake" \) -exec wc -l {} + | LC_ALL=C sort -k2 | awk '
  $2 == "total" { next }
  $1 > 600 { print $2 ": " $1 " lines, more than 600: split it"; bad = 1; next }
  $1 > 400 { print $2 ": " $1 " lines: does it hold one idea?" }
  END { exit bad }' || status=1
[[ ! -d doc/decisions ]] || LC_ALL=C awk '
  function end() { if (words > 700) { print file ": " words " words, more than 700: move figures and what was tried to doc/results/"; bad = 1 } words = 0 }
  FNR == 1 { end(); file = FILENAME }
  !/^    / { for (i = 1; i <= NF; ++i) words += $i ~ /[A-Za-z0-9]/ }
  END { end(); exit bad }' doc/decisions/*.md || status=1
exit "$status"
