#!/usr/bin/env bash
# Formats all C++ sources with .clang-format; --check changes nothing and lists the files that differ.
# Examples:
#   scripts/format.sh
#   scripts/format.sh --check
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
command -v clang-format > /dev/null || scripts/install_packages.sh scripts/packages-developer.txt
folders=()
for folder in src tests utils scripts; do [[ -d $folder ]] && folders+=("$folder"); done
mode=(-i)
case ${1-} in
  --check) mode=(--dry-run -Werror -ferror-limit=1) ;;
  ?*) echo "format.sh: no option $1; see format.sh --help" >&2; exit 2 ;;
esac
find "${folders[@]}" -type f \( -name '*.h' -o -name '*.cpp' -o -name '*.c' \) -print0 |
  xargs -0 -r -n 16 -P "${JOBS:-$(nproc)}" clang-format "${mode[@]}"
