# Generated pages of the documentation are those of the programs, and lists of modules are whole.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
"$bin/agent" --parameters > "$scratch/parameters.md"
cmp -s "$scratch/parameters.md" doc/reference/parameters.md ||
  fail "doc/reference/parameters.md is not what the agent has; write it anew: bin/agent --parameters > doc/reference/parameters.md"
"$bin/optserver" --parameters > "$scratch/search-tasks.md"
cmp -s "$scratch/search-tasks.md" doc/reference/search-tasks.md ||
  fail "doc/reference/search-tasks.md is not what optserver has; write it anew: bin/optserver --parameters > doc/reference/search-tasks.md"
mkdir -p "$scratch/doc/reference"
"$bin/situations" page tests/data/situations --pictures "$scratch/doc/img/situations" -o "$scratch/doc/reference/situations.md" > /dev/null
diff -r "$scratch/doc/img/situations" doc/img/situations > /dev/null && cmp -s "$scratch/doc/reference/situations.md" doc/reference/situations.md ||
  fail "doc/reference/situations.md or its pictures are not what tests/data/situations/ holds; make them anew: make pictures ARGS=situations"
for module in $(sed -nE 's/^([A-Z][A-Za-z0-9]*).*/\1/p' config/modules/*.cfg | sort -u); do
  grep -q "\`$module\`" doc/reference/platforms.md ||
    fail "doc/reference/platforms.md says of all modules of config/modules/ what they make, but not of $module"
done
