# Reads what a compiler says of sources that switches.awk wrote, and says what has to change in the plan, a line each:
#   keep FILE:LINE      uses of constants there are not to be noted
#   member NUMBER       the constant is one of a function
#   own NUMBER          the change does not go behind a switch
#   awk -f drop.awk PLAN REACHED OUTPUT
# Where the compiler has to know a number, only the constant that it is of is taken out, as most other errors follow from
# that. Where no error stands at a place that was changed, the notes say where the reason is.
function act(places, known,   place, i, n, numbers, any) {
  for (place in places) {
    if (place in use) { print "keep " place; any = 1; continue }
    if (!(place in at)) continue
    n = split(at[place], numbers, " ")
    for (i = 1; i <= n; ++i) {
      if (numbers[i] in given) continue
      given[numbers[i]] = any = 1
      print ((!known && (place in constant) && state[numbers[i]] == "plain") ? "member " : "own ") numbers[i]
    }
  }
  return any
}
BEGIN { FS = "\t" }
FNR == 1 { ++part }
part == 1 { state[$1] = $2; next }
part == 2 { if ($2 == "use") use[$1] = 1; else at[$1] = at[$1] " " $3; if ($2 == "constant") constant[$1] = 1; next }
match($0, /src\/[A-Za-z0-9_\/]+\.(cpp|h):[0-9]+:/) {
  place = substr($0, RSTART, RLENGTH - 1)
  file = place; sub(/:.*/, "", file)
  if (/ error: .*(not usable in a constant expression|not a constant expression)/) needs[file] = 1
  if (/ error: |required from/) errors[place] = 1
  if (/ note: .*(constant expression|not declared .constexpr)/) reasons[place] = 1
  else if (/ note: /) notes[place] = 1
}
END {
  any = act(reasons, 1)
  for (place in errors) { file = place; sub(/:.*/, "", file); if (any && (file in needs)) delete errors[place] }
  if (!act(errors) && !any) act(notes)
}
