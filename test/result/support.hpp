#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "toile/body/surface.hpp"
#include "toile/mesh/mesh.hpp"

namespace toile::result::test {

/// Radius (mm) at a height (mm) of a body of revolution about the z axis.
using Profile = std::function<double(double)>;

/// A panel named "tube" of quadrilaterals wrapped around the z axis, closed by coinciding nodes, normals outwards.
/// Edges "tube.bottom" and "tube.top". `first_height` and `height` in mm.
mesh::Mesh tube(const Profile& radius, double first_height, double height, int around, int along);

/// [node] the first node of each panel that lies at its place, as a closed seam ties them.
std::vector<int> tied_by_place(const mesh::Mesh& mesh);

/// Triangles of a body of revolution about the z axis, normals outwards, without end caps.
body::TriangleMesh revolution(const Profile& radius, double first_height, double height, int around, int along);

/// A new, empty folder for one test, removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

std::string read_text(const std::string& path);

/// Message of the InputError that `call` throws; a test failure and an empty text if it throws none.
std::string input_error(const std::function<void()>& call);

}  // namespace toile::result::test
