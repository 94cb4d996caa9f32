// What is good to know of a run and what limits the trust in it, whether or not it reached its end.
#include "output.hpp"

namespace toile::run {

namespace {

class Notes : public Observer {
 public:
  explicit Notes(base::Log& log) : log_(log) {}

  void end(const Record& record) override { tell(record); }
  std::string failure(const Record& record) override {
    tell(record);
    return {};
  }

 private:
  void tell(const Record& record) {
    for (const std::string& note : record.notes()) log_.info("note: " + note);
    for (const std::string& warning : record.warnings()) log_.warn(warning);
  }

  base::Log& log_;
};

}  // namespace

Output notes_output() {
  return {{}, [](const OutputContext& context) -> std::unique_ptr<Observer> {
            return std::make_unique<Notes>(context.log);
          }};
}

}  // namespace toile::run
