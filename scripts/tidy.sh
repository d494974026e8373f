#!/usr/bin/env bash
# Runs clang-tidy with .clang-tidy over the sources in src/, or over the files given. A source that was clean is
# looked at again only when it, a header it includes, or .clang-tidy changed (build/tidy/ remembers).
# Example: scripts/tidy.sh src/framework/Log.cpp
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
command -v clang-tidy > /dev/null || scripts/install_packages.sh scripts/packages-developer.txt
make SimRelease # configures it, if that is due
scripts/compile_commands.sh SimRelease

# True when the record of a source, which lists what it is made from, is newer than all of that.
isClean() {
  local record=build/tidy/$1.clean file
  [[ -s $record && $record -nt .clang-tidy ]] || return 1
  while read -r file; do
    [[ $file -nt $record || ! -f $file ]] && return 1
  done < "$record"
  return 0
}

# Prints what a source is made from, a line each.
madeFrom() {
  local command
  command=$(grep -F -B1 "\"file\": \"$PWD/$1\"" compile_commands.json | sed -n 's#.*"command": "\(.*\) -c .*#\1#p')
  ${command:-g++ -std=c++20 -Isrc} -MM "$1" | sed 's/^[^:]*://;s/\\$//' | tr -s ' ' '\n' | sed '/^$/d'
}

tidyOne() {
  local out status=0
  out=$(clang-tidy --quiet -p . --extra-arg=-Wno-unknown-warning-option "$1" 2> /dev/null) || status=$?
  if ((status == 0)) && [[ ! $out ]]; then
    mkdir -p "build/tidy/${1%/*}"
    madeFrom "$1" > "build/tidy/$1.clean.new" && mv -f "build/tidy/$1.clean.new" "build/tidy/$1.clean"
  else
    printf '%s\n' "$out"
    return 1
  fi
}
export -f tidyOne madeFrom

files=("$@")
((${#files[@]})) || mapfile -t files < <(find src -name '*.cpp' | LC_ALL=C sort)
todo=()
for file in "${files[@]}"; do isClean "$file" || todo+=("$file"); done
echo "clang-tidy: ${#todo[@]} of ${#files[@]} files to look at"
((${#todo[@]})) || exit 0
printf '%s\0' "${todo[@]}" | xargs -0 -n 1 -P "${JOBS:-$(nproc)}" bash -c 'tidyOne "$1"' tidy
