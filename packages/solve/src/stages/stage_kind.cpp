#include "toile/solve/stage_kind.hpp"

#include <sstream>

#include "toile/base/error.hpp"

namespace toile::solve {

// Every kind, in the order in which they are described: each is a function NAME_stage() in a source of its own.
#define TOILE_STAGES(STAGE) \
  STAGE(sew)                \
  STAGE(load)               \
  STAGE(settle)

#define TOILE_DECLARE_STAGE(name) const StageKind& name##_stage();
TOILE_STAGES(TOILE_DECLARE_STAGE)

const std::vector<const StageKind*>& stage_kinds() {
#define TOILE_STAGE(name) &name##_stage(),
  static const std::vector<const StageKind*> kinds = {TOILE_STAGES(TOILE_STAGE)};
  return kinds;
}

const StageKind& stage_kind(const std::string& name) {
  base::Texts names;
  for (const StageKind* kind : stage_kinds()) {
    if (kind->name() == name) return *kind;
    names.emplace_back(kind->name());
  }
  throw base::InputError("no kind of stage is named \"" + name + "\"" + base::hint(name, names));
}

Drive StageKind::drive(const StageOptions&, const State& start) const {
  return {start.seam, start.seam, start.load, start.load};
}

std::string StageKind::reached_text(const StageOptions& stage, const State& state) const {
  std::ostringstream text;
  text << "load " << state.load << (stage.arc_length ? " on its path, target " : " of ") << stage.target;
  return text.str();
}

}  // namespace toile::solve
