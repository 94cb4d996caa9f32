#include "landmark_places.hpp"

#include <Eigen/Geometry>
#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>
#include <functional>
#include <optional>

#include "toile/base/error.hpp"
#include "toile/body/body.hpp"
#include "toile/body/landmarks.hpp"

namespace toile::scene {
namespace {

using body::Vec3;
using Numbers = Teuchos::Array<double>;
using Names = Teuchos::Array<std::string>;
using Teuchos::ParameterList;

/// Line along which heights count.
struct Line {
  Vec3 point = Vec3::Zero();
  Vec3 direction = Vec3::UnitZ();
};

std::optional<Vec3> vector_in(const ParameterList& list, const std::string& name) {
  if (!list.isType<Numbers>(name) || list.get<Numbers>(name).size() != 3) return {};
  const auto& v = list.get<Numbers>(name);
  return Vec3(v[0], v[1], v[2]);
}

/// Replaces names in the lists that may hold them.
class Places {
 public:
  Places(ParameterList& scene, const base::Origins& origins) : scene_(scene), origins_(origins) {}

  void put() {
    in(scene_, "scene", "Body", [this](ParameterList& body, const std::string& path) {
      in(body, path, "Reach", [this](ParameterList& reach, const std::string& here) {
        points(reach, here, {"seed"});
        heights(reach, here, {"bottom", "top"}, Line());
      });
    });
    in(scene_, "scene", "Pattern", [this](ParameterList& pattern, const std::string& path) {
      in(pattern, path, "Placement",
         [this](ParameterList& placement, const std::string& here) { points(placement, here, {"origin"}); });
    });
    entries("Panels", [this](ParameterList& panel, const std::string& path) {
      in(panel, path, "Placement", [this](ParameterList& list, const std::string& here) { put_placement(list, here); });
    });
    entries("Supports",
            [this](ParameterList& support, const std::string& path) { points(support, path, {"axis point"}); });
    in(scene_, "scene", "Output", [this](ParameterList& output, const std::string& path) { put_output(output, path); });
  }

  base::Texts warnings() const { return landmarks_ ? landmarks_->warnings : base::Texts(); }

 private:
  using Visit = std::function<void(ParameterList&, const std::string& path)>;

  static void in(ParameterList& list, const std::string& path, const std::string& name, const Visit& visit) {
    if (list.isSublist(name)) visit(list.sublist(name), path + " > " + name);
  }
  static void each(ParameterList& list, const std::string& path, const Visit& visit) {
    for (auto item = list.begin(); item != list.end(); ++item) in(list, path, list.name(item), visit);
  }
  void entries(const std::string& name, const Visit& visit) {
    in(scene_, "scene", name, [&visit](ParameterList& list, const std::string& path) { each(list, path, visit); });
  }

  void put_placement(ParameterList& list, const std::string& path) {
    points(list, path, {"origin", "axis bottom", "axis top", "axis", "guide"});
    const std::string type = list.isType<std::string>("type") ? list.get<std::string>("type") : "";
    if (type != "wrap" && type != "free wrap") return;  // "from" of a guide is a place in the pattern
    const auto bottom = vector_in(list, "axis bottom"), top = vector_in(list, "axis top");
    std::optional<Line> line;
    if (bottom && top && *bottom != *top) line = Line{*bottom, (*top - *bottom).normalized()};
    heights(list, path, {"from", "to"}, line);
  }

  void put_output(ParameterList& output, const std::string& path) {
    points(output, path, {"axis point", "axis"});
    std::optional<Line> line = Line();
    if (output.isParameter("axis")) {
      line.reset();
    } else {
      if (const auto point = vector_in(output, "axis point")) line->point = *point;
      if (const auto direction = vector_in(output, "axis direction"); direction && !direction->isZero())
        line->direction = direction->normalized();
    }
    in(output, path, "Body points", [&](ParameterList& all, const std::string& here) {
      each(all, here, [&](ParameterList& point, const std::string& there) { points(point, there, {"at"}); });
    });
    in(output, path, "Lines", [&](ParameterList& all, const std::string& here) {
      each(all, here, [&](ParameterList& one, const std::string& there) {
        points(one, there, {"through", "at", "from", "to"});
        heights(one, there, {"height"}, line);
      });
    });
    in(output, path, "Levels", [&](ParameterList& levels, const std::string& here) {
      each(levels, here,
           [&](ParameterList& level, const std::string& there) { heights(level, there, {"height"}, line); });
    });
  }

  /// Each may be a landmark, or several of them one after the other.
  void points(ParameterList& list, const std::string& path, const base::Texts& names) {
    for (const std::string& name : names) {
      Names places;
      if (list.isType<std::string>(name)) places = Names(1, list.get<std::string>(name));
      if (list.isType<Names>(name)) places = list.get<Names>(name);
      if (places.empty()) continue;
      Numbers numbers;
      for (const std::string& place : places) {
        const Vec3 point = landmark(place, path, name).point;
        for (int i = 0; i < 3; ++i) numbers.push_back(point[i]);
      }
      list.set(name, numbers);
    }
  }

  /// Each may be a landmark; `line`: none where its axis is bent, or is not understood.
  void heights(ParameterList& list, const std::string& path, const base::Texts& names,
               const std::optional<Line>& line) {
    for (const std::string& name : names) {
      if (!list.isType<std::string>(name)) continue;
      const std::string place = list.get<std::string>(name);
      const body::Landmark found = landmark(place, path, name);
      if (!line)
        fail(path, name, place,
             "a landmark gives a height along a straight axis only; along this one give the number of mm");
      list.set(name, (found.point - line->point).dot(line->direction));
    }
  }

  body::Landmark landmark(const std::string& place, const std::string& path, const std::string& name) {
    if (!scene_.isSublist("Body")) fail(path, name, place, "the scene has no list \"Body\" with landmarks");
    if (!landmarks_) read_landmarks();
    try {
      return landmarks_->place(place);
    } catch (const base::InputError& error) {
      fail(path, name, place, error.what());
    }
  }

  void read_landmarks() {
    ParameterList only("scene");
    only.sublist("Body") = scene_.sublist("Body");
    only.sublist("Body").remove("Reach", false);
    landmarks_ = body::landmarks_of(
        base::validate(only, base::Spec("scene", "").list(body::body_spec()), origins_).list("Body"));
  }

  [[noreturn]] void fail(const std::string& path, const std::string& name, const std::string& place,
                         const std::string& problem) const {
    throw base::InputError(origins_.of(path + " > " + name) + ": " + path + ": parameter \"" + name + "\" = \"" +
                           place + "\": " + problem);
  }

  ParameterList& scene_;
  const base::Origins& origins_;
  std::optional<body::Landmarks> landmarks_;
};

}  // namespace

base::Texts put_landmarks(ParameterList& scene, base::Origins& origins) {
  Places places(scene, origins);
  places.put();
  return places.warnings();
}

}  // namespace toile::scene
