#include "stages/stage_parameters.hpp"
#include "toile/solve/stage_kind.hpp"

namespace toile::solve {

namespace {

class Settle : public StageKind {
 public:
  const char* name() const override { return "settle"; }
  base::Spec spec() const override {
    return stage_spec(name(), "Finds the equilibrium at fixed seams, supports and loads.").list(damping_spec());
  }
  void read(const base::List& list, StageOptions& stage) const override {
    read_stage(list, stage);
    read_damping(list, stage);
  }
  bool has_path() const override { return false; }
};

}  // namespace

const StageKind& settle_stage() {
  static const Settle kind;
  return kind;
}

}  // namespace toile::solve
