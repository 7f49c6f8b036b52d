// Field lists and the tree that they write. Fails when a bit of any kind of field is lost between
// StateWriter and StateReader.
#include "tests/state_samples.h"

using namespace state_samples;

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
