#include "modules/behavior/FormationEditor.h"

#include <filesystem>

#include "framework/DebugSite.h"

namespace plumbline {

MAKE_MODULE(FormationEditor)

namespace {

/// Reading it reads the file, setting it writes the file.
class FormationFileValue final : public DebugValue {
public:
  explicit FormationFileValue(const FormationFile& file) : file_(file) {}
  void write(OutStream& out) const override { StreamType<FormationDraft>::write(out, file_.read()); }
  bool writable() const override { return true; }
  void read(InStream& in) override {
    FormationDraft draft;
    StreamType<FormationDraft>::read(in, draft);
    if (!in.ok()) return;
    try {
      file_.write(draft);
    } catch (const std::exception& error) {
      in.fail(error.what());
    }
  }

private:
  const FormationFile& file_;
};

}  // namespace

void FormationEditor::init() {
  agent_ = findObject<AgentDebug>();
  if (!agent_) return;
  for (const std::string& directory : config.directories()) {
    const std::filesystem::path path = std::filesystem::path(directory) / "formation.yaml";
    if (std::filesystem::exists(path)) file_.emplace(path);  // a later one overrides keys of an earlier one
  }
  if (file_) agent_->points.add(point_);
}

FormationEditor::~FormationEditor() {
  if (agent_ && file_) agent_->points.remove(point_);
}

void FormationEditor::execute() {
  if (!file_ || !point_.active()) return;
  FormationFileValue value(*file_);
  point_.pass(value);
}

}  // namespace plumbline
