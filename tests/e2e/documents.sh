#!/usr/bin/env bash
# Every command block of README, tutorials and how-to pages is run as it stands, page by page, in a folder of its own that looks
# like the tree. A comment before a block says otherwise:
#   <!-- test: goes on -->       each command stays in the background until the page's end; Ctrl-C then ends it at once
#   <!-- test: goes on 1 3 -->   commands 1 and 3 of the block stay, the others are run
#   <!-- test: goes on 1, terminal 2 -->     and command 2 has a terminal, in which Ctrl-C is pressed after a second
#   <!-- test: goes on instead -->     first Ctrl-C ends the command of the same program that goes on
#   <!-- test: goes on alone -->       first Ctrl-C ends all that goes on, before each command
#   <!-- test: file NAME -->     the block is what NAME holds
#   <!-- test: not run: WHY -->  needs what a test has not
# README and the first tutorial are run in every test run, all pages by make check; DOCUMENTS="PAGE..." runs those pages alone.
pages=(${DOCUMENTS:-README.md doc/tutorials/first-goal.md})
[[ ${PLUMBLINE_SLOW-} && ! ${DOCUMENTS-} ]] && pages=(README.md doc/tutorials/*.md doc/how-to/*.md)
# The pages name the usual ports. In a network of its own nobody else has them, and no test that runs beside is disturbed.
if [[ ! ${DOCUMENTS_NETWORK-} ]] && command -v ip > /dev/null && unshare -rn ip link set lo up 2> /dev/null; then
  DOCUMENTS_NETWORK=own exec unshare -rn bash -c 'ip link set lo up && exec bash "$0"' "$0"
fi
source "$(dirname "$0")/assert.bash"
root=$PWD
scripts/build_page.sh > /dev/null 2>&1 || fail "the pages cannot be built: scripts/build_page.sh"

# Blocks of a page ($1) as files NUMBER.mode, NUMBER.text in a folder ($2).
takeBlocks() {
  awk -v to="$2" '
    function store() { name = sprintf("%s/%03d", to, ++count); print mode > (name ".mode"); printf "%s", text > (name ".text"); close(name ".mode"); close(name ".text") }
    /^<!-- test: .* -->$/ { note = $0; sub(/^<!-- test: /, "", note); sub(/ -->$/, "", note); next }
    !inside && /^```/ { inside = 1; text = ""; mode = note; note = ""; if (mode == "" && $0 == "```sh") mode = "run"; next }
    inside && /^```/ { inside = 0; if (mode != "") store(); next }
    inside { text = text $0 "\n"; next }
    NF { note = "" }' "$1"
}

# A folder in which commands of the documentation find what they name, and nothing that they write is in the tree.
makeFolder() {
  mkdir -p "$1/build" "$root/build/run" # bin/game writes there, beside the programs of the tree
  local name
  for name in bin config doc scripts src tests utils web Makefile CMakeLists.txt CMakePresets.json cmake configure.sh; do
    ln -s "$root/$name" "$1/$name"
  done
  for name in "$root"/build/*; do ln -s "$name" "$1/build/"; done
}

endOf() { # pid, command: Ctrl-C
  kill -0 "$1" 2> /dev/null || { wait "$1" || fail "'$2' ended by itself with status $?"; return 0; }
  endsBy INT "$1" "'$2'"
}

runBlock() { # page, file
  echo "$1: $(head -1 "$2")"
  (cd "$folder" && timeout $((3 * farOff)) bash -e "$2") > "$scratch/log" 2>&1 < /dev/null ||
    fail "$1: status $? of:"$'\n'"$(< "$2")"$'\n'"$(tail -5 "$scratch/log")"
  ran=$((ran + 1))
}
endRunning() { # page, program [all]: those that go on, the last first
  local i
  for ((i = ${#running[@]} - 1; i >= 0; --i)); do
    [[ ! ${2-} || ${commands[i]%% *} == "$2" ]] || continue
    endOf "${running[i]}" "$1: ${commands[i]}"
    unset "running[i]" "commands[i]"
  done
  running=("${running[@]}") commands=("${commands[@]}")
}
goesOn() { # page, which and how, file
  local line number=0 which terminals
  which=$(sed 's/,.*//; s/[a-z]//g; s/ *$//' <<< "$2") terminals=$(sed -n 's/.*, terminal//p' <<< "$2")
  while IFS= read -r line; do
    [[ $line == '#'* ]] && continue
    number=$((number + 1))
    [[ $2 != *alone* ]] || endRunning "$1"
    [[ $2 != *instead* ]] || endRunning "$1" "${line%% *}"
    if [[ "$terminals " == *" $number "* ]]; then
      # exec: the shell of `script`, which may be any, must not be what Ctrl-C ends. TERM: a cron job has none
      printf "(sleep 2; printf '\\\\003'; sleep 3) | TERM=${TERM:-dumb} script -qec 'exec %s' /dev/null\n" "${line%%#*}" > "$scratch/line"
      runBlock "$1" "$scratch/line"
      continue
    fi
    if [[ $which && "$which " != *" $number "* ]]; then
      echo "$line" > "$scratch/line"
      runBlock "$1" "$scratch/line"
      continue
    fi
    echo "$1: $line"
    ran=$((ran + 1))
    set -m
    (cd "$folder" && exec bash -c "exec $line") > "$scratch/log$ran" 2>&1 < /dev/null &
    set +m
    running+=($!) commands+=("$line")
    sleep 2
    [[ ! $which && $2 != *alone* ]] || waitFor [ -s "$scratch/log$ran" ] # the next command may talk to it
  done < "$3"
}

state() { git status --porcelain --untracked-files=normal 2> /dev/null || true; }
before=$(state)
ran=0 left=0
for page in "${pages[@]}"; do
  folder=$scratch/${page//\//-} blocks=$scratch/blocks-${page//\//-}
  mkdir -p "$blocks"
  takeBlocks "$page" "$blocks"
  makeFolder "$folder"
  running=() commands=()
  for mode in "$blocks"/*.mode; do
    [[ -e $mode ]] || continue
    text=${mode%.mode}.text
    case $(< "$mode") in
      run) runBlock "$page" "$text" ;;
      'goes on'*) mode=$(< "$mode"); goesOn "$page" "${mode#goes on}" "$text" ;;
      'file '*) name=$(< "$mode"); cp "$text" "$folder/${name#file }" ;;
      'not run: '*) left=$((left + 1)) ;;
      *) fail "$page: nobody knows <!-- test: $(< "$mode") -->" ;;
    esac
  done
  endRunning "$page"
done
[[ $(state) == "$before" ]] || fail "left in the tree: $(diff <(echo "$before") <(state))"
echo "$ran blocks and commands ran, $left need what a test has not"
