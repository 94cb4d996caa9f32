// history.h5: the global fields over the steps.
#include "output.hpp"
#include "toile/result/available.hpp"
#include "toile/result/history.hpp"
#include "toile/solve/output_fields.hpp"

namespace toile::run {

namespace {

const std::string history_name = "history.h5";

class History : public Observer {
 public:
  explicit History(std::shared_ptr<Folder> folder) : folder_(std::move(folder)) {}

  void start(const Record& record) override {
    if (record.reports().empty()) return;
    std::vector<std::vector<double>> rows;
    for (const solve::StepReport& report : record.reports()) rows.push_back(row_of(record, report));
    history_->restore(rows);
    folder_->add(history_name);
  }

  void step(const Record& record) override {
    const std::vector<double> row = row_of(record, record.last());
    history_->append(row);
    folder_->add(history_name);
  }

 private:
  /// Opens the file with the first one.
  std::vector<double> row_of(const Record& record, const solve::StepReport& report) {
    std::vector<result::FieldName> columns;
    std::vector<double> row;
    for (const solve::NamedField& field : solve::global_fields(record.scene().problem(), report)) {
      columns.push_back({field.name, field.unit});
      row.push_back(field.values.front());
    }
    if (history_ == nullptr) history_ = std::make_unique<result::History>(folder_->file(history_name), columns);
    return row;
  }

  std::shared_ptr<Folder> folder_;
  std::unique_ptr<result::History> history_;
};

}  // namespace

Output history_output() {
  return {{history_name}, [](const OutputContext& context) -> std::unique_ptr<Observer> {
            if (context.folder == nullptr || !result::files_available()) return nullptr;
            return std::make_unique<History>(context.folder);
          }};
}

}  // namespace toile::run
