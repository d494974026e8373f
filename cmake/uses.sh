#!/usr/bin/env bash
# Writes, for each program, test and benchmark, the folders of src/ whose headers its sources include: a line
# "src/main/agent: framework modules" each. It links those. An unchanged file is left alone.
#   cmake/uses.sh FILE
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
export LC_ALL=C
folders=()
for folder in src/main utils tests; do [[ -d $folder ]] && folders+=("$folder"); done
{ find src -mindepth 1 -maxdepth 1 -type d | sed 's#^src/#folder #'
  ((!${#folders[@]})) || grep -rhoHE '^ *# *include *"[A-Za-z0-9_-]+/[^"]*"' "${folders[@]}" --include='*.h' --include='*.cpp' |
    sed 's/: *# *include *"/ /; s/"$//' || true # none includes any
} | awk '
  # The unit of a path: its program, or for what tests share, the file without its suffix.
  function unit(path,   p, n, depth) {
    n = split(path, p, "/")
    if (path ~ /^tests\/support\//) { sub(/\.[a-z]+$/, "", path); return path }
    depth = path ~ /^(src\/main|tests\/bench)\// ? 3 : 2
    if (n <= depth) sub(/\.[a-z]+$/, "", p[n])
    return depth == 3 ? p[1] "/" p[2] "/" p[3] : p[1] "/" p[2]
  }
  function collect(of, into,   i, parts, n) {
    if ((of, into) in seen) return
    seen[of, into] = 1
    n = split(uses[of], parts, " ")
    for (i = 1; i <= n; ++i)
      if (parts[i] ~ /\//) collect(parts[i], into)
      else all[into, parts[i]] = 1
  }
  $1 == "folder" { isFolder[$2] = 1; next }
  {
    u = unit($1); units[u] = 1
    top = $2; sub(/\/.*/, "", top)
    if (top in isFolder) uses[u] = uses[u] " " top
    else if (top == "support" || top == "bench" || top == "fuzz") { other = unit("tests/" $2); if (other != u) uses[u] = uses[u] " " other }
  }
  END {
    for (u in units) {
      if (u ~ /^tests\/support\//) continue
      collect(u, u)
      line = ""
      for (f in isFolder) if (f != "main" && (u, f) in all) line = line " " f
      print u ":" line
    }
  }' | awk '{ n = split($0, f, " "); for (i = 3; i <= n; ++i) for (j = i; j > 2 && f[j] < f[j-1]; --j) { t = f[j]; f[j] = f[j-1]; f[j-1] = t }
             line = f[1]; for (i = 2; i <= n; ++i) line = line " " f[i]; print line }' | sort > "$1.new"
if cmp -s "$1.new" "$1"; then rm "$1.new"; else mv -f "$1.new" "$1"; fi
