#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "gap/diagnosis/Diagnosis.h"

namespace plumbline::gap {

/// From recordings to a diagnosis, in one attempt or two. The noise of the first is the difference between
/// repeated recordings. Lost commands make them differ too, which may show only when other causes are known.
/// Then a second attempt uses the noise that remains without the lost commands (evidenceBesideLosses).
class DiagnosisAttempts {
public:
  using Message = std::function<void(const std::string& text)>;
  /// Messages to the user; an empty function is not called.
  struct Messages {
    Message resumed;  ///< searches of a run that was stopped are used
    Message problem;  ///< stored searches cannot be used, or none can be stored
  };

  /// options.memory is not used: each attempt has its own memory, because searches depend on the noise.
  /// memoryFile stores the first attempt's searches, the second's name ends with "2"; empty: nothing is
  /// stored. The robot must outlive this object.
  DiagnosisAttempts(const Mechanism& robot, DiagnosisOptions options, std::string memoryFile,
                    Messages messages);
  ~DiagnosisAttempts();
  DiagnosisAttempts(const DiagnosisAttempts&) = delete;
  DiagnosisAttempts& operator=(const DiagnosisAttempts&) = delete;

  /// Throws Stopped if options.progress throws it; the message names the file from which to continue.
  Diagnosis run(std::vector<Trial> trials);

  /// Of the attempt that gave the diagnosis; only after run().
  Evaluator& evaluator();
  /// Removes the files of memory: the diagnosis is done.
  void forget();

private:
  struct Attempt;
  Diagnosis attempt(Evidence evidence, const std::string& file);

  const Mechanism& robot_;
  const DiagnosisOptions options_;
  const std::string memoryFile_;
  const Messages messages_;
  std::vector<std::unique_ptr<Attempt>> attempts_;
};

}  // namespace plumbline::gap
