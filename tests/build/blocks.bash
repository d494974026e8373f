# Blocks of C++ in the documents, and which of them extend.sh builds: documents.sh compiles the others.
extendedPages=()
for page in module behaviour platform rule kind-of-situation; do extendedPages+=("doc/how-to/add-a-$page.md"); done
for page in effect engine optimiser; do extendedPages+=("doc/how-to/add-an-$page.md"); done

# A page's blocks of C++, each into the file that was named last before it, tests aside.
takeBlocks() { # page, folder for what belongs into src/
  awk -v to="$2" '
    !inside { line = $0; while (match(line, /`(src|tests)\/[A-Za-z0-9_\/]+\.(h|cpp)`/)) {
        file = substr(line, RSTART + 1, RLENGTH - 2); line = substr(line, RSTART + RLENGTH) } }
    /^```cpp$/ { inside = 1; if (file == "") { print FILENAME ":" FNR ": a block without a file" > "/dev/stderr"; exit 1 }
      out = file ~ /^src\// ? to substr(file, 4) : "/dev/null"; folder = out; sub(/\/[^\/]*$/, "", folder)
      if (system("mkdir -p \"" folder "\"")) exit 1
      next }
    /^```$/ && inside { inside = 0; close(out); file = ""; next }
    inside { print > out }' "$1"
}
