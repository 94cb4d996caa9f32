#pragma once

#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "toile/base/log.hpp"
#include "toile/base/parameters.hpp"
#include "toile/base/timer.hpp"
#include "toile/run/observer.hpp"
#include "toile/run/record.hpp"
#include "toile/scene/scene.hpp"
#include "toile/scene/start_report.hpp"

namespace toile::run {

struct Options {
  int threads = 1;             ///< of each rank in the element loops; 0: as the program has set them
  bool allow_plugins = false;  ///< the scene may load programs
  base::Log log = {};          ///< who is told of the run in words; nobody by default, but warnings are kept
};

/// A scene, its run and the record of it. Collective over MPI's world, which must be initialised (Tpetra::ScopeGuard).
///
///   run::Session session("leg.xml");
///   run::add_outputs(session, {"results"});
///   session.run();
///   session.record().pressure().levels.front().pressure_mean;
class Session {
 public:
  /// Reads and builds a scene. Throws base::InputError.
  explicit Session(const std::string& file, const Options& options = {});
  /// Of a list in memory, as a file would hold it; `name` stands for the file in messages, and paths in the list count
  /// from its folder.
  Session(const Teuchos::ParameterList& content, const std::string& name, const Options& options = {});
  /// Of a list that was validated against scene::scene_spec().
  explicit Session(const base::List& list, const Options& options = {});
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  ~Session();

  const scene::Scene& scene() const { return scene_; }
  const base::List& list() const { return list_; }
  const Record& record() const { return record_; }
  base::Timer& timer() { return timer_; }
  base::Log& log() { return log_; }
  /// What is said of the start; looked at once.
  const scene::StartReport& start_report();

  void add(std::unique_ptr<Observer> observer);
  /// `wanted` is asked on every rank after each iteration: empty, or why the run is to end. Then its stage fails.
  void stop_when(std::function<std::string()> wanted) { wanted_ = std::move(wanted); }

  /// Before run(): goes on after the last step of an earlier run of this scene, from its restart.h5. The outputs go on
  /// with the files of that run. Throws base::InputError, on every rank, if the file cannot be used or is of another
  /// scene (scene::differences). Collective.
  void resume(const std::string& restart_file);

  /// Tells the start and refuses it if it cannot be wanted, then takes the garment through every stage. Once a session.
  /// Throws base::InputError, base::SolveError, or what an observer threw; the record then ends with the last accepted
  /// step.
  void run();

 private:
  struct Input {
    material::Laws laws;
    base::List list;
    std::vector<std::string> warnings = {};  ///< of how it was read
  };
  /// `read`: from a scene's description to its list.
  template <class Read>
  static Input read_input(const material::Laws& laws, const Read& read);
  Session(Input input, const Options& options);
  void identify();
  void run_stages();
  void run_stage(solve::Simulation& simulation, const solve::StageOptions& stage);
  void watch(solve::Simulation& simulation);
  void notify(const std::function<void(Observer&)>& tell);
  void throw_pending();
  /// Tells the observers and returns what is kept of the run.
  std::string tell_failure();

  base::Timer timer_;
  base::Log log_;
  Input input_;
  const base::List& list_;
  scene::Scene scene_;
  Record record_;
  std::optional<scene::StartReport> start_;
  std::vector<std::unique_ptr<Observer>> observers_;
  std::function<std::string()> wanted_;
  std::exception_ptr pending_;        ///< of an observer of iterations, until its stage has ended
  const Observer* failed_ = nullptr;  ///< threw on this rank
  bool alike_ = false;                ///< the error that ends the run is one of every rank
  bool ran_ = false, resumed_ = false;
};

/// Prints what is said of a start, and throws base::InputError for what cannot be wanted.
void tell_start(const scene::StartReport& start, base::Log& log);

}  // namespace toile::run
