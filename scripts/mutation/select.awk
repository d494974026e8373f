# Which tests a change is tried with, from what Recorder.cpp noted: a line for each run of the test program, with the
# milliseconds it takes and the tests' names with colons between. First those that are named like the file, then those
# that reach the place and are quick, then slow ones. Nothing where no test reaches it.
#   awk -v number=N -v name=STEM -v own=yes -v near="N N" -f select.awk RECORD
# own: it was not switched, so it is not known who reaches it. All tests are tried then, those first that reach one of
# the `near` ones; so they are where the place is reached before the first test.
function add(group, test, ms) { names[group] = names[group] ":" test; sum[group] += ms }
BEGIN { FS = "\t"; if (own == "") near = number; n = split(near, list, " "); for (i = 1; i <= n; ++i) wanted[list[i]] = 1 }
{
  reaches = 0
  for (i = 3; i <= NF; ++i) if ($i in wanted) { reaches = 1; break }
}
$1 == "@start" { if (reaches) all = 1; next }
{ tests[$1] = $2; if (reaches) reached[$1] = 1 }
END {
  if (own != "") all = 1
  for (test in tests) {
    if (!all && !(test in reached)) continue
    add(index(test, name) ? 1 : (test in reached ? 2 : 4) + (tests[test] >= 100), test, tests[test])
  }
  for (i = 1; i <= 5; ++i) if (names[i] != "") print sum[i] "\t" substr(names[i], 2)
}
