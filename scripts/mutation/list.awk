# Lists what scripts/mutation.sh may change in the sources that it reads (after code.awk), a line each with tabs between:
# kind, file, line, column (from 1), what stands there, what is put there.
#   threshold  numbers of constexpr declarations, and numbers with a point that something is compared with, 30 % off;
#              up or down as a hash of the place says. Only in files that match `thresholds`.
#   operator   comparison, logic, sum, product, true and false, min and max. In all other files.
function say(kind, at, from, to) { if (from != to) printf "%s\t%s\t%d\t%d\t%s\t%s\n", kind, FILENAME, FNR, at, from, to }
function hash(text,   i, h) { # of a place: neighbours go different ways
  h = 17
  for (i = 1; i <= length(text); ++i) h = (h * 31 + index(letters, substr(text, i, 1))) % 1000003
  return h
}
function changed(number, up,   value) {
  value = number * (up ? 1.3 : 0.7)
  if (number ~ /[.e]/) { value = sprintf("%.6g", value); return value ~ /[.e]/ ? value : value "." }
  value = int(value + 0.5)
  return value == number ? number + (up || number < 2 ? 1 : -1) : value
}
# Numbers in code from a column on; compared: only those with a point that follow a comparison.
function numbers(code, from, compared,   rest, at, number, before) {
  while (match(substr(code, from), /[0-9]+(\.[0-9]*)?(e-?[0-9]+)?/)) {
    at = from + RSTART - 1; number = substr(code, at, RLENGTH); from = at + RLENGTH
    before = substr(code, 1, at - 1)
    if (before ~ /[A-Za-z0-9_.'\[<]$/ || substr(code, from, 1) ~ /[A-Za-z0-9_'\]]/ || number + 0 == 0) continue
    if (compared && (number !~ /\./ || before !~ / (<|>|<=|>=) -?$/)) continue
    say("threshold", at, number, changed(number, hash(FILENAME FNR at) % 2))
  }
}
function operators(code, from, to, pattern,   at, start) {
  start = 1
  while ((at = index(substr(code, start), from)) > 0) {
    at += start - 1; start = at + length(from)
    if (pattern != "" && substr(code, at - 1, length(from) + 2) !~ pattern) continue
    say("operator", at, from, to)
  }
}
BEGIN { letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789/_.-" }
FNR == 1 { comment = 0; open = 0 }
{
  code = codeOf($0)
  if (code ~ /^[ \t]*(#|template|using|static_assert|MODULE|PARAMETER)/) next
  if (FILENAME ~ thresholds) {
    if (match(code, /constexpr [^=({;]*[={]/)) { open = 1; numbers(code, RSTART + RLENGTH, 0) }
    else if (open) numbers(code, 1, 0)
    else numbers(code, 1, 1)
    if (open && code ~ /;/) open = 0
    next
  }
  if (FILENAME ~ /\.h$/) next
  operators(code, " < ", " <= "); operators(code, " <= ", " < "); operators(code, " > ", " >= "); operators(code, " >= ", " > ")
  operators(code, " == ", " != "); operators(code, " != ", " == "); operators(code, " && ", " || "); operators(code, " || ", " && ")
  operators(code, " + ", " - "); operators(code, " - ", " + "); operators(code, " * ", " / "); operators(code, " / ", " * ")
  operators(code, "true", "false", "^[^A-Za-z_]true[^A-Za-z_]"); operators(code, "false", "true", "^[^A-Za-z_]false[^A-Za-z_]")
  operators(code, "std::min(", "std::max("); operators(code, "std::max(", "std::min(")
}
