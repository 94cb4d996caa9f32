// What the list "Check" may say.
#include <Teuchos_ParameterList.hpp>

#include "fabrics.hpp"
#include "toile/base/error.hpp"

namespace toile::criteria::test {
namespace {

using ::testing::HasSubstr;

std::string refusal(const Teuchos::ParameterList& list) {
  try {
    read_request(base::validate(list, check_spec(), "fabric.xml"));
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "accepted";
}

std::string refusal(const std::string& name, const std::vector<double>& values) {
  Teuchos::ParameterList list("Check");
  list.set(name, Teuchos::Array<double>(values.begin(), values.end()));
  return refusal(list);
}

// Without a word the box reaches beyond the stretch of 3.4 where the literal hosiery law fails, and all but loss
// outside tension and polyconvexity must hold.
TEST(Request, Defaults) {
  const Request request = read_request(base::validate(Teuchos::ParameterList("Check"), check_spec(), "fabric.xml"));
  EXPECT_GT(request.course[1], 3.4);
  EXPECT_EQ(request.required, Request::default_required());
  EXPECT_EQ(request.points, Request().points);
}

// A reversed range is named with file, list, parameter and what is allowed.
TEST(Request, ReversedRange) {
  const std::string text = refusal("wale stretch", {2.0, 0.5});
  EXPECT_THAT(text, HasSubstr("fabric.xml: Check: parameter \"wale stretch\""));
  EXPECT_THAT(text, HasSubstr("the range is reversed: 2 to 0.5; the least value goes first"));
  EXPECT_THAT(refusal("shear", {1.0, 0.0}), HasSubstr("the range is reversed"));
}

// A box without extent is empty; a single shear is a plane through the box and accepted.
TEST(Request, EmptyBox) {
  EXPECT_THAT(refusal("course stretch", {1.0, 1.0}), HasSubstr("the box is empty"));
  EXPECT_EQ(refusal("shear", {0.0, 0.0}), "accepted");
}

// A range has two ends, and no stretch is zero or less.
TEST(Request, WrongRange) {
  EXPECT_THAT(refusal("wale stretch", {0.5, 1.0, 2.0}), HasSubstr("3 values, expected two"));
  EXPECT_THAT(refusal("wale stretch", {-0.5, 1.0}), HasSubstr("allowed: > 0"));
}

// A map that no memory holds is refused before it is computed.
TEST(Request, TooManyStates) {
  Teuchos::ParameterList list("Check");
  list.set("points", 1000);
  EXPECT_THAT(refusal(list), HasSubstr("a map of 1.3e+07 states is too large; allowed are 4e+06"));
}

// An unknown criterion is named with the nearest valid one.
TEST(Request, UnknownCriterion) {
  Teuchos::ParameterList list("Check");
  list.set("criteria", Teuchos::Array<std::string>(1, "grwoth"));
  EXPECT_THAT(refusal(list), HasSubstr("unknown criterion \"grwoth\"; did you mean \"growth\"?"));
}

}  // namespace
}  // namespace toile::criteria::test
