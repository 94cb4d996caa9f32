#include "toile/body/landmarks.hpp"

#include <gmock/gmock.h>

#include <Eigen/Geometry>

#include "body/figures.hpp"
#include "toile/base/error.hpp"
#include "toile/body/import.hpp"
#include "toile/body/mannequin.hpp"

namespace toile::test {
namespace {

using body::Landmark;
using body::Landmarks;
using body::Vec3;
using ::testing::HasSubstr;

const body::TriangleMesh& shipped_body() {
  static const body::TriangleMesh mesh = body::import_body(TOILE_SOURCE_DIR "/input/bodies/female_body.obj", {}).mesh;
  return mesh;
}

const Landmarks& shipped_landmarks() {
  static const Landmarks landmarks = body::find_landmarks(shipped_body());
  return landmarks;
}

body::TriangleMesh moved(const std::function<Vec3(const Vec3&)>& move) {
  body::TriangleMesh mesh = shipped_body();
  for (Vec3& v : mesh.vertices) v = move(v);
  return mesh;
}

std::string refusal(const std::function<void()>& action) {
  try {
    action();
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "nothing was refused";
}

// Of the shipped body every landmark is found, at the heights and with the girths to which it was made: within 10 mm
// and 1 %.
TEST(Landmarks, ShippedBody) {
  const Landmarks& landmarks = shipped_landmarks();
  EXPECT_TRUE(landmarks.missing.empty());
  EXPECT_EQ(landmarks.found.size(), body::landmark_names().size());
  struct Level {
    const char* name;
    double height, girth;
  };
  for (const Level& level : {Level{"bust", 1163.41, 830.04},
                             {"waist", 1020.68, 639.72},
                             {"hip", 828.97, 898.79},
                             {"left thigh", 727.60, 519.98},
                             {"right thigh", 727.60, 519.98},
                             {"left knee", 423.44, 312.43},
                             {"right knee", 423.44, 312.43},
                             {"left calf", 333.91, 340.06},
                             {"left ankle", 114.35, 204.99}}) {
    SCOPED_TRACE(level.name);
    EXPECT_NEAR(landmarks.at(level.name).point.z(), level.height, 10.0);
    EXPECT_NEAR(landmarks.at(level.name).girth / level.girth, 1.0, 0.01);
  }
  EXPECT_NEAR(landmarks.at("crotch").point.z(), 742.60, 10.0);
  EXPECT_NEAR(landmarks.at("crown").point.z(), 1580.0, 1e-3);
}

// The body is symmetric, and so are its landmarks; they stand where an anatomist looks for them.
TEST(Landmarks, Symmetric) {
  const Landmarks& landmarks = shipped_landmarks();
  for (const Landmark& left : landmarks.found) {
    if (left.name.rfind("left ", 0) != 0) continue;
    const Landmark& right = landmarks.at("right " + left.name.substr(5));
    SCOPED_TRACE(left.name);
    EXPECT_GT(left.point.x(), 50.0);
    EXPECT_LT((left.point - Vec3(-right.point.x(), right.point.y(), right.point.z())).norm(), 1.0);
    EXPECT_NEAR(left.girth, right.girth, 0.5);
  }
  const auto z = [&](const char* name) { return landmarks.at(name).point.z(); };
  const std::vector<const char*> downwards = {"crown", "neck", "shoulder", "armpit", "bust", "underbust",
                                              "waist", "hip",  "crotch",   "knee",   "calf", "ankle"};
  for (std::size_t i = 0; i + 1 < downwards.size(); ++i) EXPECT_GT(z(downwards[i]), z(downwards[i + 1]));
  EXPECT_LT(landmarks.at("left bust point").point.y(), landmarks.at("bust").point.y() - 80.0);
  EXPECT_GT(landmarks.at("left shoulder blade").point.y(), 50.0);
  EXPECT_LT(landmarks.at("left elbow").point.x(), landmarks.at("left wrist").point.x());
}

// Nothing depends on the size of the body, nor on where it stands.
TEST(Landmarks, FollowTheBody) {
  const Landmarks larger =
      body::find_landmarks(moved([](const Vec3& v) { return Vec3(1.12 * v + Vec3(300, 50, -20)); }));
  EXPECT_TRUE(larger.missing.empty());
  for (const Landmark& l : larger.found) {
    const Landmark& of_shipped = shipped_landmarks().at(l.name);
    SCOPED_TRACE(l.name);
    EXPECT_LT((l.point - (1.12 * of_shipped.point + Vec3(300, 50, -20))).norm(), 1e-3);
    EXPECT_NEAR(l.girth, 1.12 * of_shipped.girth, 1e-3);
  }
}

// A body that looks aside has its landmarks where they are on the one that looks ahead, turned with it.
TEST(Landmarks, TurnWithTheBody) {
  for (const double degrees : {-5.0, 2.0, 7.0, 30.0}) {
    const Eigen::AngleAxisd turn(degrees * M_PI / 180.0, Vec3::UnitZ());
    const Landmarks turned = body::find_landmarks(moved([&turn](const Vec3& v) { return Vec3(turn * v); }));
    EXPECT_TRUE(turned.missing.empty());
    for (const Landmark& l : turned.found) {
      const Landmark& of_shipped = shipped_landmarks().at(l.name);
      SCOPED_TRACE(l.name + " at " + std::to_string(degrees));
      EXPECT_LT((l.point - turn * of_shipped.point).norm(), 1.0);
      EXPECT_LT((l.normal - turn * of_shipped.normal).norm(), 2e-3);
      EXPECT_NEAR(l.girth, of_shipped.girth, 0.5);
    }
  }
}

// A body that looks sideways, stands on its head or lies is refused with what to do.
TEST(Landmarks, OtherStance) {
  EXPECT_THAT(refusal([] { body::find_landmarks(moved([](const Vec3& v) { return Vec3(v.y(), -v.x(), v.z()); })); }),
              HasSubstr("the trunk of the body is wider along y than along x, as if it looked sideways; landmarks are "
                        "found on a body that looks towards -y, with z up: turn it about z"));
  EXPECT_THAT(refusal([] { body::find_landmarks(moved([](const Vec3& v) { return Vec3(v.x(), -v.y(), -v.z()); })); }),
              HasSubstr("the body stands on its head"));
  EXPECT_THAT(refusal([] { body::find_landmarks(moved([](const Vec3& v) { return Vec3(v.x(), v.z(), -v.y()); })); }),
              HasSubstr("the body is longer along y (1580 mm) than it is high (382.2 mm), as if it lay"));
}

// A body whose trunk is as deep as it is wide is taken to look towards -y, and that is said; of another it is not.
TEST(Landmarks, RoundTrunk) {
  EXPECT_TRUE(shipped_landmarks().warnings.empty());
  const Landmarks round = body::find_landmarks(moved([](const Vec3& v) { return Vec3(v.x(), 1.55 * v.y(), v.z()); }));
  ASSERT_EQ(round.warnings.size(), 1u);
  EXPECT_THAT(round.warnings.front(), HasSubstr("which way it looks cannot be told"));
  EXPECT_GT(round.at("left bust point").point.x(), 0.0);
  EXPECT_LT(round.at("left bust point").point.y(), round.at("left shoulder blade").point.y());
}

// A body that looks elsewhere is refused with where its feet point.
TEST(Landmarks, OtherFront) {
  EXPECT_THAT(refusal([] { body::find_landmarks(moved([](const Vec3& v) { return Vec3(-v.x(), -v.y(), v.z()); })); }),
              HasSubstr("the feet of the body point towards +y; landmarks are found on a body that looks towards -y"));
}

// A mannequin has no feet, so nothing refuses one that looks backwards: that nothing stands out in front of its chest
// is said.
TEST(Landmarks, BackwardsWithoutFeet) {
  body::TriangleMesh mannequin = body::make_mannequin(shipped_body(), body::complete_measurements({}), {}).mesh;
  EXPECT_TRUE(body::find_landmarks(mannequin).warnings.empty());
  for (Vec3& v : mannequin.vertices) v = Vec3(-v.x(), -v.y(), v.z());
  const Landmarks backwards = body::find_landmarks(mannequin);
  ASSERT_EQ(backwards.warnings.size(), 1u);
  EXPECT_THAT(backwards.warnings.front(), HasSubstr("does it look towards +y?"));
}

// Of a trunk without legs, arms and head each landmark is missing with its own reason.
TEST(Landmarks, WithoutLimbs) {
  std::vector<Vec3> outline;
  for (int i = 0; i < 36; ++i)
    outline.emplace_back(150.0 * std::cos(M_PI * i / 18.0), 100.0 * std::sin(M_PI * i / 18.0), 0.0);
  const Landmarks landmarks = body::find_landmarks(closed_tube(outline, 600.0));
  EXPECT_TRUE(landmarks.found.empty());
  EXPECT_EQ(landmarks.missing.size(), body::landmark_names().size());
  const auto reason = [&](const char* name) { return refusal([&] { landmarks.at(name); }); };
  EXPECT_THAT(reason("crotch"),
              HasSubstr("\"crotch\" was not found on the body: no height was found at which the trunk "
                        "parts into two legs"));
  EXPECT_THAT(reason("left knee"), HasSubstr("the crotch, from which a leg goes down, was not found"));
  EXPECT_THAT(reason("left armpit"), HasSubstr("no height was found at which an arm leaves the trunk"));
  EXPECT_THAT(reason("neck"), HasSubstr("nothing tells that this is a human body"));
  EXPECT_THAT(reason("waist"), HasSubstr("neither both armpits nor the neck were found"));
  EXPECT_THAT(reason("wrist"), HasSubstr("it is half way between left and right, and the left one was not found"));
}

// A place is a landmark or so many mm above or below one; anything else is refused with what is near.
TEST(Landmarks, Places) {
  const Landmarks& landmarks = shipped_landmarks();
  const double waist = landmarks.at("waist").point.z();
  EXPECT_EQ(landmarks.place("waist").point.z(), waist);
  EXPECT_EQ(landmarks.place("waist line").point.z(), waist);
  EXPECT_EQ(landmarks.place("waist + 30").point.z(), waist + 30.0);
  EXPECT_EQ(landmarks.place("waist-12.5").point.z(), waist - 12.5);
  EXPECT_THAT(refusal([&] { landmarks.place("wiast"); }),
              HasSubstr("no landmark is named \"wiast\"; did you mean \"waist\"? Valid here: crown, neck"));
  for (const char* text : {"waist +", "waist + far", "waist + 1 2", "waist + nan", "waist + -3"})
    EXPECT_THAT(refusal([&] { landmarks.place(text); }), HasSubstr("behind the landmark stands + or -")) << text;
}

}  // namespace
}  // namespace toile::test
