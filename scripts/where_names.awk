# What registers itself from a source, for scripts/where.sh: kind, name and file of each MAKE_X(Identifier, ..."name").
# An effect's name is its .id = "name" above.
BEGIN {
  kind["EFFECT"] = "effect"; kind["LEAGUE_EFFECT"] = "effect of the league"; kind["OPTIMIZER"] = "optimiser"
  kind["PHYSICS"] = "physics engine"; kind["ROBOT_SIMULATION"] = "engine for servo robots"; kind["PLATFORM"] = "platform"
  kind["RULE"] = "rule"; kind["TASK"] = "task"; kind["SPECIAL_MODULE"] = "module"
}
function put() { if (what) print kind[what] "\t" named "\t" file; what = "" }
FNR == 1 { put(); id = "" }
/\.id = "/ { split($0, part, "\""); id = part[2] }
/^MAKE_[A-Z_]+\(/ {
  put(); what = $0; sub(/^MAKE_/, "", what); sub(/\(.*/, "", what)
  if (!(what in kind)) { what = ""; next }
  named = $0; sub(/^[^(]*\(/, "", named); sub(/[,) ].*/, "", named); gsub(/"/, "", named); file = FILENAME; lines = 0
  if (what ~ /EFFECT/) { named = id; put() }
}
what && index($0, "\"") { split($0, part, "\""); named = part[2]; put() }
what && ++lines > 3 { put() }
END { put() }
