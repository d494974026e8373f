# Writes a source with the changes of a plan behind the switches of Switches.h, its lines where they were; after code.awk:
#   awk -v header=PATH -v alone=NUMBER -v reached=FILE -f code.awk -f switches.awk PLAN KEEP SOURCE
# PLAN has a line for each change, tabs between: number, state, kind, file, line, column, from, to. States:
#   plain, member   behind a switch; the constant of a `member` is no member of a class but one of a function
#   own             not behind a switch: what is compiled by itself. `alone` is the number of the one that is put there
# KEEP lists uses of constants that are not noted, as they would not compile: FILE:LINE.
# `reached` gets what stands where: FILE:LINE, use or constant or place, and numbers of changes.
# Numbers of constants are not known to the compiler any more; so `constexpr` becomes `const`, also where one constant makes
# another. The uses of a file's own constants are noted, as their values are read before any test runs.
function edit(row, at, width, text) { edits[row] = edits[row] "\n" at "\t" width "\t" text }
function infix(number, was, other, outer) {
  return " " outer " mutation::infix<" number ", std::" was "<>, std::" other "<>> " (outer == "<" ? ">" : outer) " "
}
function switchOf(number,   from, to, quiet) {
  from = from_[number]; to = to_[number]
  if (kind_[number] == "threshold") return "mutation::" (silent[number] ? "switched(" : "mutated(") number ", " from ", " to ")"
  if (from ~ /^(true|false)$/) return "mutation::mutated(" number ", " from ", " to ")"
  if (from ~ /^std::/) return "mutation::" substr(from, 6, 3) "<" number ">("
  return infix(number, functors[from], functors[to], from ~ /[<>]/ ? "<" : from ~ /[!=]/ ? "==" : from ~ /[-+]/ ? "+" : "*")
}
# The constants that a declaration from line `row` to `last` declares, each with the changes in its value.
function declare(row, last,   i, at, c, name, word, depth, start) {
  depth = 0; name = ""
  for (i = row; i <= last; ++i) {
    start = i == row ? index(code[i], "constexpr") + 9 : 1
    for (at = start; at <= length(code[i]); ++at) {
      if ((i, at) in numberAt && name != "") named[name] = named[name] " " numberAt[i, at]
      c = substr(code[i], at, 1)
      if (c ~ /[A-Za-z_]/ && match(substr(code[i], at), /^[A-Za-z_0-9]+/)) {
        word = substr(code[i], at, RLENGTH)
        if (depth == 0 && substr(code[i], at + RLENGTH) ~ /^(\[[^\]]*\])? ?[={]/) { if (word != "std") name = word }
        else if (word in named && name != "" && name != word) named[name] = named[name] named[word]
        at += RLENGTH - 1
      } else if (c ~ /[({<]/) ++depth
      else if (c ~ /[)}>]/) --depth
    }
  }
}
function mentions(row, last,   i, rest) {
  for (i = row; i <= last; ++i) {
    rest = code[i]
    while (match(rest, /[A-Za-z_][A-Za-z_0-9]*/)) {
      if (substr(rest, RSTART, RLENGTH) in named) return 1
      rest = substr(rest, RSTART + RLENGTH)
    }
  }
  return 0
}
# Uses of constants in a line: noted, or the constants are `unsure`.
function uses(row, note,   rest, at, word, before, list) {
  rest = code[row]; at = 1
  while (match(rest, /[A-Za-z_][A-Za-z_0-9]*/)) {
    word = substr(rest, RSTART, RLENGTH); at += RSTART - 1; before = substr(code[row], 1, at - 1)
    if (word in named && named[word] != "" && before !~ /([.:]|->|[0-9])$/) {
      if (!note) unsure[word] = 1
      else {
        list = named[word]; sub(/^ /, "", list); gsub(/ /, ", ", list)
        edit(row, at, length(word), "(mutation::seen(" list "), " word ")")
        say(row, "use", named[word])
      }
    }
    at += RLENGTH; rest = substr(rest, RSTART + RLENGTH)
  }
}
function say(row, what, list) { if (reached != "") print source ":" row "\t" what "\t" list >> reached }
BEGIN {
  FS = "\t"
  split("< <= > >= == != + - * /", signs, " ")
  split("less less_equal greater greater_equal equal_to not_equal_to plus minus multiplies divides", names, " ")
  for (i in signs) functors[" " signs[i] " "] = names[i]
}
FNR == 1 { ++part; source = FILENAME }
part == 1 { plan[++planned] = $0; next }
part == 2 { keep[$0] = 1; next }
{ line[FNR] = $0; code[FNR] = codeOf($0); lines = FNR }
END {
  for (i = 1; i <= planned; ++i) {
    split(plan[i], f, "\t")
    if (f[4] != source) continue
    n = f[1]; kind_[n] = f[3]; from_[n] = f[7]; to_[n] = f[8]
    if (f[2] == "own") { if (n == alone) edit(f[5], f[6], length(f[7]), f[8]); continue }
    numberAt[f[5], f[6]] = n; rowOf[n] = f[5]; columnOf[n] = f[6]; state[n] = f[2]
  }
  for (i = 1; i <= lines; ++i) { # the declarations, as list.awk sees them
    if (match(code[i], /constexpr [^=({;]*[={]/)) { first = i; open = 1 }
    if (open) { of[i] = first; last[first] = i }
    if (open && code[i] ~ /;/) open = 0
  }
  for (n in rowOf) if (kind_[n] == "threshold" && (d = of[rowOf[n]])) { has[d] = has[d] " " n; if (state[n] == "member") member[d] = 1 }
  for (d = 1; d <= lines; ++d) {
    if (!(d in last)) continue
    global = source ~ /\.cpp$/ && code[d] ~ /^(inline |static )?constexpr/
    if (has[d] == "" && !mentions(d, last[d])) continue
    if (global) { declare(d, last[d]); for (i = d; i <= last[d]; ++i) quiet[i] = 1 }
    match(code[d], /(static )?(inline )?constexpr/)
    text = substr(code[d], RSTART, RLENGTH)
    edit(d, RSTART, RLENGTH, text !~ /static/ || code[d] ~ /^static/ ? "const" : member[d] ? "const" : "static inline const")
    say(d, "constant", has[d])
  }
  for (i = 1; i <= lines; ++i)
    if (!quiet[i]) uses(i, !((source ":" i) in keep) && code[i] !~ /^[ \t]*(#|template|using|static_assert|MODULE|PARAMETER)/)
  for (name in named) if (!(name in unsure)) { k = split(named[name], list, " "); for (i = 1; i <= k; ++i) silent[list[i]] = 1 }
  for (name in unsure) { k = split(named[name], list, " "); for (i = 1; i <= k; ++i) delete silent[list[i]] }
  for (n in rowOf) { edit(rowOf[n], columnOf[n], length(from_[n]), switchOf(n)); say(rowOf[n], "place", n) }
  printf "#include \"%s\"\n#line 1 \"%s\"\n", header, source
  for (i = 1; i <= lines; ++i) {
    text = line[i]
    k = split(edits[i], list, "\n")
    while (1) { # from right to left
      best = 0; at = 0
      for (j = 2; j <= k; ++j) { split(list[j], f, "\t"); if (list[j] != "" && f[1] + 0 > at) { at = f[1] + 0; best = j } }
      if (!best) break
      split(list[best], f, "\t"); list[best] = ""
      text = substr(text, 1, at - 1) f[3] substr(text, at + f[2])
    }
    print text
  }
}
