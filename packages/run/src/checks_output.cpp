// The scene's checks, and that its elements see the body: one that does not hold ends the run with its exit status.
#include "check_outcomes.hpp"
#include "output.hpp"
#include "toile/base/error.hpp"

namespace toile::run {

namespace {

class Checks : public Observer {
 public:
  void end(const Record& record) override {
    std::string all;
    for (const CheckOutcome& outcome : check_outcomes(record))
      if (!outcome.holds) all += (all.empty() ? "" : "\n") + outcome.message;
    if (!all.empty()) throw base::Error(base::ExitCode::check_failed, all);
  }
};

}  // namespace

Output checks_output() {
  return {{}, [](const OutputContext& context) -> std::unique_ptr<Observer> {
            if (context.scene.checks().empty() && context.scene.surface() == nullptr) return nullptr;
            return std::make_unique<Checks>();
          }};
}

}  // namespace toile::run
