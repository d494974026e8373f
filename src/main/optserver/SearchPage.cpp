#include "SearchPage.h"

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "MotionFilm.h"
#include "framework/SteadyClock.h"
#include "framework/StopSignal.h"
#include "pages/PagePlace.h"
#include "web/Geometry.h"

namespace plumbline {
namespace {

using nlohmann::json;

constexpr double pace = 1, filmPace = 15;  // [s]

json number(double value) { return std::isfinite(value) ? json(value) : json(nullptr); }

json list(const Eigen::VectorXd& values) {
  json result = json::array();
  for (const double value : values) result.push_back(number(value));
  return result;
}

pages::PageServer::Config ofSearch(pages::PageServer::Config config) {
  config.index = "search.html";
  return completed(std::move(config), {"--web-address", "--web-token"});
}

std::string studyText(const training::Study& study, const std::string& file, const std::string& folder) {
  json parameters = json::array();
  for (const training::TaskParameter& one : study.parameters)
    parameters.push_back({{"name", one.name},
                          {"start", one.start},
                          {"lower", number(one.lower)},
                          {"upper", number(one.upper)}});
  const auto bound = [](std::int64_t most) { return most > 1'000'000'000 ? json(nullptr) : json(most); };
  return json{{"kind", "study"},
              {"file", file},
              {"folder", folder},
              {"task", study.task},
              {"options", study.options.values()},
              {"optimizer", study.optimizer},
              {"seed", study.search.seed},
              {"maxGenerations", bound(study.search.stop.maxGenerations)},
              {"maxRuns", bound(study.search.stop.maxEvaluations)},
              {"parameters", std::move(parameters)}}
      .dump();
}

}  // namespace

SearchPage::SearchPage(pages::PageServer::Config config, const training::Study& study,
                       const std::string& file, const std::string& folder)
    : study_(study), config_(ofSearch(std::move(config))), server_(config_, board_) {
  board_.put("geometry", web::geometryMessage({}));
  board_.put("study", studyText(study, file, folder));
  server_.start();
}

SearchPage::~SearchPage() {
  if (filming_.valid()) filming_.wait();
  server_.stop();
}

std::string SearchPage::address() const { return addressOf(config_, server_.port()); }

void SearchPage::show(const Search& search, const farm::RunHistory& history, const farm::FarmServer* server,
                      bool last) {
  film(search, last);
  if (!last && steadySeconds() < next_) return;
  next_ = steadySeconds() + pace;
  const Optimizer& optimizer = search.optimizer();
  json status = {{"kind", "status"},
                 {"generation", optimizer.generations()},
                 {"best", number(optimizer.bestCost())},
                 {"sigma", number(optimizer.sigma())},
                 {"trials", search.trials()},
                 {"runs", search.runs()},
                 {"not_numbers", search.notNumbers()},
                 {"given_up", search.givenUp()},
                 {"live", server != nullptr && !last},
                 {"stop", search.isDone() ? name(optimizer.stopReason()) : ""}};
  if (server) {
    status.update(json::parse(server->status()));
    status["counts"] = {{"answers", server->counts().answers},
                        {"wrong", server->counts().wrong},
                        {"doubted", server->counts().doubted}};
    status["of"] = json::array();
    for (const farm::WorkerReport& worker : server->workerReports())
      status["of"].push_back({{"name", worker.name},
                              {"busy", worker.busy},
                              {"answers", worker.answers},
                              {"seconds", worker.seconds}});
    status["live"] = !last;
  }
  board_.put("status", status.dump());
  if (!last && optimizer.generations() == shown_) return;
  shown_ = optimizer.generations();
  json points = json::array();
  for (const farm::RunHistory::Point& point : history.points())
    points.push_back(
        {point.generation, point.runs, number(point.best), number(point.mean), number(point.sigma)});
  board_.put("curve", json{{"kind", "curve"}, {"points", std::move(points)}}.dump());
  board_.put(
      "found",
      json{{"kind", "found"}, {"best", list(optimizer.best())}, {"favourite", list(optimizer.favourite())}}
          .dump());
}

void SearchPage::film(const Search& search, bool last) {
  if (filming_.valid()) {
    if (!last && filming_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    if (const std::string film = filming_.get(); !film.empty()) board_.put("film", film);
  }
  const std::int64_t generation = search.optimizer().generations();
  if (generation == filmed_ || (!last && steadySeconds() < nextFilm_)) return;
  const bool first = filmed_ < 0;
  filmed_ = generation;
  nextFilm_ = steadySeconds() + filmPace;
  filming_ =
      std::async(std::launch::async, [this, first, study = study_, found = search.optimizer().favourite(),
                                      name = "generation " + std::to_string(generation)] {
        const auto make = [&](const Eigen::VectorXd& values, const std::string& what) -> std::string {
          try {
            return motionFilm(study, values, what);
          } catch (const Stopped&) {
            return {};
          } catch (const std::exception& error) {
            return json{{"kind", "noFilm"}, {"why", error.what()}}.dump();
          }
        };
        if (first) {
          std::string start = make(study.space().start, "start");
          if (!start.empty()) board_.put("filmOfStart", std::move(start));
        }
        return make(found, name);
      });
  if (!last) return;
  if (const std::string film = filming_.get(); !film.empty()) board_.put("film", film);
}

}  // namespace plumbline
