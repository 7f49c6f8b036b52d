// Names in the header of PLY files: the members of PlyHeader in ply_file.h.
#include "dem/scans/ply_file.h"

#include <algorithm>
#include <cctype>

namespace interlock::dem
{
namespace
{
bool same(const std::string& a, const std::string& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
    return std::tolower(x) == std::tolower(y);
  });
}
} // namespace

std::string listed(const std::vector<std::string>& names)
{
  constexpr std::size_t most = 20;
  std::string text;
  const std::size_t shown = std::min(names.size(), most);
  for (std::size_t k = 0; k < shown; ++k) {
    const bool is_last = k + 1 == shown && shown == names.size();
    text += (k == 0 ? "" : is_last ? " and " : ", ") + quoted(names[k]);
  }
  if (names.empty()) return "nothing else";
  return text + (shown < names.size() ? " and so on" : "");
}

bool PlyHeader::Element::is_named(const std::string& other) const
{
  return same(name, other);
}

bool PlyHeader::Element::is_strip() const
{
  return is_named("tristrips") || is_named("tristrip");
}

bool PlyHeader::Element::is_facet() const
{
  return is_named("face") || is_strip();
}

int PlyHeader::Element::column(std::initializer_list<const char*> names, bool is_list) const
{
  for (const char* wanted : names)
    for (std::size_t k = 0; k < properties.size(); ++k)
      if (properties[k].is_list() == is_list && same(properties[k].name, wanted))
        return static_cast<int>(k);
  return -1;
}

std::string PlyHeader::Element::property_names() const
{
  std::vector<std::string> names;
  for (const Property& property : properties) names.push_back(property.name);
  return listed(names);
}

std::size_t PlyHeader::rows(const std::string& element) const
{
  for (const Element& candidate : elements)
    if (candidate.is_named(element)) return candidate.rows;
  return 0;
}

bool PlyHeader::has_facets() const
{
  return std::any_of(elements.begin(), elements.end(),
                     [](const Element& e) { return e.is_facet() && e.rows > 0; });
}

bool PlyHeader::is_single(const Type& type) const
{
  return format != Format::text && type.kind == Type::floating && type.size == 4;
}

std::string PlyHeader::unknown_elements() const
{
  std::vector<std::string> names;
  for (const Element& element : elements)
    if (element.rows > 0 && !element.is_named("vertex") && !element.is_facet())
      names.push_back(element.name);
  if (names.empty()) return "";
  return names.size() == 1 ? ", with an element " + listed(names) + ", which is not read"
                           : ", with the elements " + listed(names) + ", which are not read";
}
} // namespace interlock::dem
