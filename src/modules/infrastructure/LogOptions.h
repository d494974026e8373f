#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "parameters/Parameter.h"
#include "record/Recorder.h"
#include "record/ReplayControl.h"

namespace plumbline {

/// What config/log.yaml may say.
struct LogParameters {
  PARAMETERS(LogParameters)
  PARAMETER(int, fileMegabytes, 512, "MB", Range(1, 100000),
            "size of a file at which the log continues in a new one")
  PARAMETER(int, files, 0, "", Range(0, 10000), "number of newest files that are kept; 0: all")
  PARAMETER(int, bufferMegabytes, 8, "MB", Range(1, 1024),
            "what waits to be written, for each thread; a cycle beyond it is dropped")
  PARAMETER(std::vector<std::string>, representations, {}, "", Range(),
            "representations to record; empty: all")
};

/// What the special module `log` shall do; without such an object, nothing.
struct LogOptions {
  std::shared_ptr<record::Recorder> recorder;      ///< null: nothing is recorded
  std::vector<std::string> representations;        ///< recorded; empty: all
  std::shared_ptr<record::ReplayControl> replay;   ///< null: nothing is replayed
  std::function<void(const std::string&)> notify;  ///< takes a line for the user; may be empty
};

}  // namespace plumbline
