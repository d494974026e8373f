#include "pages/PagePlace.h"

#include <filesystem>
#include <stdexcept>

#include "framework/ConfigFolder.h"
#include "framework/Loopback.h"
#include "simspark/ChildProcess.h"

namespace plumbline::pages {

std::string bindProblem(const std::string& address, const std::string& token, const PageOptionNames& names) {
  if (isLoopbackAddress(address) || !token.empty()) return {};
  return names.address + ' ' + address + " opens the page to others: set a " + names.token;
}

std::string builtPage() {
  const std::string programs = programFolder();
  for (const char* folder : {"/../build/web", "/../../web"})
    if (std::filesystem::exists(programs + folder + "/index.html"))
      return std::filesystem::canonical(programs + folder).string();
  throw std::runtime_error("the page is not built: run `make web` once");
}

PageServer::Config completed(PageServer::Config config, const PageOptionNames& names) {
  if (const std::string problem = bindProblem(config.address, config.token, names); !problem.empty())
    throw std::runtime_error(problem);
  if (config.folder.empty()) config.folder = builtPage();
  if (!std::filesystem::exists(config.folder + '/' + config.index))
    throw std::runtime_error(config.folder + ": no page there; `make web` builds it into build/web");
  return config;
}

std::string addressOf(const PageServer::Config& config, int port) {
  const bool loopback = isLoopbackAddress(config.address);
  const std::string address =
      "http://" + (loopback ? "localhost" : config.address) + ':' + std::to_string(port) + '/';
  return config.token.empty() ? address : address + "?token=" + config.token;
}

}  // namespace plumbline::pages
