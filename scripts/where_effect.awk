# What an effect's source says of it, for scripts/where.sh: a row's label, a tab and its text. -v unit=U and
# -v nominal=N: where it has none itself.
function list(text) { gsub(/[A-Za-z]*::|[{}"]/, "", text); sub(/, *$/, "", text); return text }
/^ *\/\/\/ / { line = $0; sub(/^ *\/\/\/ */, "", line); comment = comment (comment == "" ? "" : " ") line; next }
/^const [A-Za-z]*Effect / { does = comment }
{ comment = "" }
/^ *\.[a-zA-Z]+ = / {
  key = $1; sub(/^\./, "", key)
  value = $0; sub(/^[^=]*= */, "", value); of[key] = value
  inSentence = key == "sentence"
  next
}
inSentence && /^ *"/ { line = $0; sub(/^ */, "", line); of["sentence"] = of["sentence"] line }
END {
  if ("sentence" in of) { does = of["sentence"]; gsub(/"|, *$/, "", does); gsub(/[{]at[}]/, "[its place]", does) }
  print "does\t" does
  place = list(("sites" in of) ? of["sites"] : of["site"])
  sub(/OrEverywhere/, ", everywhere", place)
  print "at\t" (place == "" ? "joint" : place)
  if ("unit" in of) unit = list(of["unit"])
  lower = list(of["lower"]); own = list(of["nominal"])
  # 0 is without the effect unless it says otherwise or cannot be 0.
  none = own != "" ? own : lower > 0 ? "" : nominal != "" ? nominal : "0"
  limits = (lower == "" ? 0 : lower) "…" list(of["upper"]) (unit == "" || unit == "1" ? "" : " " unit)
  print "parameters\tits value, " limits (none == "" ? "" : "; " none ": none")
  if ("variants" in of) print "forms\t" list(of["variants"])
}
