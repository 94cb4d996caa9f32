// Warns of panels that lie over each other and press as if they did not.
#include "output.hpp"
#include "overlaps.hpp"

namespace toile::run {

namespace {

class Overlaps : public Observer {
 public:
  explicit Overlaps(base::Log& log) : log_(log) {}

  void end(const Record& record) override {
    for (const std::string& text : overlap_faults(record.scene(), record.fields(), record.last())) log_.warn(text);
  }

 private:
  base::Log& log_;
};

}  // namespace

Output overlaps_output() {
  return {{}, [](const OutputContext& context) -> std::unique_ptr<Observer> {
            return std::make_unique<Overlaps>(context.log);
          }};
}

}  // namespace toile::run
