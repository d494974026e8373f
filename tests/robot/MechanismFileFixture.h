#pragma once
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "robot/MechanismFile.h"

namespace plumbline {

/// A folder for robots' files and the errors of reading them.
class MechanismFileFixture : public testing::Test {
protected:
  MechanismFileFixture()
      : folder(std::filesystem::path(testing::TempDir()) / ("mechanism" + std::to_string(counter++))) {
    std::filesystem::create_directories(folder);
  }
  ~MechanismFileFixture() override { std::filesystem::remove_all(folder); }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder / name) << text;
    return (folder / name).string();
  }

  /// The error of reading a file of that text, its folder taken off.
  std::string errorOf(const std::string& name, const std::string& text) const {
    write(name, text);
    return errorOf(name);
  }
  std::string errorOf(const std::string& name) const {
    try {
      readMechanism((folder / name).string());
    } catch (const MechanismError& error) {
      std::string what = error.what();
      for (std::size_t at; (at = what.find(folder.string() + "/")) != std::string::npos;)
        what.erase(at, folder.string().size() + 1);
      return what;
    }
    return "no error";
  }

  const std::filesystem::path folder;
  static inline int counter = static_cast<int>(getpid());
};

}  // namespace plumbline
