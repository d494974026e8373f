# The parameters that sources declare, for scripts/where.sh: name=default unit (range) of each PARAMETER(type, name, default,
# "unit", range, "what it does"), and the type of a PARAMETER_GROUP. Also, but for -v macros=1, the members of structs
# that are called ...Options or ...Config.
function trim(text) { gsub(/^[ \t]+|[ \t]+$/, "", text); return text }
# Splits what stands between the macro's brackets at commas that are in no brackets and no text.
function split_(text,   i, c, depth, quoted, n) {
  n = 1; part[1] = ""
  for (i = 1; i <= length(text); ++i) {
    c = substr(text, i, 1)
    if (c == "\"") quoted = !quoted
    if (!quoted && c ~ /[({<]/) ++depth
    if (!quoted && c ~ /[)}>]/ && --depth < 0) break
    if (!quoted && !depth && c == ",") part[++n] = ""; else part[n] = part[n] c
  }
  for (i = 1; i <= n; ++i) part[i] = trim(part[i])
  closed = depth < 0
  return n
}
function range(text) {
  if (text ~ /atLeast\(/) { gsub(/.*\(|\).*/, "", text); return text "…" }
  if (text ~ /atMost\(/) { gsub(/.*\(|\).*/, "", text); return "…" text }
  if (text !~ /^Range\(.+\)$/) return ""
  sub(/^Range\(/, "", text); sub(/\)$/, "", text); sub(/, */, "…", text)
  return text
}
/^ *PARAMETER(_CHOICE|_GROUP)?\(/ { macro = trim($0) }
macro != "" && !/^ *PARAMETER/ { macro = macro " " trim($0) }
macro != "" {
  what = macro; sub(/\(.*/, "", what)
  text = macro; sub(/^[A-Z_]*\(/, "", text)
  n = split_(text)
  if (!closed) next
  macro = ""
  if (what == "PARAMETER_GROUP") { print part[2] " (those of " part[1] ")"; next }
  gsub(/"/, "", part[2])
  if (what == "PARAMETER_CHOICE") {
    for (i = 5; i <= n; ++i) part[4] = part[4] ", " part[i]
    gsub(/"/, "", part[4]); print part[1] "=" part[2] " (" part[4] ")"; next
  }
  unit = part[4]; gsub(/"/, "", unit); limits = range(part[5])
  gsub(/"/, "", part[3])
  print part[2] "=" part[3] (unit == "" ? "" : " " unit) (limits == "" ? "" : " (" limits ")")
  next
}
/^struct [A-Za-z]*(Options|Config) \{/ { options = 1; next }
/^}/ { options = 0 }
options && !macros && /^  [^ \/].* = .*;/ {
  comment = ""
  if (match($0, /\/\/\/< */)) comment = trim(substr($0, RSTART + RLENGTH))
  line = $0; sub(/;.*/, "", line); value = line; sub(/^[^=]*= */, "", value); sub(/ *=.*/, "", line); sub(/.*[ >]/, "", line)
  print line "=" value (comment == "" ? "" : " (" comment ")")
}
