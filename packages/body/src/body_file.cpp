#include "body_file.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "toile/base/error.hpp"

namespace toile::body {
namespace {

constexpr std::uintmax_t largest_file = 2000000000;  ///< bytes: some 20 million facets

std::string contents(const std::string& file) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (!fs::is_regular_file(file, error)) {
    throw base::InputError(
        file + (fs::exists(file, error) ? ": is not a file that can hold a body" : ": there is no such body file"));
  }
  const std::uintmax_t size = fs::file_size(file, error);
  if (!error && size > largest_file) {
    throw base::InputError(file + ": has " + std::to_string(size / 1000000) +
                           " MB, at most 2000 MB are read: reduce the number of facets");
  }
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream.good() && !stream.eof()) {
    throw base::InputError(file + ": cannot be read; is it allowed to?");
  }
  return text;
}

}  // namespace

void SoupBuilder::add_polygon(long place, const std::vector<long>& corners) {
  std::vector<std::size_t> polygon;
  polygon.reserve(corners.size());
  for (const long corner : corners) {
    polygon.push_back(static_cast<std::size_t>(corner - first_));  // one below the first becomes a huge number
  }
  soup_.polygons.push_back(std::move(polygon));
  places_.push_back(place);
}

PolygonSoup SoupBuilder::finish() {
  const auto fail = [this](std::size_t i, const std::string& what) {
    throw base::InputError(file_ + ": " + place_ + " " + std::to_string(places_[i]) + ": " + what);
  };
  for (std::size_t i = 0; i < soup_.polygons.size(); ++i) {
    const auto& polygon = soup_.polygons[i];
    if (polygon.size() < 3) {
      fail(i, "a facet needs three corners or more, found " + std::to_string(polygon.size()));
    }
    for (const std::size_t corner : polygon) {
      if (corner >= soup_.points.size()) {
        fail(i, "a facet has the corner " + std::to_string(static_cast<long>(corner) + first_) + ", but the file has " +
                    std::to_string(points()) + " vertices, counted from " + std::to_string(first_));
      }
    }
  }
  if (soup_.polygons.empty()) {
    throw base::InputError(file_ + ": holds no facets (" + std::to_string(points()) +
                           " vertices): a body needs a surface, not points or lines alone");
  }
  return std::move(soup_);
}

BodyFile read_body_file(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  using Reader = BodyFile (*)(const std::string&, std::string_view);
  Reader reader = nullptr;
  for (const auto& [ending, function] :
       {std::pair<const char*, Reader>{".obj", read_obj}, {".stl", read_stl}, {".ply", read_ply}, {".off", read_off}}) {
    reader = extension == ending ? function : reader;
  }
  const std::string text = contents(file);
  if (reader == nullptr) {
    throw base::InputError(file + ": a body file must end in .obj, .stl, .ply or .off, found '" + extension + "'");
  }
  if (text.empty()) {
    throw base::InputError(file + ": is empty");
  }
  return reader(file, text);
}

}  // namespace toile::body
