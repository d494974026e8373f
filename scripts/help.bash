# Sourced by scripts with "$@": for -h and --help prints the comment at the script's head and ends it.
case ${1-} in
  -h | --help)
    sed -n '2,$ { /^#/!q; s/^# \{0,1\}//p }' "$0"
    exit 0
    ;;
esac
# For scripts that take no options: any word is a mistake.
noArguments() {
  (($# == 0)) || { echo "${0##*/}: unexpected argument '$1'; see ${0##*/} --help" >&2; exit 2; }
}
