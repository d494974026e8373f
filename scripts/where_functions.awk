# Functions of a source, at the line's begin, that name -v name=NAME or call one that does, for scripts/where.sh: one a line.
/^[A-Za-z].*[a-z]\(.*\{ *$/ { here = $0; sub(/\(.*/, "", here); sub(/.*[ *&:]/, "", here); order[++n] = here }
/^}/ { here = "" }
here != "" { text[here] = text[here] " " $0 " " }
function has(where, what) { return match(where, "[^A-Za-z0-9_]" what "[^A-Za-z0-9_]") }
END {
  for (i = 1; i <= n; ++i) if (has(text[order[i]], name)) names[order[i]]
  for (more = 1; more;) {
    more = 0
    for (i = 1; i <= n; ++i)
      if (!(order[i] in names))
        for (other in names)
          if (has(text[order[i]], other)) { names[order[i]]; more = 1; break }
  }
  for (i = 1; i <= n; ++i) if (order[i] in names) print order[i]
}
