#pragma once
#include <string>

#include "pages/PageServer.h"

namespace plumbline::pages {

/// Where the pages lie beside the running program; throws std::runtime_error, one line, if they are not
/// built.
std::string builtPage();

/// What a program calls the options of its page.
struct PageOptionNames {
  std::string address = "--bind", token = "--token";
};

/// Empty, or why a server may not listen there without a token, one line.
std::string bindProblem(const std::string& address, const std::string& token,
                        const PageOptionNames& names = {});

/// With the folder of the built pages if it names none. Throws std::runtime_error, one line, for a page that
/// is not there and for an address that needs a token.
PageServer::Config completed(PageServer::Config config, const PageOptionNames& names);

/// What to type into the browser: "http://localhost:8080/", with the token if there is one.
std::string addressOf(const PageServer::Config& config, int port);

}  // namespace plumbline::pages
