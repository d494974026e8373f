#pragma once
#include <future>
#include <string>

#include "optimization/farm/FarmServer.h"
#include "optimization/farm/RunHistory.h"
#include "pages/BoardPages.h"
#include "pages/PageServer.h"
#include "training/Study.h"

namespace plumbline {

/// The page of a search: convergence, the best parameters next to the first ones, the workers, and the best
/// motion. In threads of its own until it is destroyed; the search is read in show() only.
class SearchPage {
public:
  static constexpr int standardPort = 8091;

  /// `what`: the study's file and the folder of the results. Throws std::runtime_error, one line.
  SearchPage(pages::PageServer::Config config, const training::Study& study, const std::string& file,
             const std::string& folder);
  ~SearchPage();

  std::string address() const;
  /// Shows the present state; may be called often, it sends once a second. `server` is null for a run that is
  /// only viewed.
  void show(const Search& search, const farm::RunHistory& history, const farm::FarmServer* server, bool last);

private:
  void film(const Search& search, bool last);

  training::Study study_;
  pages::PageServer::Config config_;
  pages::BoardPages board_;
  pages::PageServer server_;
  double next_ = 0;
  std::int64_t shown_ = -1, filmed_ = -1;
  double nextFilm_ = 0;
  std::future<std::string> filming_;
};

}  // namespace plumbline
