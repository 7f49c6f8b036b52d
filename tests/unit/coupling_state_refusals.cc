// Trees that do not fit the field list which reads them. Fails when one is taken for good, or
// refused without the path that is wrong.
#include "tests/refusal.h"
#include "tests/state_samples.h"

using namespace state_samples;

namespace
{
// Whatever is even is good.
struct Even {
  int number = 0;
  void validate() const
  {
    if (number % 2 != 0) throw std::logic_error("The number is odd.");
  }
};
template <class Archive> void exchange(Archive& archive, Even& even)
{
  archive("number", even.number);
}

template <class T>
void expect_refused(const StateTree& tree, T into, const std::string& path,
                    const std::vector<std::string>& facts)
{
  expect_refusal(
      [&] {
        StateReader reader(tree, "state/");
        reader("field", into);
      },
      path, facts);
}
} // namespace

TEST(StateArchive, RefusesWhatIsMissing)
{
  expect_refused(StateTree(), 1., "state/field", {"lacks"});
  StateTree tree = written(std::vector<Contact>(2));
  tree.erase("state/field/spring/turns");
  expect_refused(tree, std::vector<Contact>(), "state/field/spring/turns", {"lacks"});
  tree = written(std::vector<Shape>(2));
  tree.erase("state/field/1/radii");
  expect_refused(tree, std::vector<Shape>(), "state/field/1/radii", {"lacks"});
}

TEST(StateArchive, RefusesAnotherTypeOrShape)
{
  expect_refused(written(1.), 1, "state/field", {"another type or shape"});
  expect_refused(written(1), 1., "state/field", {"another type or shape"});
  expect_refused(written(std::string("1")), 1, "state/field", {"another type or shape"});
  expect_refused(written(Vector3(1, 2, 3)), 1., "state/field", {"another type or shape"});
  expect_refused(written(std::vector<double>{1, 2, 3}), Vector3(), "state/field",
                 {"another type or shape"});
  expect_refused(written(std::vector<double>{1, 2, 3}), 1., "state/field", {"3 rows instead of 1"});
  expect_refused(written(std::vector<double>()), 1., "state/field", {"0 rows instead of 1"});
  StateTree torn = written(std::vector<Vector3>(2));
  std::get<std::vector<double>>(torn["state/field"].values).pop_back();
  expect_refused(torn, std::vector<Vector3>(), "state/field", {"another type or shape"});
}

// A list with a count that its columns do not have; a huge one must not reserve memory first.
TEST(StateArchive, RefusesColumnsOfAnotherLength)
{
  for (const std::int64_t count : {std::int64_t(1), std::int64_t(3), std::int64_t(1) << 60}) {
    StateTree tree = written(std::vector<Contact>(2));
    tree["state/field/count"].values = std::vector<std::int64_t>{count};
    expect_refused(tree, std::vector<Contact>(), "state/field/first",
                   {"2 rows instead of " + std::to_string(count)});
  }
  StateTree tree = written(std::vector<Contact>(2));
  std::get<std::vector<std::string>>(tree["state/field/word"].values).push_back("more");
  expect_refused(tree, std::vector<Contact>(), "state/field/word", {"3 rows instead of 2"});
}

TEST(StateArchive, RefusesAnUnknownKind)
{
  StateTree tree = written(std::variant<Fill, Pull>(Pull{1}));
  tree["state/field/kind"].values = std::vector<std::string>{"push"};
  expect_refused(tree, std::variant<Fill, Pull>(), "state/field", {"\"push\""});
}

// What nobody asked for is a state of another version.
TEST(StateArchive, RefusesWhatIsLeftOver)
{
  StateTree tree = written(Spring());
  tree["state/field/temperature"] = {std::vector<double>{20}};
  tree["elsewhere"] = {std::vector<double>{1}}; // outside the prefix
  Spring spring;
  StateReader reader(tree, "state/");
  reader("field", spring);
  expect_refusal([&] { reader.expect_all_read(); }, "state/field/temperature", {"does not know"});
  tree.erase("state/field/temperature");
  EXPECT_NO_THROW(reader.expect_all_read());
}

TEST(StateArchive, ValidatesWhatItHasRead)
{
  EXPECT_EQ(round_trip(Even{4}).number, 4);
  StateTree tree = written(Even{5});
  StateReader reader(tree, "state/");
  Even even;
  EXPECT_THROW(reader("field", even), std::logic_error);
}
