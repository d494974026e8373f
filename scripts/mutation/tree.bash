# The copy of the tree in which code is changed; sourced by scripts/mutation.sh, whose $out, $tree and fail it uses.
plan=$out/plan.txt keep=$out/keep.txt reached=$out/reached.txt
declare -A switched=() # files with changes

# What becomes of each change, if that is not known from the last run. What is surely not for a switch is `own`: logic, as
# both sides of an operator would be computed then, and sums of texts, whose difference does not compile.
makePlan() {
  mutants | LC_ALL=C sort -t"$tab" -k2,2 -k3,3n -k4,4n > "$out/list.txt"
  [[ -f $plan ]] && cmp -s "$out/list.txt" <(cut -f3- "$plan") && return
  awk -F'\t' -v OFS='\t' '
    function lineOf(file, row,   text, i) {
      for (i = 0; i < row && (getline text < file) > 0;) ++i
      close(file)
      return text
    }
    { print NR, $5 ~ /&&|\|\|/ || ($5 == " + " && lineOf($2, $3) ~ /"|[sS]tring|[nN]ame|[pP]ath/) ? "own" : "plain", $0 }' "$out/list.txt" > "$plan"
  echo '# uses of constants that are not noted' > "$keep"
}

# Writes a file of the copy if it differs, so that little is built anew. $2: the change that is put there by itself.
place() {
  local from=$1
  if [[ ${switched[$1]-} ]]; then
    from=$out/source
    awk -v header="$root/scripts/mutation/Switches.h" -v reached="$reached" -v alone="${2-}" \
      -f scripts/mutation/code.awk -f scripts/mutation/switches.awk "$plan" "$keep" "$1" > "$from"
  fi
  cmp -s "$from" "$tree/$1" || { mkdir -p "$(dirname "$tree/$1")" && cp "$from" "$tree/$1"; }
}

# The copy, as the tree is now, with switches and with a recorder in each test program.
refresh() {
  local file area
  mkdir -p "$tree/bin"
  makePlan
  switched=()
  while read -r file; do switched[$file]=1; done < <(cut -f4 "$plan" | LC_ALL=C sort -u)
  : > "$reached"
  find configure.sh CMakeLists.txt CMakePresets.json cmake scripts src utils config tests -type f ! -path 'tests/data/*' |
    while read -r file; do place "$file"; done
  for area in "${testAreas[@]}"; do
    [[ -d src/$area || $area == diagnosis ]] || continue
    mkdir -p "$tree/tests/$area/recorder"
    file=$tree/tests/$area/recorder/Recorder.cpp
    sed "s#\"Switches.h\"#\"$root/scripts/mutation/Switches.h\"#" scripts/mutation/Recorder.cpp | cmp -s - "$file" ||
      sed "s#\"Switches.h\"#\"$root/scripts/mutation/Switches.h\"#" scripts/mutation/Recorder.cpp > "$file"
  done
  (cd "$tree" && find src tests -type f ! -path 'tests/data/*' ! -path 'tests/*/recorder/*') |
    while read -r file; do [[ -e $file ]] || rm "$tree/$file"; done
  ln -sfn "$PWD/tests/data" "$tree/tests/data"
  ln -sfn "$PWD/doc" "$tree/doc"
}

build() { (cd "$tree" && scripts/build.sh SimRelease "$@") > "$out/log" 2>&1 9>&-; }

# Builds a target. What does not compile behind a switch is taken out, until the rest does.
buildSwitched() {
  local what which file changed round
  for ((round = 0; round < 40; ++round)); do
    build -k 0 "$1" && return
    awk -f scripts/mutation/drop.awk "$plan" "$reached" "$out/log" > "$out/drop"
    [[ -s $out/drop ]] || return 1
    echo "  takes $(wc -l < "$out/drop") switches out that do not compile"
    changed=$(
      while read -r what which; do
        if [[ $what == keep ]]; then
          echo "$which" >> "$keep"
          echo "${which%:*}"
        else
          awk -F'\t' -v OFS='\t' -v n="$which" -v state="$what" '$1 == n { $2 = state } { print }' "$plan" > "$plan.new"
          mv "$plan.new" "$plan"
          awk -F'\t' -v n="$which" '$1 == n { print $4 }' "$plan"
        fi
      done < "$out/drop" | LC_ALL=C sort -u
    )
    while read -r file; do
      grep -v "^$file:" "$reached" > "$reached.new"
      mv "$reached.new" "$reached"
      place "$file"
    done <<< "$changed"
  done
  return 1
}
