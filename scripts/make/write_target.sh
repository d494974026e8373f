# Second half of configure.sh: from the settings and the list of files to build/<target>/.
# shellcheck shell=bash disable=SC2154

# True when path $1 lies in one of the folders $2.
isIn() {
  local folder
  for folder in $2; do [[ $1 == "${folder%/}"/* ]] && return 0; done
  return 1
}

# The first name below whichever folder of $2 holds path $1: the file without suffix, or the folder.
firstLevel() {
  local folder rest
  for folder in $2; do
    [[ $1 == "${folder%/}"/* ]] || continue
    rest=${1#"${folder%/}"/}
    if [[ $rest == */* ]]; then REPLY=${rest%%/*}; else REPLY=${rest%.*}; fi
    return
  done
}

# Adds object $2 to output $1, a path; remembers the kind of output $3.
addObject() {
  [[ ${objectsOf[$1]-} ]] || outputs+=("$1")
  objectsOf[$1]+=" $2"
  kindOf[$1]=$3
}

# Which output a source belongs to, by folder. $1: path in the source tree, $2: object.
classify() {
  if [[ $output ]]; then
    case $output in
      *.a | *.so) addObject "$libraryDir/$output" "$2" library ;;
      *) addObject "$outputDir/$output" "$2" program ;;
    esac
  elif isIn "$1" "$supportDir"; then addObject "$build/lib/libsupport.a" "$2" support
  elif isIn "$1" "$benchDir"; then firstLevel "$1" "$benchDir"; addObject "$build/bench/$REPLY" "$2" bench
  elif isIn "$1" "$testDirs"; then firstLevel "$1" "$testDirs"; addObject "$build/tests/$REPLY" "$2" test
  elif isIn "$1" "$programDirs"; then firstLevel "$1" "$programDirs"; addObject "$outputDir/$REPLY" "$2" program
  elif isIn "$1" "$moduleDirs"; then addObject "$libraryDir/$moduleLibrary" "$2" modules
  else addObject "$libraryDir/$library" "$2" library
  fi
}

# Writes the dependency file of a new object: the rule as it stands before the first compile.
startDependencyFile() { # $1 object, $2 source, $3 language
  local file=${1%.o}.d
  [[ -f $file ]] || printf '%s: %s\n\t$(call %s.compile.%s,%s)\n' "$1" "$2" "$target" "$3" "$2" > "$file"
}

language() { case $1 in build/*/together/*) REPLY=together ;; *.c) REPLY=c ;; build/generated/*) REPLY=generated ;; *) REPLY=cpp ;; esac; }

# Bundles $together neighbours or so among an output's C++ sources: what they include and instantiate alike costs
# once then. Replaces their objects by those of the bundles. A bundle stays within a folder or a few small ones side
# by side, so that a file that comes or goes moves no other folder's.
bundle() {
  local o object members path kept folder group
  rm -rf "$build/together.new"
  mkdir -p "$build/together" "$build/together.new" "$build/obj/together"
  for o in "${outputs[@]}"; do
    members=() kept="" group=""
    for object in ${objectsOf[$o]}; do
      path=${sourceOf[$object]}
      language "$path"
      if [[ $REPLY != cpp ]]; then
        kept+=" $object"
        continue
      fi
      folder=${path%/*}
      if [[ $folder != "$group" ]] && ! { ((${#members[@]} < together / 2)) && areNear "$folder" "$group"; }; then
        bundleGroup
        members=() group=$folder
      fi
      members+=("$object")
    done
    bundleGroup
    objectsOf[$o]=$kept
  done
  for path in "$build/together"/*[0-9].cpp; do [[ -f $build/together.new/${path##*/} ]] || rm -f "$path"; done
  rm -r "$build/together.new"
  mapfile -t objects < <(printf '%s\n' ${objectsOf[@]} | sort)
}

# True when folders $1 and $2 share their first two levels.
areNear() {
  local first second rest
  IFS=/ read -r first second rest <<< "$1"
  [[ $2/ == "$first/$second/"* ]]
}

