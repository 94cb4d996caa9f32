// Warns of panels that lie over each other and press as if they did not.
#include "output.hpp"
#include "overlaps.hpp"

namespace toile::run {

namespace {

class Overlaps : public Observer {
 public:
  explicit Overlaps(const OutputContext& context) : log_(context.log), timer_(context.timer) {}

  void end(const Record& record) override {
    const solve::Fields& fields = record.fields();
    const auto phase = timer_.phase("overlaps");
    for (const std::string& text : overlap_faults(record.scene(), fields, record.last())) log_.warn(text);
  }

 private:
  base::Log& log_;
  base::Timer& timer_;
};

}  // namespace

Output overlaps_output() {
  return {{}, [](const OutputContext& context) -> std::unique_ptr<Observer> {
            return std::make_unique<Overlaps>(context);
          }};
}

}  // namespace toile::run
