#!/usr/bin/env bash
# Writes a manual page for each program of bin/ into build/SimRelease/man/, from what it says with --help.
# Example: scripts/make_man.sh
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
version=$(sed -n 's/^project(Plumbline VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
man=build/SimRelease/man
mkdir -p "$man"
for program in bin/*; do
  [[ -x $program && $program != *.sh ]] || continue
  name=plumbline-${program##*/}
  # A page made after its program was built is right.
  [[ $man/$name.1 -nt $program ]] && continue
  about=$("$program" --help) # whole: a program whose reader goes away fails
  about=${about%%$'\n'*} about=${about%.}
  help2man --no-info --name "${about:-part of Plumbline}" --version-string "$version" --source Plumbline \
    --output "$man/$name.1" "$program"
  sed -i "s/^\.TH [^ ]*/.TH ${name^^}/; s/^${program##*/} \\\\- /$name \\\\- /" "$man/$name.1"
done
