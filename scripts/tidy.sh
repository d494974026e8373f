#!/usr/bin/env bash
# Runs clang-tidy with .clang-tidy over the sources in src/, or over the files given. A source that was clean is
# looked at again only when it, a header it includes, or .clang-tidy changed (build/tidy/ remembers).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
command -v clang-tidy > /dev/null || scripts/install_packages.sh scripts/packages-developer.txt
make SimRelease-tests # the dependency files and the generated sources

# True when the record of a source is newer than everything it was made from.
isClean() {
  local record=build/tidy/$1.clean d=build/SimRelease/obj/$1.d file
  [[ -f $record && -f $d && $record -nt .clang-tidy ]] || return 1
  for file in $(sed -n '1,/[^\\]$/{s/^[^:]*://;s/\\$//;p}' "$d"); do
    [[ $file -nt $record ]] && return 1
  done
  return 0
}

tidyOne() {
  local out status=0
  out=$(clang-tidy --quiet -p . --extra-arg=-Wno-unknown-warning-option "$1" 2> /dev/null) || status=$?
  if ((status == 0)) && [[ ! $out ]]; then
    mkdir -p "build/tidy/${1%/*}"
    touch "build/tidy/$1.clean"
  else
    printf '%s\n' "$out"
    return 1
  fi
}
export -f tidyOne

files=("$@")
((${#files[@]})) || mapfile -t files < <(find src -name '*.cpp' | LC_ALL=C sort)
todo=()
for file in "${files[@]}"; do isClean "$file" || todo+=("$file"); done
echo "clang-tidy: ${#todo[@]} of ${#files[@]} files to look at"
((${#todo[@]})) || exit 0
printf '%s\0' "${todo[@]}" | xargs -0 -n 1 -P "${JOBS:-$(nproc)}" bash -c 'tidyOne "$1"' tidy
