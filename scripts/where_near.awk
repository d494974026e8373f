# Names that somebody may have meant by -v name=NAME, the nearest first, for scripts/where.sh: few letters differ, or it is a
# part of them.
function distance(a, b,   i, j, d, c) {
  for (j = 0; j <= length(b); ++j) d[0, j] = j
  for (i = 1; i <= length(a); ++i) {
    d[i, 0] = i
    for (j = 1; j <= length(b); ++j) {
      c = d[i - 1, j - 1] + (substr(a, i, 1) != substr(b, j, 1))
      if (d[i - 1, j] + 1 < c) c = d[i - 1, j] + 1
      if (d[i, j - 1] + 1 < c) c = d[i, j - 1] + 1
      d[i, j] = c
    }
  }
  return d[length(a), length(b)]
}
{
  d = distance(tolower(name), tolower($0))
  if (length(name) > 3 && index(tolower($0), tolower(name))) d = 1
  if (d <= (length(name) < 3 ? 1 : length(name) / 3)) print d "\t" $0 | "sort -n -k1,1 -k2 | cut -f 2"
}
