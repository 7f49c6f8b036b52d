#include "dem/atomic_files.h"

#include <fstream>

namespace interlock::dem
{
namespace
{
namespace fs = std::filesystem;

struct Move {
  fs::path temporary, path;
};

// The uppermost folder above `path` that does not exist; empty when the folder of `path` does.
fs::path missing_folder(const fs::path& path)
{
  fs::path missing;
  std::error_code error;
  for (fs::path folder = path.parent_path(); !folder.empty() && !fs::exists(folder, error);
       folder = folder.parent_path())
    missing = folder;
  return missing;
}

// What is renamed so that `path` is there: itself, or the new folder around it.
Move move_of(const fs::path& path)
{
  const fs::path folder = missing_folder(path), moved = folder.empty() ? path : folder;
  return {moved.string() + ".part", moved};
}

bool is_folder(const fs::path& path)
{
  std::error_code error;
  return fs::is_directory(path, error);
}

bool write(const fs::path& path, const std::string& text)
{
  std::error_code error;
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), error);
  std::ofstream file(path, std::ios::binary);
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();
  return bool(file);
}

bool rename(const Move& move)
{
  std::error_code error;
  fs::rename(move.temporary, move.path, error);
  return !error;
}

std::optional<fs::path> write_and_rename(const std::vector<FileText>& files,
                                         std::vector<Move>& moves)
{
  for (const FileText& file : files) {
    const Move move = move_of(file.path);
    // A folder in the way of a file would let the rename fail after others have been renamed.
    if (move.path == file.path && (is_folder(move.path) || is_folder(move.temporary)))
      return file.path;
    if (moves.empty() || moves.back().path != move.path) moves.push_back(move);
    const std::string inside = file.path.string().substr(move.path.string().size());
    if (!write(move.temporary.string() + inside, file.text)) return file.path;
  }
  for (const Move& move : moves)
    if (!rename(move)) return move.path;
  return {};
}
} // namespace

std::optional<fs::path> write_atomically(const std::vector<FileText>& files)
{
  std::vector<Move> moves;
  const auto failed = write_and_rename(files, moves);
  std::error_code error;
  if (failed)
    for (const Move& move : moves) fs::remove_all(move.temporary, error);
  return failed;
}

bool write_atomically(const fs::path& path, const std::string& text)
{
  return missing_folder(path).empty() && !write_atomically({FileText{path, text}});
}
} // namespace interlock::dem
