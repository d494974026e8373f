# Generated pages of the documentation are those of the programs, and lists of modules are whole.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
"$bin/agent" --parameters > "$scratch/parameters.md"
cmp -s "$scratch/parameters.md" doc/reference/parameters.md ||
  fail "doc/reference/parameters.md is not what the agent has; write it anew: bin/agent --parameters > doc/reference/parameters.md"
"$bin/optserver" --parameters > "$scratch/search-tasks.md"
cmp -s "$scratch/search-tasks.md" doc/reference/search-tasks.md ||
  fail "doc/reference/search-tasks.md is not what optserver has; write it anew: bin/optserver --parameters > doc/reference/search-tasks.md"
for module in $(sed -nE 's/^([A-Z][A-Za-z0-9]*).*/\1/p' config/modules/*.cfg | sort -u); do
  grep -q "\`$module\`" doc/reference/platforms.md ||
    fail "doc/reference/platforms.md says of all modules of config/modules/ what they make, but not of $module"
done
