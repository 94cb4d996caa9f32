// The stations of pressure-lines.csv.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

namespace toile::test {

struct Station {
  std::string line;
  double length, x, y, z, kpa, mmhg, error_kpa, error_mmhg, gap;  ///< gap: NaN where no fabric is
};

inline std::vector<Station> line_stations(const std::string& csv) {
  std::istringstream rows(csv);
  std::string row, cell;
  std::getline(rows, row);
  EXPECT_EQ(row,
            "line,arc length [mm],x [mm],y [mm],z [mm],pressure [kPa],pressure [mmHg],its error [kPa],its error "
            "[mmHg],gap [mm]");
  std::vector<Station> stations;
  while (std::getline(rows, row)) {
    std::istringstream cells(row);
    Station s{};
    std::getline(cells, s.line, ',');
    for (double* value : {&s.length, &s.x, &s.y, &s.z, &s.kpa, &s.mmhg, &s.error_kpa, &s.error_mmhg, &s.gap}) {
      cell.clear();
      std::getline(cells, cell, ',');
      *value = cell.empty() ? NAN : std::strtod(cell.c_str(), nullptr);
    }
    stations.push_back(s);
  }
  return stations;
}

}  // namespace toile::test
