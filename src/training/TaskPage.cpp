#include "training/TaskPage.h"

#include "framework/ParameterPage.h"
#include "training/SearchTask.h"

namespace plumbline::training {

std::string taskPage() {
  std::string page =
      "# Tasks that can be searched\n\n"
      "`bin/optserver --parameters` made this page. `task: NAME` in a study's file chooses a task, its "
      "options "
      "are in\n"
      "the map `options`, and `--option NAME=VALUE` takes the place of one of them\n"
      "([how to optimise a motion](../how-to/optimise-a-motion.md)).\n";
  for (const TaskKind& kind : searchTasks())
    page += "\n## " + std::string(kind.name) + "\n\n" + kind.what + "\n\n" +
            parameterTable(*kind.options, kind.makeOptions().get(), GroupNames::member);
  return page;
}

}  // namespace plumbline::training
