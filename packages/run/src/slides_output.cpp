// Warns of a garment that has not stayed where it was placed.
#include "output.hpp"
#include "slides.hpp"

namespace toile::run {

namespace {

class Slides : public Observer {
 public:
  explicit Slides(base::Log& log) : log_(log) {}

  void end(const Record& record) override {
    for (const std::string& text : parts_that_slid(record.scene().problem(), record.fields().position)) log_.warn(text);
  }

 private:
  base::Log& log_;
};

}  // namespace

Output slides_output() {
  return {{}, [](const OutputContext& context) -> std::unique_ptr<Observer> {
            return std::make_unique<Slides>(context.log);
          }};
}

}  // namespace toile::run
