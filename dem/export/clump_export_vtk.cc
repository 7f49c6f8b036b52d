#include "dem/export/clump_export_formats.h"

namespace interlock::dem
{
namespace
{
std::string array(const std::string& type, const std::string& attributes,
                  const std::vector<std::string>& lines)
{
  std::string text = "<DataArray type=\"" + type + "\" " + attributes + " format=\"ascii\">\n";
  for (const std::string& line : lines) text += line + "\n";
  return text + "</DataArray>\n";
}

std::string field(const std::string& name, const std::vector<double>& values)
{
  return array("Float64",
               "Name=\"" + name + "\" NumberOfTuples=\"" + std::to_string(values.size()) + "\"",
               {digits(values, " ")});
}
} // namespace

ExportedFiles vtk_files(const ClumpExport& clump)
{
  std::string head = comment_head(
      clump, "",
      {"ParaView: open, add the filter Glyph, glyph type Sphere, its radius 1, orientation array",
       "none, scale array `radius [m]`, scale factor 1, glyph mode All Points."});
  // An XML comment must not hold two hyphens in a row.
  for (auto at = head.find("--"); at != std::string::npos; at = head.find("--")) head[at] = ' ';

  const std::vector<Sphere>& spheres = clump.shape.spheres;
  std::vector<std::string> points, radii, numbers, ends;
  for (const Sphere& s : spheres) {
    points.push_back(digits({s.centre[0], s.centre[1], s.centre[2]}, " "));
    radii.push_back(digits(s.radius));
    numbers.push_back(std::to_string(numbers.size()));
    ends.push_back(std::to_string(numbers.size()));
  }
  const std::string count = std::to_string(spheres.size());
  const Vector3 inertia = clump.inertia();
  const std::string text =
      "<?xml version=\"1.0\"?>\n<!--\n" + head +
      "-->\n<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n<PolyData>\n"
      "<FieldData>\n" +
      field("density [kg/m3]", {clump.density}) + field("mass [kg]", {clump.mass()}) +
      field("volume [m3]", {clump.shape.volume}) +
      field("principal moments [kg m2]", {inertia[0], inertia[1], inertia[2]}) +
      "</FieldData>\n<Piece NumberOfPoints=\"" + count + "\" NumberOfVerts=\"" + count +
      "\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n"
      "<PointData Scalars=\"radius [m]\">\n" +
      array("Float64", "Name=\"radius [m]\"", radii) + "</PointData>\n<Points>\n" +
      array("Float64", "NumberOfComponents=\"3\"", points) + "</Points>\n<Verts>\n" +
      array("Int32", "Name=\"connectivity\"", numbers) + array("Int32", "Name=\"offsets\"", ends) +
      "</Verts>\n</Piece>\n</PolyData>\n</VTKFile>\n";
  return {{"", text}};
}
} // namespace interlock::dem
