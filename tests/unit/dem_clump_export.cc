// Exported clumps hold the numbers of the shape, read back from the text with nothing but the
// format's own rules. Fails when a value is rounded, misplaced or in another unit, when a file of a
// format is missing, or when a temporary file stays behind.
#include "dem/export/clump_export.h"
#include "dem/export/member_volumes.h"
#include "dem/input_error.h"
#include "dem/meshes/mass_properties.h"
#include "tests/temporary_folder.h"

#include <sstream>

namespace
{
using namespace interlock::dem;
constexpr double density = 2650;

// Four balls at the corners of a square and two above and below, a little irregular.
ClumpShape some_shape()
{
  ClumpShape shape;
  shape.name = "stone 7";
  shape.spheres = {{{0.01 / 3, 0.02, 0}, 0.017},    {{0.0031, -0.021, 0.001}, 0.016},
                   {{-0.013, 0.018, 0}, 0.015},     {{-0.012, -0.017, -0.001}, 0.0151},
                   {{0.002, 0.003, 0.011}, 0.0149}, {{0.004, 0.001, -0.012}, 0.0147},
                   {{0.016, 0.001, 0.002}, 0.0131}};
  shape.volume = 1e-4 / 3;
  shape.unit_inertia = Vector3(1e-8 / 3, 1e-8 / 2.3, 1e-8 / 2);
  return shape;
}

class ClumpExport : public TemporaryFolderTest
{
protected:
  // The text of the exported main file, or of the one with `suffix`.
  std::string text_of(const std::string& format, const std::string& suffix = "") const
  {
    const std::string path = (folder / "clump").string();
    export_clump(path, shape, clump_format(format), density);
    EXPECT_FALSE(std::filesystem::exists(path + suffix + ".part"));
    EXPECT_FALSE(std::filesystem::exists(path + ".part"));
    std::ifstream file(path + suffix);
    EXPECT_TRUE(file) << path + suffix;
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }

  // `count` numbers that follow `word`; commas and `...` count as blanks.
  static std::vector<double> numbers(const std::string& text, const std::string& word,
                                     std::size_t count)
  {
    const auto begin = text.find(word);
    EXPECT_NE(begin, std::string::npos) << word;
    if (begin == std::string::npos) return std::vector<double>(count);
    std::string rest = text.substr(begin + word.size());
    for (auto at = rest.find("..."); at != std::string::npos; at = rest.find("..."))
      rest.replace(at, 3, "   ");
    for (char& c : rest)
      if (c == ',' || c == '(' || c == ')') c = ' ';
    std::istringstream stream(rest);
    std::vector<double> values(count);
    for (double& value : values) EXPECT_TRUE(stream >> value) << "after " << word;
    return values;
  }

  void expect_spheres(const std::vector<double>& values, std::size_t stride, std::size_t first,
                      std::size_t radius) const
  {
    for (std::size_t i = 0; i < shape.spheres.size(); ++i) {
      for (int k = 0; k < 3; ++k)
        EXPECT_EQ(values[stride * i + first + k], shape.spheres[i].centre[k]);
      EXPECT_EQ(values[stride * i + radius], shape.spheres[i].radius);
    }
  }

