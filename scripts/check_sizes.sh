#!/usr/bin/env bash
# Lists source files over 400 lines; one over 600 is a mistake and fails.
# Example: scripts/check_sizes.sh
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
noArguments "$@"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
folders=()
for folder in src tests scripts utils cmake; do [[ -d $folder ]] && folders+=("$folder"); done
find "${folders[@]}" configure.sh Makefile -type f \( -name '*.h' -o -name '*.cpp' -o -name '*.c' -o -name '*.y' -o -name '*.l' \
  -o -name '*.sh' -o -name '*.py' -o -name '*.mk' -o -name Makefile -o -name CMakeLists.txt -o -name "*.cmake" \) -exec wc -l {} + | LC_ALL=C sort -k2 | awk '
  $2 == "total" { next }
  $1 > 600 { print $2 ": " $1 " lines, more than 600: split it"; bad = 1; next }
  $1 > 400 { print $2 ": " $1 " lines: does it hold one idea?" }
  END { exit bad }'
