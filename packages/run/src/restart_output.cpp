// restart.h5: the last accepted state.
#include "output.hpp"
#include "toile/result/available.hpp"
#include "toile/result/state_file.hpp"

namespace toile::run {

namespace {

const std::string restart_name = "restart.h5";

result::StateData data_of(const Record& record) {
  const solve::State& state = record.state();
  result::StateData data;
  std::vector<double>& position = data.reals["position"];
  for (const solve::Vec3& p : state.position) position.insert(position.end(), p.data(), p.data() + 3);
  data.reals["contact_force"] = state.contact_force;
  data.reals["offset"] = state.offset;
  if (!state.frame.empty()) {
    for (const solve::Frame& frame : state.frame)
      data.reals["director_frame"].insert(data.reals["director_frame"].end(), frame.data(), frame.data() + 9);
    for (const auto& rotation : state.rotation)
      data.reals["rotation"].insert(data.reals["rotation"].end(), rotation.begin(), rotation.end());
  }
  data.reals["seam_load_parameter"] = {state.seam, state.load, record.last().parameter};
  data.integers["step"] = {record.last().step};
  data.metadata["stage"] = record.last().stage;
  data.metadata["title"] = record.scene().title();
  return data;
}

class Restart : public Observer {
 public:
  explicit Restart(std::shared_ptr<Folder> folder) : folder_(std::move(folder)) {}

  void step(const Record& record) override {
    result::write_state(folder_->file(restart_name), data_of(record));
    folder_->add(restart_name);
  }

  std::string failure(const Record& record) override {
    return record.reports().empty() ? std::string() : " in " + folder_->file(restart_name);
  }

 private:
  std::shared_ptr<Folder> folder_;
};

}  // namespace

Output restart_output() {
  return {{restart_name}, [](const OutputContext& context) -> std::unique_ptr<Observer> {
            if (context.folder == nullptr || !result::files_available()) return nullptr;
            return std::make_unique<Restart>(context.folder);
          }};
}

}  // namespace toile::run
