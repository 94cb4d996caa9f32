// restart.h5: everything from which the run goes on after the last accepted step.
#include "output.hpp"
#include "restart_file.hpp"
#include "toile/result/available.hpp"

namespace toile::run {

namespace {

class Restart : public Observer {
 public:
  Restart(std::shared_ptr<Folder> folder, base::Timer& timer) : folder_(std::move(folder)), timer_(timer) {}

  void start(const Record& record) override {
    if (!record.reports().empty()) folder_->add(restart_name);
  }

  void step(const Record& record) override {
    const auto phase = timer_.phase("restart");
    write_restart(folder_->file(restart_name), record);
    folder_->add(restart_name);
  }

  std::string failure(const Record& record) override {
    return record.reports().empty() ? std::string() : " in " + folder_->file(restart_name);
  }

 private:
  std::shared_ptr<Folder> folder_;
  base::Timer& timer_;
};

}  // namespace

Output restart_output() {
  return {{restart_name}, [](const OutputContext& context) -> std::unique_ptr<Observer> {
            if (context.folder == nullptr || !result::files_available()) return nullptr;
            return std::make_unique<Restart>(context.folder, context.timer);
          }};
}

}  // namespace toile::run