# Writes $members of output $o, from folder $group on, as bundles of like size and adds their objects to $kept.
bundleGroup() {
  local i first next path object count=$(((${#members[@]} + together / 2) / together))
  if ((!count && ${#members[@]})); then count=1; fi
  for ((i = 0; i < count; ++i)); do
    first=$((i * ${#members[@]} / count)) next=$(((i + 1) * ${#members[@]} / count))
    path=${o##*/}.${kindOf[$o]}.${group//\//-}$i
    for object in "${members[@]:first:next-first}"; do
      printf '#include "%s"\n' "${sourceOf[$object]}" >> "$build/together.new/$path.cpp"
      unset "sourceOf[$object]"
    done
    writeIfChanged "$build/together/$path.cpp" < "$build/together.new/$path.cpp"
    object=$build/obj/together/$path.o
    sourceOf[$object]=$build/together/$path.cpp
    kept+=" $object"
  done
}

# Prints every output with its objects and how it is built.
writeRules() {
  local o objects libs whole deps d kept
  local dependencyLibraries="" rpaths="-Wl,-rpath,'\$\$ORIGIN/../lib'"
  for d in $depends; do
    [[ -f build/$d/target.mk ]] || ./configure.sh --refresh-one "$d" || exit 2
    kept=$(sed -n "s/^$d\.libraries := //p" "build/$d/target.mk")
    dependencyLibraries+=" $kept"
    for o in $kept; do [[ $o == *.so ]] && rpaths+=" -Wl,-rpath,'$PWD/${o%/*}'"; done
  done
  for o in "${outputs[@]}"; do
    objects=${objectsOf[$o]# }
    printf '%s\n' "$objects" | writeIfChanged "$build/lists/${o##*/}.${kindOf[$o]}"
    deps="$build/lists/${o##*/}.${kindOf[$o]} $build/flags.link"
    libs="" whole=""
    local name=${o##*/} ownLibrary="" ownModules="" support=""
    [[ ${objectsOf[$libraryDir/$library]-} && ! $output ]] && ownLibrary=$libraryDir/$library
    [[ ${objectsOf[$libraryDir/$moduleLibrary]-} && ! $output ]] && ownModules=$libraryDir/$moduleLibrary
    [[ ${objectsOf[$build/lib/libsupport.a]-} ]] && support=$build/lib/libsupport.a
    case ${kindOf[$o]} in
      program)
        [[ " $programsWithModules " == *" $name "* ]] && whole=$ownModules
        libs="$ownLibrary$dependencyLibraries" ;;
      test | bench)
        [[ " $testsWithModules " == *" $name "* ]] && whole=$ownModules
        libs="$support $ownLibrary$dependencyLibraries" ;;
      library | modules | support) [[ $o == *.so ]] && libs=$dependencyLibraries ;;
    esac
    case $o in
      *.a) printf '%s: %s %s\n\t$(%s.archive)\n' "$o" "$deps" "$objects" "$target" ;;
      *.so) printf '%s: %s %s\n\t$(call %s.shared,%s,%s)\n' "$o" "$deps" "$objects $libs" "$target" "$objects" "$libs" ;;
      *) local extra=""
        case ${kindOf[$o]} in test) extra=$testLibraries ;; bench) extra=$benchLibraries ;; esac
        [[ $whole ]] && wholeFlags="-Wl,--whole-archive $whole -Wl$(printf '\x24(comma)')--no-whole-archive" || wholeFlags=""
        wholeFlags=${wholeFlags//-Wl,/-Wl\$(comma)}
        printf '%s: %s %s\n\t$(call %s.program,%s,%s,%s,%s)\n' "$o" "$deps" "$objects $whole $libs" "$target" \
          "$objects" "$wholeFlags $libs" "$extra" "${rpaths//,/\$(comma)}" ;;
    esac
  done
}

# The outputs of the kinds named in $1.
outputsOf() {
  local o list=""
  for o in "${outputs[@]}"; do [[ " $1 " == *" ${kindOf[$o]} "* ]] && list+=" $o"; done
  REPLY=${list# }
}

writeTarget() {
  declare -gA objectsOf=() kindOf=() sourceOf=()
  declare -ga sources=() objects=() outputs=()
  local generatedHeaders="" path suffix stem made rule o
  declare -A directories=()

  # The sources: those found, those generated from what was found, those named in the settings.
  local -A placeOf=()
  for path in "${found[@]}"; do
    suffix=${path##*.} stem=${path%.*} made=""
    for rule in $generators; do [[ ${rule%%:*} == "$suffix" ]] && made=${rule#*:}; done
    if [[ ! $made ]]; then sources+=("$path"); placeOf[$path]=$path; continue; fi
    for suffix in ${made//,/ }; do
      o=build/generated/$stem.$suffix
      directories[${o%/*}]=1
      case $suffix in
        *.h | *.hpp | h | hpp) generatedHeaders+=" $o" ;;
        *) sources+=("$o"); placeOf[$o]=$path ;;
      esac
    done
  done
  for path in $generatedFiles; do
    case $path in
      *.h | *.hpp) generatedHeaders+=" $path" ;;
      *) sources+=("$path"); placeOf[$path]=${path#build/generated/} ;;
    esac
    directories[${path%/*}]=1
  done
  ((${#sources[@]})) || fail "target $target: no sources in $sourceDirs"

  for path in "${sources[@]}"; do
    o=$build/obj/${path#build/}.o
    sourceOf[$o]=$path
    objects+=("$o")
    directories[${o%/*}]=1
    classify "${placeOf[$path]}" "$o"
  done
  mkdir -p "${!directories[@]}" "$build/lists"
  if ((together > 1)); then bundle; fi
  for o in "${objects[@]}"; do language "${sourceOf[$o]}"; startDependencyFile "$o" "${sourceOf[$o]}" "$REPLY"; done

  # What went away takes its object and its output along.
  local old
  if [[ -f $build/objects ]]; then
    while read -r old; do [[ ${sourceOf[$old]-} ]] || rm -f "$old" "${old%.o}.d"; done < "$build/objects"
  fi
  if [[ -f $build/outputs ]]; then
    while read -r old; do [[ ${objectsOf[$old]-} ]] || rm -f "$old"; done < "$build/outputs"
  fi
  printf '%s\n' "${objects[@]}" > "$build/objects"
  printf '%s\n' "${outputs[@]}" > "$build/outputs"
  printf '%s\n' "$depends" > "$build/depends"

  # Command lines. An object depends on the file that holds its command line, so new flags compile anew.
  local pic="" include="" i
  case "$output $library $moduleLibrary" in *.so*) pic=" -fPIC" ;; esac
  for i in $includeDirs; do include+=" -I$i"; done
  for i in $systemIncludeDirs; do include+=" -isystem $i"; done
  local common="$cppflags$include $warnings $flags$pic"
  declare -g commandC="$cc $cflags $common" commandCpp="$cxx $cxxflags $common" commandHeader=""
  if [[ $precompiled ]]; then
    commandHeader="$commandCpp -x c++-header"
    commandCpp+=" -include $build/precompiled.h -fpch-preprocess"
    writeIfChanged "$build/precompiled.h" < "$precompiled"
  fi
  printf '%s\n%s\n%s\n' "$commandC" "$commandCpp" "$generatedFlags" | writeIfChanged "$build/flags.compile"
  printf '%s\n' "$cxx $flags $ldflags $libraries | $testLibraries | $benchLibraries | $depends" | writeIfChanged "$build/flags.link"

  local programs libs tests benches testNames benchNames
  outputsOf program; programs=$REPLY
  outputsOf "library modules"; libs=$REPLY
  outputsOf test; tests=$REPLY
  outputsOf bench; benches=$REPLY
  {
    printf '# Written by configure.sh for target %s; a new run overwrites it.\n' "$target"
    printf '%s.cxx := %s\n' "$target" "$cxx"
    printf '%s.objects := %s\n' "$target" "${objects[*]}"
    printf '%s.libraries := %s\n' "$target" "$libs"
    printf '%s.programs := %s\n' "$target" "$programs"
    printf '%s.tests := %s\n' "$target" "$tests"
    printf '%s.benches := %s\n' "$target" "$benches"
    cat << RULES
# \$1: source. The compiler writes the dependencies, the rule is put behind them.
$target.command.cpp := $commandCpp
$target.command.generated := $commandCpp $generatedFlags
$target.command.c := $commandC
$target.compile = \$(Q)\$(call say,\$(3),\$(1)); \$(CCACHE) \$($target.command.\$(2)) -MMD -MP -MT \$@ -MF \$(@:o=d).new -c \$(1) -o \$@ && \\
  printf '\$@: \$(1)\\n\\t\$\$(call $target.compile.\$(2),\$(1))\\n' >> \$(@:o=d).new && mv -f \$(@:o=d).new \$(@:o=d)
$target.compile.cpp = \$(call $target.compile,\$(1),cpp,C++)
$target.compile.generated = \$(call $target.compile,\$(1),generated,C++)
$target.compile.c = \$(call $target.compile,\$(1),c,C)
$target.compile.together = \$(Q)\$(call say,C++,\$(1)); scripts/make/compile_together.sh \$@ \$(@:o=d).new \$(1) \$(CCACHE) \$($target.command.cpp) && \\
  printf '\$@: \$(1)\\n\\t\$\$(call $target.compile.together,\$(1))\\n' >> \$(@:o=d).new && mv -f \$(@:o=d).new \$(@:o=d)
$target.archive = \$(Q)\$(call say,AR,\$@); mkdir -p \$(@D); rm -f \$@; ar rcsT \$@ \$(filter %.o,\$^)
# \$1: objects, \$2: libraries of the tree, \$3: libraries of this kind of program, \$4: where it finds .so files
$target.program = \$(Q)\$(call say,LINK,\$@); mkdir -p \$(@D); $cxx $flags $ldflags -o \$@ \$(1) \$(2) \$(3) \$(4) $libraries
$target.shared = \$(Q)\$(call say,LINK,\$@); mkdir -p \$(@D); $cxx -shared -fPIC -Wl,-soname,\$(@F) $flags $ldflags -o \$@ \$(1) \$(2) $libraries
.PHONY: $target $target-tests $target-bench
$target: \$($target.libraries) \$($target.programs) $depends
$target-tests: $target \$($target.tests)
$target-bench: $target \$($target.benches)
\$($target.objects): $build/flags.compile |$generatedHeaders
.PHONY: \$(addprefix $target-test-,\$(notdir \$($target.tests))) \$(addprefix $target-bench-,\$(notdir \$($target.benches)))
\$(addprefix $target-test-,\$(notdir \$($target.tests))): $target-test-%: $build/tests/%
\$(addprefix $target-bench-,\$(notdir \$($target.benches))): $target-bench-%: $build/bench/%
RULES
    writeRules
    if [[ $precompiled ]]; then
      printf '$(filter-out %%.c.o,$(%s.objects)): %s.gch\n' "$target" "$build/precompiled.h"
      printf '%s.gch: %s %s %s\n' "$build/precompiled.h" "$build/precompiled.h" "$precompiled" "$build/flags.compile"
      printf '\t$(Q)$(call say,C++,%s); $(CCACHE) %s %s -o $@\n' "$precompiled" "$commandHeader" "$build/precompiled.h"
    fi
    printf 'targets.makefiles += %s\n' "$includedMakefiles"
    printf 'include %s\n' "${objects[*]/%.o/.d}"
  } > "$build/target.mk.new"
  mv -f "$build/target.mk.new" "$build/target.mk"
}

# compile_commands.json in the root, for editors and clang-tidy.
writeCompileCommands() {
  local path command comma=""
  {
    printf '[\n'
    for path in "${sources[@]}"; do
      language "$path"
      case $REPLY in c) command=$commandC ;; *) command=$commandCpp ;; esac
      command=${command//\\/\\\\}
      printf '%s{"directory":"%s","file":"%s","output":"%s","command":"%s -c %s -o %s"}' "$comma" "$PWD" \
        "$path" "$build/obj/${path#build/}.o" "${command//\"/\\\"}" "$path" "$build/obj/${path#build/}.o"
      comma=$',\n'
    done
    printf '\n]\n'
  } > compile_commands.json.new
  mv -f compile_commands.json.new compile_commands.json
}
