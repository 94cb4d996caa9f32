#include "toile/contact/laws.hpp"

namespace toile::contact {

namespace {

class Frictionless : public Law {
 public:
  NodeContact evaluate(const Touch& touch) const override { return normal_contact(touch); }
};

}  // namespace

LawPtr frictionless() {
  static const LawPtr law = std::make_shared<Frictionless>();
  return law;
}

LawKind frictionless_law() {
  return {base::Spec("frictionless", "The body pushes along its normal only."),
          [](const base::List&) { return frictionless(); }};
}

}  // namespace toile::contact
