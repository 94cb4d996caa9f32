#include <Tpetra_Core.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "body_input.hpp"
#include "commands.hpp"
#include "toile/base/error.hpp"
#include "toile/body/landmarks.hpp"
#include "toile/result/replace_file.hpp"

namespace toile::app {
namespace {

struct LandmarksArguments {
  BodyFileArguments body;
  std::string json;  ///< file; empty: none
};

void print(const body::Landmarks& landmarks) {
  std::vector<std::vector<std::string>> rows = {{"landmark", "x [mm]", "y [mm]", "z [mm]", "girth [mm]", "[cm]"}};
  for (const body::Landmark& l : landmarks.found) {
    rows.push_back({l.name, decimals(l.point.x(), 1), decimals(l.point.y(), 1), decimals(l.point.z(), 1)});
    if (l.girth > 0.0) {
      rows.back().push_back(decimals(l.girth, 1));
      rows.back().push_back(decimals(0.1 * l.girth, 1));
    }
  }
  std::cout << text_table(rows);
  for (const body::MissingLandmark& l : landmarks.missing)
    std::cout << "not found: " << l.name << ": " << l.reason << '\n';
  std::cout << std::flush;
  tell_warnings(landmarks);
}

void write_json(const body::Landmarks& landmarks, const std::string& file) {
  nlohmann::ordered_json json;
  json["unit"] = "mm";
  for (const body::Landmark& l : landmarks.found) {
    auto& entry = json["landmarks"][l.name];
    entry["point"] = {l.point.x(), l.point.y(), l.point.z()};
    if (l.girth > 0.0) {
      entry["girth"] = l.girth;
      entry["normal"] = {l.normal.x(), l.normal.y(), l.normal.z()};
    }
  }
  json["not found"] = nlohmann::ordered_json::object();
  for (const body::MissingLandmark& l : landmarks.missing) json["not found"][l.name] = l.reason;
  result::replace_file(file, json.dump(1) + "\n", "cannot write the landmarks '" + file + "': ");
}

int tell_landmarks(const LandmarksArguments& arguments) {
  if (Tpetra::getDefaultComm()->getSize() > 1)
    throw base::InputError("body landmarks runs on one rank; start it without mpirun");
  const body::Import import = read_body(arguments.body);
  const body::Landmarks landmarks = body::find_landmarks(import.mesh, arguments.body.file);
  print(landmarks);
  if (!arguments.json.empty()) write_json(landmarks, arguments.json);
  return static_cast<int>(base::ExitCode::success);
}

}  // namespace

void add_body_landmarks(CLI::App& program, Chosen& chosen) {
  const auto arguments = std::make_shared<LandmarksArguments>();
  CLI::App* command = body_command(program)->add_subcommand(
      "landmarks", "Find waist, bust points, armpits, ... of a body that looks towards -y, and their girths");
  add_body_file(command, arguments->body);
  command->add_option("--json", arguments->json, "Also write them to this file")->type_name("FILE");
  command->callback([arguments, &chosen] { chosen = [arguments] { return tell_landmarks(*arguments); }; });
}

}  // namespace toile::app