  ClumpShape shape = some_shape();
  const std::size_t count = shape.spheres.size();
  const double mass = density * shape.volume;
  const Vector3 inertia = density * shape.unit_inertia;
};

TEST_F(ClumpExport, Lammps)
{
  const std::string text = text_of("lammps");
  EXPECT_NE(text.find("\n7 atoms\n"), std::string::npos);
  const auto head = numbers(text, "atoms\n", 1);
  EXPECT_EQ(head[0], mass);
  EXPECT_EQ(numbers(text, " mass\n", 3), std::vector<double>({0, 0, 0}));
  EXPECT_EQ(numbers(text, " com\n", 6),
            std::vector<double>({inertia[0], inertia[1], inertia[2], 0, 0, 0}));
  const auto coords = numbers(text, "\nCoords\n", 4 * count);
  const auto diameters = numbers(text, "\nDiameters\n", 2 * count);
  const auto masses = numbers(text, "\nMasses\n", 2 * count);
  std::vector<double> volumes;
  for (std::size_t i = 0; i < count; ++i) {
    for (int k = 0; k < 3; ++k) EXPECT_EQ(coords[4 * i + 1 + k], shape.spheres[i].centre[k]);
    EXPECT_EQ(diameters[2 * i + 1], 2 * shape.spheres[i].radius);
    EXPECT_GT(masses[2 * i + 1], 0);
    EXPECT_EQ(masses[2 * i], i + 1.);
    volumes.push_back(masses[2 * i + 1] / density);
  }
  const MassProperties sums = mass_properties(shape.spheres, volumes);
  EXPECT_NEAR(sums.volume, shape.volume, 1e-12 * shape.volume);
  EXPECT_LT(sums.centre.norm(), 1e-12);
}

// Seven spheres cannot carry the moments of some_shape(); the sums of these eight are the stone's,
// because the stone is made of them.
TEST_F(ClumpExport, LammpsSaysWhatTheSumsMiss)
{
  EXPECT_NE(text_of("lammps").find("their moments are off by up to"), std::string::npos);
  EXPECT_GT(sum_deviation(shape, member_volumes(shape)), 0.01);

  shape.spheres.clear();
  for (const double x : {-0.01, 0.01})
    for (const double y : {-0.012, 0.012})
      for (const double z : {-0.015, 0.015}) shape.spheres.push_back({{x, y, z}, 0.015});
  const std::vector<double> volumes(8, 1e-5);
  const MassProperties exact = mass_properties(shape.spheres, volumes);
  shape.volume = exact.volume;
  shape.unit_inertia = exact.inertia.diagonal();
  EXPECT_LT(sum_deviation(shape, member_volumes(shape)), allowed_sum_deviation);
  EXPECT_NE(text_of("lammps").find("sum to the stone's mass, centre and inertia"),
            std::string::npos);
}

TEST_F(ClumpExport, Liggghts)
{
  expect_spheres(numbers(text_of("liggghts"), ".in`.\n", 4 * count), 4, 0, 3);
  const std::string commands = text_of("liggghts", ".in");
  EXPECT_EQ(numbers(commands, " mass ", 1)[0], mass);
  EXPECT_EQ(numbers(commands, "inertia_tensor", 6),
            std::vector<double>({inertia[0], 0, 0, inertia[1], 0, inertia[2]}));
  EXPECT_EQ(numbers(commands, "nspheres", 1)[0], count);
  EXPECT_NE(commands.find("file clump scale"), std::string::npos);
  EXPECT_NE(commands.find("use_density"), std::string::npos);
  shape.spheres.resize(1);
  EXPECT_THROW(text_of("liggghts"), interlock::InputError);
}

TEST_F(ClumpExport, Yade)
{
  const std::string text = text_of("yade");
  EXPECT_EQ(numbers(text, "\nMASS = ", 1)[0], mass);
  EXPECT_EQ(numbers(text, "\nINERTIA = ", 3),
            std::vector<double>({inertia[0], inertia[1], inertia[2]}));
  expect_spheres(numbers(text, "\nSPHERES = [\n", 4 * count), 4, 0, 3);
}

TEST_F(ClumpExport, Mercury)
{
  expect_spheres(numbers(text_of("mercury", "/Clump/Clump.txt"), "", 4 * count), 4, 0, 3);
  EXPECT_EQ(numbers(text_of("mercury", "/Inertia/Mass.txt"), "", 1)[0], mass);
  EXPECT_EQ(numbers(text_of("mercury", "/Inertia/TOI.txt"), "", 9),
            std::vector<double>({inertia[0], 0, 0, 0, inertia[1], 0, 0, 0, inertia[2]}));
  EXPECT_EQ(numbers(text_of("mercury", "/Inertia/PD.txt"), "", 9),
            std::vector<double>({1, 0, 0, 0, 1, 0, 0, 0, 1}));
}

// A file in the way of one of the folder's own stands for a full disk.
TEST_F(ClumpExport, FoldersAppearWholeOrNotAtAll)
{
  const auto path = folder / "clump.mclump";
  write("clump.mclump.part", "in the way");
  EXPECT_THROW(export_clump(path.string(), shape, ClumpFormat::mercury, density),
               interlock::InputError);
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(ClumpExport, Pfc)
{
  const std::string text = text_of("pfc");
  EXPECT_NE(text.find("name 'stone 7' ..."), std::string::npos);
  expect_spheres(numbers(text, "pebbles 7", 4 * count), 4, 1, 0);
  // Templates have unit density.
  EXPECT_EQ(numbers(text, "\n  volume ", 1)[0], shape.volume);
  const Vector3& unit = shape.unit_inertia;
  EXPECT_EQ(numbers(text, "\n  inertia ", 6),
            std::vector<double>({unit[0], unit[1], unit[2], 0, 0, 0}));
}

TEST_F(ClumpExport, Csv)
{
  expect_spheres(numbers(text_of("csv"), "\nx [m],y [m],z [m],r [m]\n", 4 * count), 4, 0, 3);
}

TEST_F(ClumpExport, Vtk)
{
  shape.name = "a--b";
  const std::string text = text_of("vtk");
  const auto radii = numbers(text, "Name=\"radius [m]\" format=\"ascii\">\n", count);
  const auto points = numbers(text, "NumberOfComponents=\"3\" format=\"ascii\">\n", 3 * count);
  std::vector<double> spheres;
  for (std::size_t i = 0; i < count; ++i) {
    spheres.insert(spheres.end(), &points[3 * i], &points[3 * i] + 3);
    spheres.push_back(radii[i]);
  }
  expect_spheres(spheres, 4, 0, 3);
  const auto comment = text.find("<!--") + 4;
  EXPECT_EQ(text.find("--", comment), text.find("-->")) << "no XML";
}

TEST_F(ClumpExport, NamesAndPaths)
{
  for (const std::string& name : clump_format_names())
    EXPECT_FALSE(clump_extension(clump_format(name)).empty());
  EXPECT_EQ(clump_export_path("out.d/a.b.clump.json", ClumpFormat::yade), "out.d/a_b.py");
  EXPECT_EQ(clump_export_path("out.d/a", ClumpFormat::vtk), "out.d/a.vtp");
  EXPECT_EQ(clump_export_path("a.data", ClumpFormat::lammps), "a.mol");
  EXPECT_EQ(clump_export_path("my scans/no. 7-b.clump.json", ClumpFormat::mercury),
            "my scans/no__7_b.mclump");
  EXPECT_EQ(clump_export_path("my scans/no. 7-b.clump.json", ClumpFormat::csv),
            "my scans/no. 7-b.csv");
  EXPECT_EQ(clump_export_path("7.clump.json", ClumpFormat::yade), "stone_7.py");
  EXPECT_EQ(clump_export_paths("a.clump.json", ClumpFormat::liggghts),
            std::vector<std::string>({"a.multisphere", "a.multisphere.in"}));
}

TEST_F(ClumpExport, Refusals)
{
  EXPECT_THROW(clump_format("lamps"), interlock::InputError);
  const std::string path = (folder / "clump").string();
  EXPECT_THROW(export_clump(path, shape, ClumpFormat::csv, 0), interlock::InputError);
  for (const char* name : {"/nowhere/a.csv", "/nowhere/a.mclump"})
    EXPECT_THROW(
        export_clump(name, shape,
                     std::string(name).back() == 'v' ? ClumpFormat::csv : ClumpFormat::mercury,
                     density),
        interlock::InputError);
  shape.spheres.clear();
  EXPECT_THROW(export_clump(path, shape, ClumpFormat::csv, density), interlock::InputError);
}
} // namespace
