#!/usr/bin/env bash
# Manual pages: a program whose help is longer than a pipe holds gets one, and what the help begins with is its title.
source "$(dirname "$0")/../e2e/assert.bash"
tree=$scratch/tree
mkdir -p "$tree"/{bin,scripts}
cp scripts/make_man.sh scripts/help.bash "$tree/scripts/"
cp CMakeLists.txt "$tree/"
printf '#!/bin/sh\necho "Counts far."\nseq 100000\n' > "$tree/bin/count"
# What help2man is asked, in its place: tests go without that package.
cat > "$scratch/help2man" << 'END'
#!/bin/bash
while (($# > 1)); do case $1 in --name) about=$2 ;; --output) page=$2 ;; esac; shift; done
printf '.TH COUNT "1"\ncount \\- %s\n' "$about" > "$page"
END
chmod +x "$tree/bin/count" "$scratch/help2man"
PATH=$scratch:$PATH "$tree/scripts/make_man.sh" > "$scratch/log" 2>&1 || fail "make_man.sh ended with status $?: $(cat "$scratch/log")"
expectEqual "$(cat "$tree/build/SimRelease/man/plumbline-count.1")" '.TH PLUMBLINE-COUNT "1"
plumbline-count \- Counts far' "the page"
