#include "restart_file.hpp"

#include <algorithm>
#include <filesystem>

#include "toile/base/error.hpp"
#include "toile/result/state_file.hpp"

namespace toile::run {

namespace {

// What is not of the checkpoint: of the scene, and of the record.
constexpr char end_of_record = '\x1e', end_of_name = '\x1f';
const std::string scene_values = "scene values", scene_stages = "scene stages", scene_figure = "scene figure ",
                  points_name = "record points", distances_name = "record distances";

void put_fingerprint(const scene::Fingerprint& fingerprint, result::StateData& data) {
  std::string& values = data.metadata[scene_values];
  for (const auto& [path, value] : fingerprint.values) values += path + end_of_name + value + end_of_record;
  std::string& stages = data.metadata[scene_stages];
  for (const std::string& stage : fingerprint.stages) stages += stage + end_of_record;
  for (const auto& [name, figures] : fingerprint.figures) data.reals[scene_figure + name] = figures;
}

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  for (size_t from = 0, to = 0; (to = text.find(end_of_record, from)) != std::string::npos; from = to + 1)
    parts.push_back(text.substr(from, to - from));
  return parts;
}

scene::Fingerprint fingerprint_of(const result::StateData& data) {
  scene::Fingerprint found;
  for (const std::string& entry : split(data.metadata.at(scene_values))) {
    const size_t middle = entry.find(end_of_name);
    found.values[entry.substr(0, middle)] = entry.substr(std::min(middle + 1, entry.size()));
  }
  found.stages = split(data.metadata.at(scene_stages));
  for (const auto& [name, figures] : data.reals)
    if (name.compare(0, scene_figure.size(), scene_figure) == 0)
      found.figures[name.substr(scene_figure.size())] = figures;
  return found;
}

/// Of the positions at each step; none are kept that the scene did not ask for.
void put_record(const Record& record, result::StateData& data) {
  std::vector<double>& points = data.reals[points_name];
  for (const std::vector<solve::Vec3>& point : record.points())
    for (const solve::Vec3& u : point) points.insert(points.end(), u.data(), u.data() + 3);
  std::vector<double>& distances = data.reals[distances_name];
  for (const std::vector<double>& distance : record.distances())
    distances.insert(distances.end(), distance.begin(), distance.end());
}

[[noreturn]] void refuse_differences(const std::string& file, const std::vector<std::string>& found) {
  constexpr size_t most = 8;
  std::string text = "the run cannot go on from " + file + ", which is of another scene:";
  for (size_t i = 0; i < std::min(most, found.size()); ++i) text += "\n  " + found[i];
  if (found.size() > most) text += "\n  and " + std::to_string(found.size() - most) + " more";
  throw base::InputError(text + "\nGive the scene back what it had, or run it without --restart: from its start.");
}

void check_scene(const std::string& file, const result::StateData& data, const solve::Checkpoint& checkpoint,
                 const Record& record) {
  const bool finished = checkpoint.stage.progress.phase == solve::StagePhase::finished;
  const auto found = scene::differences(fingerprint_of(data), record.fingerprint(), checkpoint.stage.index, finished);
  if (!found.empty()) refuse_differences(file, found);
}

}  // namespace

void write_restart(const std::string& file, const Record& record) {
  solve::CheckpointArrays arrays = to_arrays(record.checkpoint());
  result::StateData data{std::move(arrays.reals), std::move(arrays.integers), std::move(arrays.texts)};
  put_fingerprint(record.fingerprint(), data);
  put_record(record, data);
  result::write_state(file, data);
}

void read_restart(const std::string& file, Record& record) {
  if (!std::filesystem::exists(file))
    throw base::InputError("there is no " + file +
                           " to go on from; run the scene without --restart, which starts at its beginning");
  const result::StateData data = result::read_state(file);
  const std::string failure = "cannot read the state file '" + file + "': ";
  if (data.metadata.count(scene_values) == 0 || data.metadata.count(scene_stages) == 0 ||
      data.reals.count(points_name) == 0 || data.reals.count(distances_name) == 0)
    throw base::InputError(failure + "it is no state of a run");
  solve::Checkpoint checkpoint = solve::from_arrays({data.reals, data.integers, data.metadata});
  check_scene(file, data, checkpoint, record);
  const size_t steps = checkpoint.reports.size();
  const std::vector<double>&point_values = data.reals.at(points_name), &distance_values = data.reals.at(distances_name);
  std::vector<std::vector<solve::Vec3>> points(record.points().size());
  std::vector<std::vector<double>> distances(record.distances().size());
  if (point_values.size() != 3 * steps * points.size() || distance_values.size() != steps * distances.size())
    throw base::InputError("the run cannot go on from " + file +
                           ": the scene asks for other points or distances than it did before (list \"Output\")");
  for (size_t i = 0; i < points.size(); ++i)
    for (size_t step = 0; step < steps; ++step) points[i].emplace_back(&point_values[3 * (i * steps + step)]);
  for (size_t i = 0; i < distances.size(); ++i)
    distances[i].assign(distance_values.begin() + static_cast<std::ptrdiff_t>(i * steps),
                        distance_values.begin() + static_cast<std::ptrdiff_t>((i + 1) * steps));
  record.resume(std::move(checkpoint), std::move(points), std::move(distances));
}

}  // namespace toile::run
