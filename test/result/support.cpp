#include "support.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "toile/base/error.hpp"

namespace toile::result::test {
namespace {

mesh::Vec3 on_revolution(const Profile& radius, double height, double turn) {
  const double angle = 2.0 * M_PI * turn;
  return {radius(height) * std::cos(angle), radius(height) * std::sin(angle), height};
}

}  // namespace

mesh::Mesh tube(const Profile& radius, double first_height, double height, int around, int along) {
  mesh::Mesh mesh;
  mesh::Block block;
  block.name = "tube";
  block.material = "fabric";
  for (int j = 0; j <= along; ++j) {
    const double z = first_height + height * j / along;
    for (int i = 0; i <= around; ++i) {
      mesh.pattern.emplace_back(2.0 * M_PI * radius(z) * i / around, z);
      mesh.placed.push_back(on_revolution(radius, z, static_cast<double>(i % around) / around));
    }
  }
  const auto node = [&](int i, int j) { return j * (around + 1) + i; };
  for (int j = 0; j < along; ++j) {
    for (int i = 0; i < around; ++i) {
      for (const int corner : {node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)}) {
        block.connectivity.push_back(corner);
      }
    }
  }
  block.wale_angle.assign(static_cast<std::size_t>(around * along), M_PI / 2.0);
  block.position.assign(static_cast<std::size_t>(around * along), 0.5);
  for (int i = 0; i <= around; ++i) {
    mesh.edges["tube.bottom"].push_back(node(i, 0));
    mesh.edges["tube.top"].push_back(node(i, along));
  }
  mesh.blocks.push_back(block);
  return mesh;
}

std::vector<int> tied_by_place(const mesh::Mesh& mesh) {
  std::vector<int> tied(mesh.placed.size());
  for (const mesh::Block& block : mesh.blocks) {
    std::map<std::array<double, 3>, int> first;
    for (const int n : std::set<int>(block.connectivity.begin(), block.connectivity.end())) {
      const mesh::Vec3& x = mesh.placed[static_cast<std::size_t>(n)];
      tied[static_cast<std::size_t>(n)] = first.try_emplace({x.x(), x.y(), x.z()}, n).first->second;
    }
  }
  return tied;
}

body::TriangleMesh revolution(const Profile& radius, double first_height, double height, int around, int along) {
  body::TriangleMesh body;
  for (int j = 0; j <= along; ++j) {
    for (int i = 0; i < around; ++i) {
      body.vertices.push_back(
          on_revolution(radius, first_height + height * j / along, static_cast<double>(i) / around));
    }
  }
  for (int j = 0; j < along; ++j) {
    for (int i = 0; i < around; ++i) {
      const int next = (i + 1) % around;
      body.triangles.push_back({j * around + i, j * around + next, (j + 1) * around + next});
      body.triangles.push_back({j * around + i, (j + 1) * around + next, (j + 1) * around + i});
    }
  }
  return body;
}

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "toile-result-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) {
    throw std::runtime_error("no temporary folder");
  }
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string read_text(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

std::string input_error(const std::function<void()>& call) {
  try {
    call();
  } catch (const base::InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "no InputError was thrown";
  return {};
}

}  // namespace toile::result::test
