// The scene's checks, and that its elements see the body: one that does not hold ends the run with its exit status.
#include <sstream>

#include "check_outcomes.hpp"
#include "output.hpp"
#include "toile/base/error.hpp"

namespace toile::run {

namespace {

/// A result that the mesh cannot give is none. Empty: there is no such place.
std::string unseen_fault(const Pierced& pierced) {
  if (pierced.passed > 0)
    return "the garment presses on the body nowhere, and " + std::to_string(pierced.passed) +
           " of its elements lie beyond the body, seen from where they were placed: it went through between their "
           "nodes, "
           "or was led round it. Give the panel smaller elements (its list \"Sizes\", or \"finer\") and the stage "
           "smaller "
           "steps (\"first step\")";
  if (!pierced.unseen()) return "";
  std::ostringstream text;
  text.precision(3);
  text << "the elements do not see the body: between their nodes it sticks out of them by "
       << (pierced.share < 1.0 ? "up to " : "more than ") << pierced.height << " mm at (" << pierced.where.x() << ", "
       << pierced.where.y() << ", " << pierced.where.z() << ") mm, " << pierced.share
       << " of their side, and at most 0.5 is allowed. What the fabric presses there, and what it carries, is "
          "not known. Give the panel smaller elements there (its list \"Sizes\", or \"finer\"), or round the body's "
          "tip or "
          "edge";
  return text.str();
}

class Checks : public Observer {
 public:
  void end(const Record& record) override {
    std::string all = unseen_fault(record.pierced());
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
