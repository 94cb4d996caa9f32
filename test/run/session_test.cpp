#include "toile/run/session.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <Teuchos_ParameterList.hpp>
#include <Tpetra_Core.hpp>
#include <filesystem>
#include <fstream>

#include "scene/lists.hpp"
#include "toile/base/error.hpp"

namespace toile::run {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A strip that is pulled to its length and a half in one stage of at most so many steps, of which it needs four.
Teuchos::ParameterList pulled(int most_steps = 10) {
  Teuchos::ParameterList scene = scene::test::flat_scene();
  scene.sublist("Supports").sublist("bottom").set("hold", std::string("xyz"));
  scene::test::add_support(scene, "top", "tube.top");
  scene.sublist("Supports").sublist("top").set("hold", std::string("xyz")).set("move by", test::reals({0, 50, 0}));
  scene.remove("Stages");
  scene.sublist("Stages")
      .sublist("pull")
      .set("type", std::string("load"))
      .set("largest step", 0.25)
      .set("most steps", most_steps);
  return scene;
}

/// Notes what it is told, and throws where it is to.
class Listener : public Observer {
 public:
  explicit Listener(std::vector<std::string>& heard, std::string throws_at = "", bool everywhere = true)
      : heard_(heard), throws_at_(std::move(throws_at)), everywhere_(everywhere) {}

  bool on_every_rank() const override { return everywhere_; }
  void start(const Record&) override { hear("start"); }
  void start_stage(const Record&, const solve::StageOptions& stage) override { hear("begin " + stage.name); }
  void iteration(const Record&, const solve::IterationReport&) override { hear("iteration"); }
  void step(const Record& record) override { hear("step " + std::to_string(record.reports().size())); }
  void end_stage(const Record&, const solve::StageOptions& stage) override { hear("end " + stage.name); }
  void end(const Record&) override { hear("end"); }
  std::string failure(const Record&) override {
    hear("failure");
    return " is kept here";
  }

 private:
  void hear(const std::string& what) {
    if (heard_.empty() || heard_.back() != what) heard_.push_back(what);
    if (what == throws_at_) throw base::InputError("thrown at " + what);
  }

  std::vector<std::string>& heard_;
  std::string throws_at_;
  bool everywhere_;
};

std::string error_of(Session& session) {
  try {
    session.run();
  } catch (const base::Error& error) {
    return error.what();
  }
  return "";
}

int rank() {
  return Tpetra::getDefaultComm()->getRank();
}

// An observer is told of start, stages, iterations, steps and end in their order, of one on every rank on every rank;
// the record holds every step that it was told of.
TEST(Session, TellsItsObservers) {
  std::vector<std::string> heard, first_heard;
  Session session(scene::test::tube_scene(), "scene.xml");
  session.add(std::make_unique<Listener>(heard));
  session.add(std::make_unique<Listener>(first_heard, "", false));
  session.run();
  EXPECT_THAT(heard, ElementsAre("start", "begin settle", "iteration", "step 1", "end settle", "end"));
  if (rank() == 0)
    EXPECT_EQ(first_heard, heard);
  else
    EXPECT_TRUE(first_heard.empty());
  EXPECT_EQ(session.record().reports().size(), 1U);
  EXPECT_LT(session.record().last().accuracy.residual, 1e-6);
  EXPECT_GT(session.record().statistics().newton_iterations, 0);
}

// What an observer of the first rank throws at a step ends the run with the same error on every rank; the record ends
// with this step, and the others are told.
TEST(Session, ObserverThatThrowsAtAStep) {
  std::vector<std::string> heard, ignored;
  Session session(pulled(), "scene.xml");
  session.add(std::make_unique<Listener>(heard));
  session.add(std::make_unique<Listener>(ignored, "step 2", false));
  EXPECT_EQ(error_of(session), "thrown at step 2");
  EXPECT_EQ(heard.back(), "failure");
  EXPECT_EQ(session.record().reports().size(), 2U);
}

// What is thrown at an iteration ends the run after it, with that error on every rank.
TEST(Session, ObserverThatThrowsAtAnIteration) {
  std::vector<std::string> ignored;
  Session session(pulled(), "scene.xml");
  session.add(std::make_unique<Listener>(ignored, "iteration", false));
  EXPECT_EQ(error_of(session), "thrown at iteration");
}

// A stage that cannot reach its end tells the observers, and its error names the last step and where it is kept.
TEST(Session, StageThatFails) {
  std::vector<std::string> heard;
  Session session(pulled(2), "scene.xml");
  session.add(std::make_unique<Listener>(heard));
  const std::string error = error_of(session);
  const std::string steps = std::to_string(session.record().reports().size());
  EXPECT_THAT(error, StartsWith("stage \"pull\" could not reach its end"));
  EXPECT_THAT(error, HasSubstr(" The last converged state, step " + steps + ", is kept here."));
  EXPECT_EQ(heard.back(), "failure");
}

// A scene in memory may include a file, as a file may: it goes before what it includes, and errors name the one that is
// at fault.
TEST(Session, ContentThatIncludesAFile) {
  const std::string file =
      (std::filesystem::temp_directory_path() / ("session_test." + std::to_string(getpid()) + ".xml")).string();
  std::ofstream(file) << "<ParameterList name=\"scene\"><Parameter name=\"title\" type=\"string\" value=\"a file\"/>"
                         "<ParameterList name=\"Output\"><Parameter name=\"body size\" type=\"double\" value=\"-1\"/>"
                         "</ParameterList></ParameterList>";
  Teuchos::ParameterList list = scene::test::flat_scene();
  list.set("include", Teuchos::Array<std::string>(1, file));
  list.sublist("Output").set("body size", 4.0);
  EXPECT_EQ(Session(list, "memory").scene().title(), "a file");
  list.sublist("Output").remove("body size");
  try {
    const Session session(list, "memory");
    ADD_FAILURE() << "no InputError";
  } catch (const base::InputError& error) {
    EXPECT_THAT(error.what(), StartsWith(file + ": scene > Output: parameter \"body size\" is out of range"));
  }
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace toile::run
