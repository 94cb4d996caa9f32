#include "toile/run/outputs.hpp"

#include "alike.hpp"
#include "exodus_output.hpp"
#include "output.hpp"
#include "table_output.hpp"

namespace toile::run {

// Every output, in the order in which they are told of an event: each is a function NAME_output() in a source of its
// own. What is drawn or said at the end comes after what it speaks of.
#define TOILE_OUTPUTS(OUTPUT) \
  OUTPUT(progress)            \
  OUTPUT(notes)               \
  OUTPUT(exodus)              \
  OUTPUT(history)             \
  OUTPUT(restart)             \
  OUTPUT(older_files)         \
  OUTPUT(reactions)           \
  OUTPUT(body_force)          \
  OUTPUT(points)              \
  OUTPUT(point_pressures)     \
  OUTPUT(distances)           \
  OUTPUT(force_curves)        \
  OUTPUT(torques)             \
  OUTPUT(pressure)            \
  OUTPUT(pressure_lines)      \
  OUTPUT(compression_class)   \
  OUTPUT(testers)             \
  OUTPUT(drapemeter)          \
  OUTPUT(field_warnings)      \
  OUTPUT(crossed_planes)      \
  OUTPUT(crossing_warnings)   \
  OUTPUT(crossings)           \
  OUTPUT(overlaps)            \
  OUTPUT(slides)              \
  OUTPUT(figures)             \
  OUTPUT(summary)             \
  OUTPUT(findings)            \
  OUTPUT(run_record)          \
  OUTPUT(checks)

#define TOILE_DECLARE(name) Output name##_output();
TOILE_OUTPUTS(TOILE_DECLARE)

namespace {

std::vector<Output> registry() {
#define TOILE_CALL(name) name##_output(),
  return {TOILE_OUTPUTS(TOILE_CALL)};
}

}  // namespace

std::vector<std::string> output_files() {
  std::vector<std::string> files = plot_files("pressure-compared");  // of toile compare
  files.emplace_back("accuracy.csv");                                // of several runs (run_to_accuracy)
  for (const Output& output : registry()) files.insert(files.end(), output.files.begin(), output.files.end());
  return files;
}

void add_outputs(Session& session, const OutputOptions& options) {
  session.scene().check_drape();
  const bool writes = !options.folder.empty();
  if (writes) check_names(session.scene(), session.list());
  on_first_rank([&] {
    const auto folder = writes ? std::make_shared<Folder>(options.folder, output_files(), options.pictures) : nullptr;
    const OutputContext context{session.scene(), session.log(), session.timer(), folder, options.heartbeat};
    for (const Output& output : registry())
      if (auto observer = output.make(context)) session.add(std::move(observer));
  });
}

void write_start(Session& session, const std::string& folder) {
  check_names(session.scene(), session.list());
  on_first_rank([&] { write_start(session.record(), Folder(folder, output_files())); });
}

}  // namespace toile::run
