// The files of the first step took the places of older ones; the others of the older run do not belong to them.
#include "output.hpp"

namespace toile::run {

namespace {

class OlderFiles : public Observer {
 public:
  explicit OlderFiles(std::shared_ptr<Folder> folder) : folder_(std::move(folder)) {}

  void step(const Record& record) override {
    if (record.reports().size() == 1) folder_->remove_older();
  }

 private:
  std::shared_ptr<Folder> folder_;
};

}  // namespace

Output older_files_output() {
  return {{}, [](const OutputContext& context) -> std::unique_ptr<Observer> {
            if (context.folder == nullptr) return nullptr;
            return std::make_unique<OlderFiles>(context.folder);
          }};
}

}  // namespace toile::run
