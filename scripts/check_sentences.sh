#!/usr/bin/env bash
# Lists sentences of more than 35 words. It looks at README, CHANGELOG and doc/ (of doc/results only the diaries, as programs write the
# others) and at comments of src/, utils/, tests/, scripts and config/. Each: file:line of its first word: number of words. Code blocks,
# tables, headings and targets of links do not count; text in backticks is one word; an entry of a list ends a sentence.
# Example: scripts/check_sentences.sh
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
noArguments "$@"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
places=()
for place in README.md CHANGELOG.md doc src utils tests scripts cmake config bin doc/results/*-diary.md; do
  [[ -e $place ]] && places+=("$place")
done
find "${places[@]}" \( -path doc/results -o -path tests/data \) -prune -o -type f \( -name '*.md' -o -name '*.h' -o -name '*.cpp' -o -name '*.c' \
  -o -name '*.sh' -o -name '*.bash' -o -name '*.awk' -o -name '*.yaml' -o -name '*.cfg' \) -print0 | LC_ALL=C sort -z | LC_ALL=C xargs -0 -r awk '
  # A sentence goes on from line to line until its full stop or until end().
  function end() {
    if (words > 35) { print file ":" first ": " words " words in a sentence, more than 35: split it"; bad = 1 }
    words = inCode = 0
  }
  function add(text,   n, i, t, counts) {
    gsub(/\]\([^)]*\)/, "]", text)
    n = split(text, t, /[ \t]+/)
    for (i = 1; i <= n; ++i) {
      counts = t[i] ~ /[A-Za-z0-9]/ && !inCode
      if (gsub(/`/, "`", t[i]) % 2) inCode = !inCode
      if (counts && ++words == 1) { file = FILENAME; first = FNR }
      if (!inCode && t[i] ~ /[^.][.!?][)"\047*_\]]*$/ && t[i] !~ /^[(]?(e\.g|i\.e|cf|vs)\.$/) end()
    }
  }
  FNR == 1 { end(); fenced = inComment = inList = 0; blank = 1; column = -1
    isPage = FILENAME ~ /\.md$/; isScript = FILENAME ~ /\.(sh|bash|awk|yaml|cfg)$/ }

  isPage && /^ *```/ { end(); fenced = !fenced; next }
  isPage && (fenced || /^ *[|#<]/ || /^ *$/) { end(); blank = 1; if (/^[|#<]/) inList = 0; next }
  isPage && /^    / && blank && !inList { next }
  isPage {
    if (/^[^ ]/ && blank) inList = 0
    if (sub(/^ *([-*]|[0-9]+\.) +/, "")) { end(); inList = 1 } else if (sub(/^ *> */, "")) end()
    blank = 0
    add($0); next
  }

  function comment(text) {
    if (text ~ /^ *$/ || text ~ /^   / || sub(/^ *[-*] +/, "", text)) end()
    add(text)
  }
  # As below; what stands in quotes is hardly so long.
  isScript {
    at = match($0, /(^|[ \t])#+( |$)/)
    if (!at) { end(); column = -1; next }
    text = substr($0, at + RLENGTH - 1)
    if (substr($0, at, 1) != "#") ++at
    if (at != column || substr($0, 1, at - 1) ~ /[^ \t]/) end()
    column = at
    comment(text); next
  }

  # Source: comments alone. One beside code is of its own, and goes on below it in the same column.
  {
    line = $0
    gsub(/\047"\047/, "\047q\047", line); gsub(/\047\\"\047/, "\047qq\047", line)
    while (match(line, /"([^"\\]|\\.)*"/)) {
      text = substr(line, RSTART, RLENGTH); gsub(/./, "q", text)
      line = substr(line, 1, RSTART - 1) text substr(line, RSTART + RLENGTH)
    }
    if (inComment) { at = 1 } else {
      at = match(line, /\/[\/*]/)
      if (!at) { end(); column = -1; next }
      if (at != column || substr(line, 1, at - 1) ~ /[^ \t]/ || substr(line, at, 2) == "/*") end()
      column = at
      if (substr(line, at, 2) == "/*") inComment = 1
    }
    text = substr($0, at)
    if (inComment && (closes = index(text, "*/"))) { text = substr(text, 1, closes - 1); inComment = 0 }
    sub(/^[ \t]*(\/\/+[<!]?|\/\*+|\*)/, "", text)
    comment(text)
  }
  END { end(); exit bad }' || exit 1
