# Completion of Plumbline's programs, from what they say with --help: options, subcommands, and paths for the rest.
_plumbline() {
  local current=${COMP_WORDS[COMP_CWORD]} program=${COMP_WORDS[0]} word help commands words=()
  command -v "$program" > /dev/null || return
  help=$("$program" --help 2> /dev/null)
  # The subcommand, where one is given, has options of its own.
  commands=$(sed -n '/^Subcommands:/,$s/^  \([a-z][a-z-]*\).*/\1/p' <<< "$help")
  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    if grep -qx -- "$word" <<< "$commands"; then
      help=$("$program" "$word" --help 2> /dev/null)
      commands=""
      break
    fi
  done
  if [[ $current == -* ]]; then
    mapfile -t words < <(grep -oE -- '(^|[ ,])--?[A-Za-z][A-Za-z-]*' <<< "$help" | tr -d ' ,' | sort -u)
  else
    mapfile -t words <<< "$commands"
    mapfile -t -O ${#words[@]} words < <(compgen -f -- "$current")
  fi
  mapfile -t COMPREPLY < <(compgen -W "${words[*]}" -- "$current")
}
complete -o filenames -F _plumbline @PLUMBLINE_COMPLETED@
