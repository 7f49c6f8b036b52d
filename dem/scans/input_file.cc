#include "dem/scans/input_file.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>

namespace interlock::dem
{
namespace fs = std::filesystem;

InputFile::InputFile(std::string kind, std::string path)
    : kind_(std::move(kind)), path_(std::move(path))
{
  std::error_code error;
  if (!fs::exists(path_, error)) refuse("does not exist.");
  // Pipes and devices may never end.
  if (!fs::is_regular_file(path_, error)) refuse("is not a file.");
  const std::uintmax_t size = fs::file_size(path_, error);
  std::ifstream file(path_, std::ios::binary);
  if (error || !file) refuse("cannot be opened for reading.");
  if (size == 0) refuse("is empty.");
  if (size > largest_file)
    refuse("has ", size, " bytes, but at most ", largest_file, " can be read.");
  bytes_.resize(size);
  file.read(bytes_.data(), static_cast<std::streamsize>(size));
  if (static_cast<std::uintmax_t>(file.gcount()) != size) refuse("cannot be read to its end.");
}

std::string InputFile::extension() const
{
  std::string result = fs::path(path_).extension().string();
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

std::string_view InputFile::text() const
{
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  const std::string_view all = bytes_;
  return all.substr(all.substr(0, mark.size()) == mark ? mark.size() : 0);
}

namespace
{
// Text whose characters take two or four bytes: marked as such, or Latin letters with zeros between
// them. Empty for anything else.
std::string wide_text(std::string_view start)
{
  using namespace std::literals;
  const auto starts_with = [&](std::string_view mark) {
    return start.substr(0, mark.size()) == mark;
  };
  const auto is_letter = [&](std::size_t k) { return start[k] > 31 && start[k] < 127; };
  const auto is_zero = [&](std::size_t k) { return start[k] == 0; };
  const char* name = "";
  if (starts_with("\xFF\xFE\0\0"sv) || starts_with("\0\0\xFE\xFF"sv))
    name = "UTF-32";
  else if (starts_with("\xFF\xFE"sv) || starts_with("\xFE\xFF"sv))
    name = "UTF-16";
  else if (start.size() >= 4 && ((is_letter(0) && is_zero(1) && is_letter(2) && is_zero(3)) ||
                                 (is_zero(0) && is_letter(1) && is_zero(2) && is_letter(3))))
    name = "UTF-16";
  return *name ? std::string("text in ") + name + ", to be saved as UTF-8 or ASCII" : "";
}
} // namespace

std::string InputFile::content() const
{
  using namespace std::literals;
  const std::pair<std::string_view, const char*> signatures[] = {
      {"\xFF\xD8\xFF"sv, "a JPEG picture"},
      {"\x89PNG"sv, "a PNG picture"},
      {"GIF8"sv, "a GIF picture"},
      {"II*\0"sv, "a TIFF picture"},
      {"%PDF"sv, "a PDF document"},
      {"PK\3\4"sv, "a zip archive (or a file based on one, such as 3MF)"},
      {"\x1F\x8B"sv, "a gzip archive"},
      {"7z\xBC\xAF"sv, "a 7z archive"},
      {"glTF"sv, "a glTF mesh"},
      {"Kaydara FBX"sv, "an FBX mesh"},
      {"OFF\n"sv, "an OFF mesh"},
      {"OFF\r"sv, "an OFF mesh"},
      {"ISO-10303"sv, "a STEP model"},
      {"<?xml"sv, "an XML file"},
      {"<!DOCTYPE"sv, "a web page"},
      {"<html"sv, "a web page"},
      {"{"sv, "a JSON file"},
      {"ply\n"sv, "a PLY file"},
      {"ply\r"sv, "a PLY file"},
      {"\0\5\x16\7"sv, "what a Mac keeps beside a file (AppleDouble)"},
  };
  const std::string_view start = text().substr(0, 1000);
  for (const auto& [signature, name] : signatures)
    if (start.substr(0, signature.size()) == signature) return name;
  if (start.substr(0, 6) == "solid " && start.find("facet normal") != std::string_view::npos)
    return "an STL mesh";
  return wide_text(start);
}

std::string quoted(std::string_view word)
{
  constexpr std::size_t longest = 40;
  std::string result = "'";
  for (const char c : word.substr(0, longest))
    result += static_cast<unsigned char>(c) < 32 || static_cast<unsigned char>(c) > 126 ? '?' : c;
  return result + (word.size() > longest ? "...'" : "'");
}
} // namespace interlock::dem
