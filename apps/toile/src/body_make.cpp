#include <Tpetra_Core.hpp>
#include <cmath>
#include <iostream>
#include <memory>
#include <sstream>

#include "body_input.hpp"
#include "commands.hpp"
#include "toile/base/error.hpp"
#include "toile/body/mannequin.hpp"
#include "toile/result/replace_file.hpp"

namespace toile::app {
namespace {

constexpr double mm_per_cm = 10.0;

struct MakeArguments {
  std::map<std::string, double> given;  ///< cm
  std::string from = TOILE_MANNEQUIN_BODY;
  std::string output = "mannequin.obj";
  double arms = std::numeric_limits<double>::quiet_NaN();  ///< degrees below the level
  double edge = 10.0;                                      ///< mm
};

std::string option_of(std::string name) {
  for (char& letter : name)
    if (letter == ' ') letter = '-';
  return "--" + name;
}

void print(const body::Mannequin& mannequin) {
  std::vector<std::vector<std::string>> rows = {{"measurement", "wanted [cm]", "reached [cm]", "error", ""}};
  for (const body::Measurement& m : mannequin.measurements)
    rows.push_back({m.name, decimals(m.value / mm_per_cm, 2), decimals(m.reached / mm_per_cm, 2),
                    decimals(100.0 * (m.reached / m.value - 1.0), 2) + " %", m.source});
  std::cout << text_table(rows) << "arms " << decimals(mannequin.arm_angle, 1) << " degrees below the level, "
            << mannequin.mesh.vertices.size() << " vertices, fitted in " << mannequin.rounds << " rounds\n";
}

std::string obj_of(const body::Mannequin& mannequin) {
  std::ostringstream out;
  out << "# Mannequin made by toile body make; mm, z up, front towards -y, floor at z = 0\n#";
  for (const body::Measurement& m : mannequin.measurements)
    out << ' ' << m.name << ' ' << decimals(m.reached, 1) << ';';
  out << '\n' << std::fixed;
  out.precision(4);
  for (const body::Vec3& v : mannequin.mesh.vertices) out << "v " << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
  for (const auto& t : mannequin.mesh.triangles) out << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
  return out.str();
}

int make_body(const MakeArguments& arguments) {
  if (Tpetra::getDefaultComm()->getSize() > 1)
    throw base::InputError("body make runs on one rank; start it without mpirun");
  const std::string failure = "cannot write the body '" + arguments.output + "': ";
  result::check_replaceable(arguments.output, failure);
  if (arguments.output.size() < 4 || arguments.output.substr(arguments.output.size() - 4) != ".obj")
    throw base::InputError(failure + "the file is written as OBJ, so its name ends in .obj");
  std::map<std::string, double> given;
  for (const auto& [name, value] : arguments.given) given[name] = mm_per_cm * value;
  const auto measurements = body::complete_measurements(given);
  body::ImportOptions import;
  body::MannequinOptions options;
  options.edge = arguments.edge;
  if (!std::isnan(arguments.arms)) options.arm_angle = arguments.arms;
  const body::Mannequin mannequin =
      body::make_mannequin(body::import_body(arguments.from, import).mesh, measurements, options);
  print(mannequin);
  result::replace_file(arguments.output, obj_of(mannequin), failure);
  std::cout << "wrote " << arguments.output << std::endl;
  return static_cast<int>(base::ExitCode::success);
}

}  // namespace

void add_body_make(CLI::App& program, Chosen& chosen) {
  const auto arguments = std::make_shared<MakeArguments>();
  CLI::App* command = body_command(program)->add_subcommand(
      "make", "Make a mannequin from measurements in cm: a body without head, hands and feet");
  const auto defaults = body::complete_measurements({});
  for (const body::Measurement& m : defaults)
    command
        ->add_option_function<double>(
            option_of(m.name), [arguments, name = m.name](double value) { arguments->given[name] = value; },
            (m.name == "height"           ? "Height of the body with its head and feet"
             : m.name == "shoulder width" ? "Distance of the shoulder points"
                                          : "Tape girth at the " + m.name) +
                std::string(" (default ") + decimals(m.value / mm_per_cm, 1) + ")")
        ->type_name("CM");
  command
      ->add_option("--arms", arguments->arms,
                   "Angle of the upper arms below the level, degrees (default: as the "
                   "body holds them)")
      ->type_name("DEGREES");
  command->add_option("--edge", arguments->edge, "Edge length of the facets, mm")->check(CLI::Range(4.0, 25.0));
  command->add_option("--from", arguments->from, "Body to change, standing, with head, hands and feet, in mm")
      ->type_name("FILE");
  command->add_option("--output", arguments->output, "OBJ file to write")->type_name("FILE");
  command->callback([arguments, &chosen] { chosen = [arguments] { return make_body(*arguments); }; });
}

}  // namespace toile::app
