# Writes doc/results/mutation.md from what was tried; sourced by scripts/mutation.sh, whose $results and fail it uses.

# Survivors of one kind, $1, a row for each file.
survivors() {
  echo "| file | line: from → to |"
  echo "|---|---|"
  awk -F'\t' -v OFS='\t' -v kind="$1" '$1 == kind { for (i = 7; i <= 8; ++i) { gsub(/^ | $/, "", $i); gsub(/\|/, "\\|", $i) }; print $4, $5, $6, $7, $8 }' "$results" |
    LC_ALL=C sort -t"$tab" -k1,1 -k2,2n -k3,3n |
    awk -F'\t' '$1 != file { if (file != "") print " |"; file = $1; printf "| `%s` | ", file; between = "" }
      { printf "%s%d: `%s` → `%s`", between, $2, $4, $5; between = ", " }
      END { if (NR) print " |" }'
}

report() {
  local page=doc/results/mutation.md machine
  machine=$(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo | sed -n 1p)
  [[ -s $results ]] || fail "nothing was tried yet: make mutation"
  {
    echo "# Measured: what the tests notice"
    echo
    echo "\`make mutation\` (\`scripts/mutation.sh\`) changes one place of the code at a time, a threshold by 30 % or an operator, and"
    echo "runs the tests of its folder that reach the place. A change survives when no test fails. Not every survivor is a gap: some"
    echo "changes have no effect that anybody could see, and some thresholds may well be others. \"Not reached\" is what no test of the"
    echo "folder runs at all. \`LONG=yes\` also runs \`tests/diagnosis\`, minutes each, for changes of \`src/gap\`; the table is without."
    echo
    echo "Seed $seed, $(date -u -r "$results" +%Y-%m-%d), $(nproc) cores of ${machine:-an unknown CPU}: $(wc -l < "$results") of $(mutants | wc -l) changes were tried. Lines are those of that tree."
    echo
    echo "| folder | kind | tried | noticed | survived | not reached | did not compile |"
    echo "|---|---|---|---|---|---|---|"
    awk -F'\t' 'function row(k) { return sprintf("| %d | %d | %d | %d | %d |", n[k], r[k, "noticed"], r[k, "survived"], r[k, "unreached"], r[k, "invalid"]) }
      { split($4, p, "/"); k = "`src/" p[2] (p[2] == "gap" && p[4] != "" ? "/" p[3] : "") "` | " $3; ++n[k]; ++r[k, $1]; ++n[""]; ++r["", $1] }
      END { for (k in n) if (k != "") print "0| " k " " row(k); print "1| all | " " " row("") }' "$results" | LC_ALL=C sort | cut -c2-
    printf '\n## Not reached by any test\n\n'
    survivors unreached
    printf '\n## Reached, and no test fails\n\n'
    survivors survived
  } > "$page.new" && mv "$page.new" "$page" && echo "$page"
}
