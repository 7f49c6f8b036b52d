// Field lists and the tree that they write. Fails when a bit of any kind of field is lost between
// StateWriter and StateReader, when a difference or a hash overlooks one, or when a tree that does
// not fit the field list is taken for good or answered without the path that is wrong.
#include "coupling/state/state_archive.h"
#include "tests/refusal.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

using namespace interlock;
using namespace interlock::coupling;
using dem::Vector3;

namespace
{
using Real = std::numeric_limits<double>;

double from_bits(std::uint64_t bits)
{
  double x;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

// Doubles that a detour over text, float or arithmetic would change.
const std::vector<double> delicate = {0.,
                                      -0.,
                                      0.1,
                                      1. / 3,
                                      Real::min(),
                                      Real::max(),
                                      Real::lowest(),
                                      Real::denorm_min(),
                                      -Real::denorm_min(),
                                      from_bits(12345),
                                      Real::infinity(),
                                      -Real::infinity(),
                                      from_bits(0x7ff8000000abcdefu),  // a NaN with a payload
                                      from_bits(0xfff8000000000001u)}; // a negative one

template <class T> bool same_bits(const T& a, const T& b)
{
  return std::memcmp(&a, &b, sizeof a) == 0;
}

template <class T> bool same_bits(const std::vector<T>& a, const std::vector<T>& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

enum class Colour { red, green = 7, blue = -3 };

struct Spring {
  Vector3 stretch = Vector3::Zero();
  int turns = 0;
};
template <class Archive> void exchange(Archive& archive, Spring& spring)
{
  archive("stretch", spring.stretch, "m");
  archive("turns", spring.turns);
}

struct Contact {
  std::int64_t first = 0;
  std::string word;
  Spring spring;
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
};
template <class Archive> void exchange(Archive& archive, Contact& contact)
{
  archive("first", contact.first);
  archive("word", contact.word);
  archive("spring", contact.spring);
  archive("turn", contact.turn);
}

struct Shape {
  static constexpr bool stored_as_groups = true;
  std::vector<double> radii;
  std::vector<Spring> springs;
};
template <class Archive> void exchange(Archive& archive, Shape& shape)
{
  archive("radii", shape.radii, "m");
  archive("springs", shape.springs);
}

struct Fill {
  static constexpr const char* kind = "fill";
  int batch = 0;
};
template <class Archive> void exchange(Archive& archive, Fill& stage)
{
  archive("batch", stage.batch);
}
struct Pull {
  static constexpr const char* kind = "pull";
  double displacement = 0;
};
template <class Archive> void exchange(Archive& archive, Pull& stage)
{
  archive("displacement", stage.displacement, "m");
}
struct Stay {
  static constexpr const char* kind = "stay";
};
template <class Archive> void exchange(Archive&, Stay&) {}

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

// Writes a field, reads it into another object of its type, and gives both trees.
template <class T> T round_trip(const T& field, T into = T())
{
  StateTree tree, again;
  StateWriter writer(tree, "state/");
  writer("field", field, "m");
  StateReader reader(tree, "state/");
  reader("field", into);
  reader.expect_all_read();
  StateWriter(again, "state/")("field", into, "m");
  EXPECT_EQ(first_difference(tree, again), std::nullopt);
  EXPECT_EQ(hash_of(tree), hash_of(again));
  return into;
}

StateTree small_tree()
{
  StateTree tree;
  tree["a/numbers"] = {std::vector<double>{0, 1, 2, 3, 4, 5}, 3, "m"};
  tree["a/words"] = {std::vector<std::string>{"one", "", "two"}, 1};
  tree["b/counts"] = {std::vector<std::int64_t>{1, 2}, 1};
  tree["b/none"] = {std::vector<double>(), 1};
  return tree;
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

template <class T> StateTree written(const T& field)
{
  StateTree tree;
  StateWriter(tree, "state/")("field", field);
  return tree;
}
} // namespace

// --- Round trips -------------------------------------------------------------------------------

TEST(StateArchive, KeepsEveryBitOfDoubles)
{
  for (const double x : delicate) EXPECT_TRUE(same_bits(round_trip(x), x)) << x;
  EXPECT_TRUE(same_bits(round_trip(delicate), delicate));
  EXPECT_TRUE(same_bits(round_trip(-Real::denorm_min()), -Real::denorm_min()));
}

TEST(StateArchive, KeepsWholeNumbersWordsAndFlags)
{
  using Whole = std::numeric_limits<std::int64_t>;
  for (const std::int64_t n : {Whole::min(), Whole::max(), std::int64_t(0), std::int64_t(-1)})
    EXPECT_EQ(round_trip(n), n);
  // Seeds use all 64 bits.
  EXPECT_EQ(round_trip(std::numeric_limits<std::uint64_t>::max()),
            std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(round_trip(std::numeric_limits<int>::min()), std::numeric_limits<int>::min());
  for (const bool flag : {false, true}) EXPECT_EQ(round_trip(flag), flag);
  for (const Colour c : {Colour::red, Colour::green, Colour::blue}) EXPECT_EQ(round_trip(c), c);
  const std::string long_word(10000, 'x');
  for (const std::string& word : {std::string(), std::string("Box/Slot height, \"30\" mm\n"),
                                  std::string("Korngr\xc3\xb6\xc3\x9f"
                                              "e"),
                                  long_word})
    EXPECT_EQ(round_trip(word), word);
  const std::vector<std::int64_t> ids = {3, Whole::max(), Whole::min()};
  EXPECT_EQ(round_trip(ids), ids);
  const std::vector<bool> flags = {true, false, true};
  EXPECT_EQ(round_trip(flags), flags);
  const std::vector<std::string> words = {"", "a", ""};
  EXPECT_EQ(round_trip(words), words);
  const std::vector<Colour> colours = {Colour::blue, Colour::red};
  EXPECT_EQ(round_trip(colours), colours);
}

// What was in the object before must be gone.
TEST(StateArchive, EmptyListsAreEmptyAgain)
{
  EXPECT_TRUE(round_trip(std::vector<double>(), {1, 2}).empty());
  EXPECT_TRUE(round_trip(std::vector<std::string>(), {"a"}).empty());
  EXPECT_TRUE(round_trip(std::vector<Contact>(), std::vector<Contact>(3)).empty());
  EXPECT_TRUE(round_trip(std::vector<Shape>(), std::vector<Shape>(3)).empty());
  EXPECT_TRUE(round_trip(std::vector<Vector3>(), std::vector<Vector3>(1)).empty());
  dem::VectorField some;
  some.push_back(Vector3::Ones());
  EXPECT_EQ(round_trip(dem::VectorField(), some).size(), 0);
}

TEST(StateArchive, KeepsEveryBitOfVectorsMatricesAndQuaternions)
{
  const Vector3 v(delicate[1], delicate[12], delicate[7]);
  EXPECT_TRUE(same_bits(round_trip(v), v));
  Eigen::Matrix3d m;
  for (int k = 0; k < 9; ++k) m.data()[k] = delicate[k];
  EXPECT_TRUE(same_bits(round_trip(m), m));
  // Not of length 1, and not made so.
  const Eigen::Quaterniond q(delicate[1], 0.1, delicate[7], 0.3);
  EXPECT_TRUE(same_bits(round_trip(q), q));
  const std::vector<Vector3> list = {v, Vector3(1, -0., 3)};
  EXPECT_TRUE(same_bits(round_trip(list), list));
  const std::array<Vector3, 2> both = {v, Vector3(1, -0., 3)};
  EXPECT_TRUE(same_bits(round_trip(both), both));
  const std::array<double, 2> pair = {delicate[12], -0.};
  EXPECT_TRUE(same_bits(round_trip(pair), pair));
}

// Behind the last entry lies the filler, which loops over whole registers read.
TEST(StateArchive, KeepsComponentArraysAndTheirFiller)
{
  dem::VectorField field{Vector3(7, 8, 9)}, larger{Vector3(7, 8, 9)};
  for (int i = 0; i < 11; ++i) field.push_back(Vector3(delicate[i], -0., 0.1 * i));
  for (int i = 0; i < 40; ++i) larger.push_back(Vector3::Constant(i));
  const dem::VectorField read = round_trip(field, larger);
  ASSERT_EQ(read.size(), 11);
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < read.padded_size(); ++i)
      EXPECT_TRUE(same_bits(read.row(c)[i], field.row(c)[i])) << i;

  dem::ScalarField masses;
  for (const double x : delicate) masses.push_back(Eigen::Matrix<double, 1, 1>(x));
  const dem::ScalarField read_masses = round_trip(masses);
  ASSERT_EQ(read_masses.size(), masses.size());
  EXPECT_EQ(0,
            std::memcmp(read_masses.row(0), masses.row(0), sizeof(double) * masses.padded_size()));

  dem::QuaternionField turns;
  for (int i = 0; i < 9; ++i) turns.push_back(Eigen::Quaterniond(0.5, -0., delicate[i], 2));
  const dem::QuaternionField read_turns = round_trip(turns);
  ASSERT_EQ(read_turns.size(), 9);
  for (int c = 0; c < 4; ++c)
    for (int i = 0; i < turns.padded_size(); ++i)
      EXPECT_TRUE(same_bits(read_turns.row(c)[i], turns.row(c)[i])) << i;
}

// Columns: one array a field, one row an entry, also for fields of fields.
TEST(StateArchive, ListsOfTypesAreColumns)
{
  std::vector<Contact> list(3);
  for (int k = 0; k < 3; ++k) {
    list[k].first = 10 + k;
    list[k].word = k == 1 ? "" : "word";
    list[k].spring = {Vector3(k, -0., delicate[12]), 2 * k};
    list[k].turn = Eigen::Quaterniond(1, 2, 3, k);
  }
  const StateTree tree = written(list);
  EXPECT_EQ(tree.size(), 6u); // count, first, word, stretch, turns, turn
  EXPECT_EQ(std::get<std::vector<std::int64_t>>(tree.at("state/field/first").values),
            (std::vector<std::int64_t>{10, 11, 12}));
  EXPECT_EQ(tree.at("state/field/spring/stretch").columns, 3);
  EXPECT_EQ(tree.at("state/field/spring/stretch").size(), 9u);
  EXPECT_EQ(tree.at("state/field/spring/stretch").unit, "m");
  EXPECT_EQ(tree.at("state/field/turn").columns, 4);

  const std::vector<Contact> read = round_trip(list, std::vector<Contact>(5));
  ASSERT_EQ(read.size(), 3u);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(read[k].first, list[k].first);
    EXPECT_EQ(read[k].word, list[k].word);
    EXPECT_EQ(read[k].spring.turns, list[k].spring.turns);
    EXPECT_TRUE(same_bits(read[k].spring.stretch, list[k].spring.stretch));
    EXPECT_TRUE(same_bits(read[k].turn, list[k].turn));
  }
}

TEST(StateArchive, ListsOfListsAreGroups)
{
  const std::vector<Shape> list = {{{1, 2, 3}, {}}, {{}, {{Vector3(1, 2, 3), 4}, {}}}, {}};
  const StateTree tree = written(list);
  EXPECT_EQ(tree.at("state/field/0/radii").size(), 3u);
  EXPECT_EQ(tree.at("state/field/1/springs/turns").size(), 2u);
  const std::vector<Shape> read = round_trip(list);
  ASSERT_EQ(read.size(), 3u);
  EXPECT_EQ(read[0].radii, list[0].radii);
  EXPECT_TRUE(read[0].springs.empty());
  EXPECT_TRUE(read[1].radii.empty());
  ASSERT_EQ(read[1].springs.size(), 2u);
  EXPECT_EQ(read[1].springs[0].stretch, Vector3(1, 2, 3));
  EXPECT_EQ(read[1].springs[0].turns, 4);
}

TEST(StateArchive, KeepsWhatMayBeAbsentOrOfSeveralKinds)
{
  EXPECT_EQ(round_trip(std::optional<double>(), {2.}), std::nullopt);
  EXPECT_TRUE(same_bits(*round_trip(std::optional<double>(delicate[12])), delicate[12]));
  EXPECT_EQ(round_trip(std::optional<Shape>(Shape{{1, 2}, {}}))->radii,
            (std::vector<double>{1, 2}));

  using Stage = std::variant<Fill, Pull, Stay>;
  EXPECT_EQ(std::get<Pull>(round_trip(Stage(Pull{0.25}))).displacement, 0.25);
  EXPECT_EQ(round_trip(Stage(Stay()), Stage(Pull())).index(), 2u);
  const std::vector<Stage> plan = {Fill{3}, Stay(), Pull{-0.}, Fill{4}};
  const std::vector<Stage> read = round_trip(plan);
  ASSERT_EQ(read.size(), 4u);
  EXPECT_EQ(std::get<Fill>(read[0]).batch, 3);
  EXPECT_TRUE(same_bits(std::get<Pull>(read[2]).displacement, -0.));
  EXPECT_EQ(std::get<Fill>(read[3]).batch, 4);
}

TEST(StateArchive, UnitsStandBesideTheNumbers)
{
  const StateTree tree = written(Spring());
  EXPECT_EQ(tree.at("state/field/stretch").unit, "m");
  EXPECT_EQ(tree.at("state/field/turns").unit, "");
}

// --- Differences and hashes --------------------------------------------------------------------

TEST(StateTree, FirstDifferenceIsOneSentenceAboutIt)
{
  const StateTree a = small_tree();
  EXPECT_EQ(first_difference(a, a), std::nullopt);

  StateTree b = a;
  std::get<std::vector<double>>(b["a/numbers"].values)[4] = 4.5;
  EXPECT_EQ(first_difference(a, b),
            "a/numbers, row 1, column 1: 4 on one side and 4.5 on the other.");
  b = a;
  std::get<std::vector<double>>(b["a/numbers"].values)[0] = -0.;
  EXPECT_EQ(first_difference(a, b),
            "a/numbers, row 0, column 0: 0 on one side and -0 on the other.");
  b = a;
  std::get<std::vector<std::string>>(b["a/words"].values)[1] = " ";
  EXPECT_EQ(first_difference(a, b), "a/words, row 1, column 0:  on one side and   on the other.");
  b = a;
  std::get<std::vector<std::int64_t>>(b["b/counts"].values).push_back(3);
  EXPECT_EQ(first_difference(a, b), "b/counts has 2 values on one side and 3 on the other.");
  b = a;
  b["a/numbers"].columns = 2;
  EXPECT_EQ(first_difference(a, b), "a/numbers has another type or shape on the other side.");
  b = a;
  b["b/none"].values = std::vector<std::string>();
  EXPECT_EQ(first_difference(a, b), "b/none has another type or shape on the other side.");
  b = a;
  b.erase("b/counts");
  EXPECT_EQ(first_difference(a, b), "b/counts is there on one side only.");
  EXPECT_EQ(first_difference(b, a), "b/counts is there on one side only.");
}

// Values that compare as equal, or as unequal to themselves, are told apart by their bits.
TEST(StateTree, NotANumberEqualsItself)
{
  StateTree a = {{"x", {std::vector<double>{delicate[12]}}}}, b = a;
  EXPECT_EQ(first_difference(a, b), std::nullopt);
  std::get<std::vector<double>>(b["x"].values)[0] = from_bits(0x7ff8000000abcdeeu);
  EXPECT_NE(first_difference(a, b), std::nullopt);
  EXPECT_NE(hash_of(a), hash_of(b));
}

TEST(StateTree, HashChangesWithEveryBit)
{
  const StateTree tree = small_tree();
  const std::uint64_t hash = hash_of(tree);
  for (int k = 0; k < 6; ++k)
    for (int bit = 0; bit < 64; ++bit) {
      StateTree other = tree;
      double& x = std::get<std::vector<double>>(other["a/numbers"].values)[k];
      std::uint64_t bits;
      std::memcpy(&bits, &x, sizeof x);
      x = from_bits(bits ^ (std::uint64_t(1) << bit));
      ASSERT_NE(hash_of(other), hash) << "value " << k << ", bit " << bit;
    }
  for (int k = 0; k < 2; ++k)
    for (int bit = 0; bit < 64; ++bit) {
      StateTree other = tree;
      auto& n = std::get<std::vector<std::int64_t>>(other["b/counts"].values)[k];
      n = static_cast<std::int64_t>(static_cast<std::uint64_t>(n) ^ (std::uint64_t(1) << bit));
      ASSERT_NE(hash_of(other), hash) << "count " << k << ", bit " << bit;
    }
}

// The same bytes in another arrangement are another state.
TEST(StateTree, HashChangesWithNamesAndShapes)
{
  std::vector<StateTree> trees(8, small_tree());
  trees[1]["a/numbers"].columns = 2;
  trees[2]["a/words"].values = std::vector<std::string>{"on", "e", "two"};
  trees[3]["a/words"].values = std::vector<std::string>{"one", "two", ""};
  trees[4]["b/none"].values = std::vector<std::int64_t>();
  trees[5].erase("b/none");
  trees[6]["b/more"] = trees[6]["b/none"];
  trees[7]["b/county"] = trees[7]["b/counts"];
  trees[7].erase("b/counts");
  std::set<std::uint64_t> hashes;
  for (const StateTree& tree : trees) hashes.insert(hash_of(tree));
  EXPECT_EQ(hashes.size(), trees.size());
}

TEST(StateTree, HashIgnoresTheOrderOfInsertionAndUnits)
{
  const StateTree tree = small_tree();
  StateTree backwards;
  for (auto entry = tree.rbegin(); entry != tree.rend(); ++entry)
    backwards[entry->first] = entry->second;
  EXPECT_EQ(hash_of(backwards), hash_of(tree));
  EXPECT_EQ(first_difference(backwards, tree), std::nullopt);
}

// A hash of a part is that of the part alone, wherever it stands.
TEST(StateTree, HashOfAPrefixSeesThatPartOnly)
{
  StateTree tree = small_tree(), moved;
  for (const auto& [path, array] : tree) moved["deep/" + path] = array;
  EXPECT_EQ(hash_of(moved, "deep/"), hash_of(tree));
  const std::uint64_t part = hash_of(tree, "a/");
  std::get<std::vector<std::int64_t>>(tree["b/counts"].values)[0] = 9;
  EXPECT_EQ(hash_of(tree, "a/"), part);
  EXPECT_NE(hash_of(tree, "b/"), part);
}

// --- What does not fit -------------------------------------------------------------------------

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
