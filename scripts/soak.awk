# What the samples of scripts/soak.sh come to, in a line; status 1 if a limit is passed.
# Median of values[from] to values[to], and its standard error from the spread between the quartiles.
function median(values, from, to,   i, j, n, sorted, value) {
  n = 0
  for (i = from; i <= to; ++i) {
    value = values[i]
    if (value == "") continue
    for (j = ++n; j > 1 && sorted[j - 1] > value; --j) sorted[j] = sorted[j - 1]
    sorted[j] = value
  }
  counted = n
  if (n == 0) return 0
  spread = (sorted[int((3 * n + 3) / 4)] - sorted[int((n + 3) / 4)]) / 1.349
  error = 1.2533 * spread / sqrt(n)
  return n % 2 ? sorted[(n + 1) / 2] : (sorted[n / 2] + sorted[n / 2 + 1]) / 2
}
# How much a cycle costs more in the second half of the windows [%]; leaves its standard error in `uncertain` and `decided`.
function growth(values,   early, late, errorEarly) {
  early = median(values, from + 1, middle)
  errorEarly = error / (early > 0 ? early : 1)
  few = counted < 4
  late = median(values, middle + 1, n)
  few = few || counted < 4
  if (early == 0 || late == 0) { few = 1; return 0 }
  uncertain = 100 * sqrt(errorEarly ^ 2 + (error / late) ^ 2)
  return 100 * (late / early - 1)
}
function judged(grown) {
  if (few) return "too few windows to tell"
  if (grown - 2 * uncertain > percent) { bad = 1; return "more than " percent " %" }
  return grown + 2 * uncertain < percent ? "below " percent " %" : "not decided"
}
NR == 1 { next }
{
  n = NR - 1
  t[n] = $1; s[n] = $2; a[n] = $3; ms[n] = $6; ma[n] = $7
  cycles = 50 * ($1 - before[1])
  cs[n] = ($4 - before[2]) / cycles; ca[n] = ($5 - before[3]) / cycles / number
  # Without a time of the new game the window does not count.
  rs[n] = $8 > 0 ? cs[n] / $8 : ""
  ra[n] = $9 > 0 ? ca[n] / $9 : ""
  before[1] = $1; before[2] = $4; before[3] = $5
}
END {
  if (n < 6) { print "too few samples"; exit 1 }
  from = int(n / 3) # before it caches and pools fill
  middle = from + int((n - from) / 2)
  grownS = s[n] - s[from]; grownA = a[n] - a[from]
  bad = grownS > limit || grownA > limit * number || alive < number
  printf "%d agents, %d simulated minutes: simulator %+d kB (now %d, allocated %+d), agents together %+d kB (now %d, allocated %+d) since minute %.1f; ",
    number, t[n] / 60, grownS, s[n], ms[n] - ms[from], grownA, a[n], ma[n] - ma[from], t[from] / 60
  printf "CPU per cycle simulator %.0f then %.0f us, an agent %.0f then %.0f us; ", median(cs, from + 1, middle), median(cs, middle + 1, n), median(ca, from + 1, middle), median(ca, middle + 1, n)
  grown = growth(rs)
  printf "against the same game anew, simulator %+.1f %% with standard error %.1f: %s, ", grown, uncertain, judged(grown)
  grown = growth(ra)
  printf "agents %+.1f %% with %.1f: %s; %d agents at the end\n", grown, uncertain, judged(grown), alive
  exit bad
}
