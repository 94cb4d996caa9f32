// drape.csv, shadow.csv: what a drapemeter tells of the fabric.
#include <algorithm>
#include <cstdio>

#include "table_output.hpp"
#include "toile/run/shadow.hpp"

namespace toile::run {

namespace {

const std::string drape_name = "drape.csv", shadow_name = "shadow.csv";

result::Table outline_of(const Shadow& shadow) {
  result::Table table{"", {}, {{{"angle", "degrees"}, {}}, {{"radius", "mm"}, shadow.outline}}};
  for (size_t k = 0; k < shadow.outline.size(); ++k)
    table.columns[0].values.push_back(360.0 * static_cast<double>(k) / static_cast<double>(shadow.outline.size()));
  return table;
}

class DrapemeterOutput : public Observer {
 public:
  explicit DrapemeterOutput(const OutputContext& context) : folder_(context.folder), log_(context.log) {}

  void end(const Record& record) override {
    const DrapeReading reading = read_drape(record.scene(), record.fields().position);
    const auto [least, most] = std::minmax_element(reading.shadow.outline.begin(), reading.shadow.outline.end());
    char text[200];
    std::snprintf(text, sizeof text,
                  "Drapemeter\n  drape coefficient %.4f, %d folds, outline of the shadow %.1f to %.1f mm\n",
                  reading.coefficient, reading.folds, *least, *most);
    log_.info(text);
    if (folder_ == nullptr) return;
    write(drape_name, {"",
                       {},
                       {{{"drape coefficient", ""}, {reading.coefficient}},
                        {{"folds", ""}, {static_cast<double>(reading.folds)}},
                        {{"area of the shadow", "mm^2"}, {reading.shadow.area}},
                        {{"least radius", "mm"}, {*least}},
                        {{"greatest radius", "mm"}, {*most}}}});
    write(shadow_name, outline_of(reading.shadow));
  }

 private:
  void write(const std::string& name, const result::Table& table) {
    result::write_csv(folder_->file(name), table);
    folder_->add(name);
  }

  std::shared_ptr<Folder> folder_;
  base::Log& log_;
};

}  // namespace

Output drapemeter_output() {
  return {{drape_name, shadow_name}, [](const OutputContext& context) -> std::unique_ptr<Observer> {
            if (!context.scene.output().drapemeter) return nullptr;
            return std::make_unique<DrapemeterOutput>(context);
          }};
}

}  // namespace toile::run
