#include <sstream>

#include "stages/stage_parameters.hpp"
#include "toile/solve/stage_kind.hpp"

namespace toile::solve {

namespace {

class Sew : public StageKind {
 public:
  const char* name() const override { return "sew"; }
  base::Spec spec() const override {
    base::Spec spec = stage_spec(name(), "Closes the seams step by step.");
    add_steps(spec);
    return spec.list(damping_spec());
  }
  void read(const base::List& list, StageOptions& stage) const override {
    read_stage(list, stage);
    read_steps(list, stage);
    read_damping(list, stage);
  }
  Drive drive(const StageOptions& stage, const State& start) const override {
    return {start.seam, stage.target, start.load, start.load};
  }
  bool closes_seams() const override { return true; }
  double reached(const State& state) const override { return state.seam; }
  const char* measure() const override { return "closing"; }
  std::string reached_text(const StageOptions&, const State& state) const override {
    std::ostringstream text;
    text << state.seam * 100.0 << " % of the seams' closing";
    return text.str();
  }
};

}  // namespace

const StageKind& sew_stage() {
  static const Sew kind;
  return kind;
}

}  // namespace toile::solve
