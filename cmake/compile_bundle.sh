#!/usr/bin/env bash
# Before the compiler of each source. A bundle is a source that includes others.
# - It may fail because names in them meet: then its halves are compiled, and so on, and their objects joined. So an error in
#   a source reads as if there were no bundles, and no name has to be unlike another file's.
# - Where one of its sources alone was edited since it was built, that one and the others, in parts, are compiled at the same
#   time and joined. While the same one is edited, nothing else is compiled again.
#   compile_bundle.sh COMPILER OPTION... -MD -MT X -MF DEPENDENCIES -o OBJECT -c SOURCE
set -euo pipefail
bundle=${*: -1}
[[ $bundle == */Unity/unity_*.cxx ]] || exec "$@"
command=("${@:1:$#-1}")
precompiled=() # headers, which no dependency file names
for ((i = 0; i < ${#command[@]}; ++i)); do
  case ${command[i]} in
    -o) at=$((i + 1)) object=${command[i + 1]} ;;
    -MF) dependenciesAt=$((i + 1)) dependencies=${command[i + 1]} ;;
    -include) precompiled+=("${command[i + 1]}.gch") ;;
  esac
done
mapfile -t sources < <(sed -n 's/^#include "\(.*\)"$/\1/p' "$bundle")
edited=${object%.o}.edited # the parts of a bundle of which one source is edited

# $1: object, $2: source; dependencies go beside the object.
compileTo() {
  local of=("${command[@]}")
  of[at]=$1 of[dependenciesAt]=${1%.o}.d
  "${of[@]}" "$2" 2>&1
}

# Joins objects, and says what they depend on. What was put together here is gone by the next build.
join() {
  if (($# == 1)); then mv -f "$1" "$object"; else ld -r -o "$object" "$@" || return; fi
  sed 's#\([^ \\]\|\\.\)*\.part\.cxx##' "${@/%.o/.d}" > "$dependencies"
}

# Whether what a part was compiled from is as it was: its sources and all that they include.
partIsCurrent() { # $1: its object
  local path
  while read -r path; do
    path=${path//$'\a'/ } # a space within a path
    [[ $path == "" || $path == *: || $path == *.part.cxx ]] || [[ -f $path && ! $path -nt $1 ]] || return 1
  done < <(printf '%s\n' "${precompiled[@]// /$'\a'}"; sed -e 's/\\$//' -e 's/\\ /\a/g' "${1%.o}.d" | tr ' ' '\n')
}
madeOf() { printf '%s\n' "${command[@]}" "${sources[@]}" "edited: $1"; }

# $1: the source that was edited; returns 1 if the bundle has to be compiled as a whole. The others are compiled in so many
# parts: the longest of them takes less time than all of them in one go, and the cores have enough to do.
compileEdited() {
  local one=$1 said="" others part from=0 count=4 i jobs=() failed=""
  mapfile -t others < <(printf '%s\n' "${sources[@]}" | grep -vxF "$one")
  ((count <= ${#others[@]})) || count=${#others[@]}
  if ! cmp -s "$edited/made.of" <(madeOf "$one"); then
    rm -rf "$edited"
    mkdir "$edited"
  fi
  for ((i = 0; i < count; ++i)); do
    part=$edited/others$i
    local next=$((${#others[@]} * (i + 1) / count))
    if [[ ! -f $part.o ]] || ! partIsCurrent "$part.o"; then
      rm -f "$part.o"
      printf '#include "%s"\n' "${others[@]:from:next-from}" > "$part.part.cxx"
      (trap - INT; compileTo "$part.o" "$part.part.cxx" > "$part.log") & # Ctrl-C ends it, too
      jobs+=($!)
    fi
    from=$next
  done
  said=$(compileTo "$edited/one.o" "$one") || {
    printf '%s\n' "$said"
    wait
    rm -rf "$edited"
    exit 1
  }
  for i in "${jobs[@]}"; do wait "$i" || failed=yes; done
  [[ ! $failed ]] || return 1
  said+=$(cat "$edited"/others*.log 2> /dev/null)
  rm -f "$edited"/others*.log
  [[ ! $said ]] || printf '%s\n' "$said"
  madeOf "$one" > "$edited/made.of"
  join "$edited"/others*.o "$edited/one.o"
}

if [[ -f $object ]] && ((${#sources[@]} > 1)); then
  newer=()
  for path in "${sources[@]}"; do [[ ! $path -nt $object ]] || newer+=("$path"); done
  if ((${#newer[@]} == 1)) && compileEdited "${newer[0]}"; then exit; fi
fi
rm -rf "$edited"
if said=$("$@" 2>&1); then
  [[ ! $said ]] || printf '%s\n' "$said"
  exit 0
fi
parts=() # objects that succeeded, each with its dependencies beside it

compile() { # $1: what; prints what the compiler says
  local part=${object%.o}.${#parts[@]}.part.o
  compileTo "$part" "$1" || return 1
  parts+=("$part")
}

compileHalves() { # $1: the first of the sources, $2: how many, which do not go together
  local part=${bundle%.cxx}.part.cxx half=$(($2 / 2)) from count
  if (($2 == 1)); then compile "${sources[$1]}" >&2; return; fi
  for from in "$1" "$(($1 + half))"; do
    count=$((from == $1 ? half : $2 - half))
    printf '#include "%s"\n' "${sources[@]:from:count}" > "$part"
    compile "$part" > "$part.log" || compileHalves "$from" "$count" || return
  done
}

trap 'rm -f "${parts[@]}" "${parts[@]/%.o/.d}" "${bundle%.cxx}".part.*' EXIT
compileHalves 0 ${#sources[@]} || exit
echo "${bundle##*/}: in halves, as: $(grep -m 1 error <<< "$said")" >&2
join "${parts[@]}"
