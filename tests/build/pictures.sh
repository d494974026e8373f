#!/usr/bin/env bash
# Pictures of the documentation: each is shown or linked by a page and made by scripts/make_pictures.sh, and the diagnosis that is
# drawn is the one whose commands the pages name.
source "$(dirname "$0")/project.bash"
cd "$repository" || exit 1

diagnosis() { sed -n '/^bin\/gap record --battery/,/^bin\/gap report/p' "$1" | head -3; }
contains "README records a secret" "$(diagnosis README.md)" "bin/gap record --battery hang --secret "
expect "the tutorial diagnoses what README does" "$(diagnosis doc/tutorials/diagnose.md)" "$(diagnosis README.md)"
lacks "make_pictures.sh takes the commands from README" "$(cat scripts/make_pictures.sh)" "--secret"

mapfile -t pages < <(find README.md doc -name '*.md')
linked=$(grep -ohE '\]\([^)]*img/[^)]*\)' "${pages[@]}" | sed 's#.*img/##; s/).*//' | LC_ALL=C sort -u)
expect "pictures that pages link, and those that there are" "$linked" "$(cd doc/img && find . -type f | sed 's#^\./##' | LC_ALL=C sort)"
linked=$(grep -v '^situations/' <<< "$linked") # tests/e2e/reference.sh compares those
# Two do not change with the programs: a diagram that is drawn by hand, and what was before.
byHand=$'diagnosis.svg\nfloors-before.svg'
expect "pictures that scripts/make_pictures.sh makes, and two that it does not" \
  "$({ sed -n 's/^ *put "[^"]*" \([a-z.-]*\)$/\1/p' scripts/make_pictures.sh; echo "$byHand"; } | LC_ALL=C sort)" "$linked"
finish
