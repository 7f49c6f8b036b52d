// Trees of named arrays. Fails when a difference or a hash overlooks a bit, a name or a shape.
#include "tests/state_samples.h"

#include <set>

using namespace state_samples;

namespace
{
StateTree small_tree()
{
  StateTree tree;
  tree["a/numbers"] = {std::vector<double>{0, 1, 2, 3, 4, 5}, 3, "m"};
  tree["a/words"] = {std::vector<std::string>{"one", "", "two"}, 1};
  tree["b/counts"] = {std::vector<std::int64_t>{1, 2}, 1};
  tree["b/none"] = {std::vector<double>(), 1};
  return tree;
}
} // namespace

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
