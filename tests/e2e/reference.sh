# Generated pages of the documentation are those of the programs.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
"$bin/agent" --parameters > "$scratch/parameters.md"
cmp -s "$scratch/parameters.md" doc/reference/parameters.md ||
  fail "doc/reference/parameters.md is not what the agent has; write it anew: bin/agent --parameters > doc/reference/parameters.md"
