#include "body/import_support.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <fstream>

#include "toile/base/error.hpp"
#include "toile/body/analytic.hpp"

namespace toile::test {

using namespace toile::body;

ImportOptions small() {
  ImportOptions options;
  options.least_height = 50.0;
  options.up_is_known = true;
  return options;
}

std::string message(const std::string& file, const ImportOptions& options) {
  try {
    import_body(file, options);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

TriangleMesh ball() {
  return ellipsoid(60.0, 60.0)->triangles(15.0);
}

TriangleMesh twins(const Vec3& shift) {
  const TriangleMesh one = ball();
  TriangleMesh two = one;
  const int n = static_cast<int>(one.vertices.size());
  for (const Vec3& v : one.vertices) two.vertices.push_back(v + shift);
  for (const auto& t : one.triangles) two.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  return two;
}

double volume(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    sum += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]])) / 6.0;
  }
  return sum;
}

std::string write_text(const std::string& name, const std::string& text) {
  std::string path = testing::TempDir() + "toile-import-" + name;
  std::ofstream(path) << text;
  return path;
}

}  // namespace toile::test
