#include "toile/solve/stage_kind.hpp"

#include <sstream>

#include "stage_load.hpp"
#include "stage_settle.hpp"
#include "stage_sew.hpp"
#include "toile/base/error.hpp"

namespace toile::solve {

const std::vector<const StageKind*>& stage_kinds() {
  static const std::vector<const StageKind*> kinds = {&sew_stage(), &load_stage(), &settle_stage()};
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
