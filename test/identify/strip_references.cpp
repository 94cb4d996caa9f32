#include "strip_references.hpp"

#include <fstream>
#include <sstream>

namespace toile::identify::test {

std::vector<StripReference> strip_references() {
  constexpr double section = 50.0;
  std::ifstream file(TOILE_SOURCE_DIR "/test/data/plane_stress/strips.csv");
  std::vector<StripReference> all;
  for (std::string line; std::getline(file, line);) {
    if (line[0] == '#' || line.rfind("material", 0) == 0) continue;
    std::istringstream cells(line);
    std::string material, cell;
    std::getline(cells, material, ',');
    std::vector<double> number;
    while (std::getline(cells, cell, ',')) number.push_back(std::stod(cell));
    if (all.empty() || all.back().material != material || all.back().angle != number[0])
      all.push_back({material, number[0], {}, {}});
    all.back().stretch.push_back(number[1]);
    all.back().stress.push_back(number[2] / section);
  }
  return all;
}

}  // namespace toile::identify::test
