// An HDF5 file in memory: made, then written to disk like any text; or read from disk, checked,
// then opened. So neither locks, nor a full disk, nor a kill in the middle can leave half a file,
// and errors of the library never reach the terminal.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace interlock::coupling
{
class Hdf5Memory
{
public:
  // An empty file, or the one that these bytes are. Throws std::runtime_error when they are none.
  Hdf5Memory();
  explicit Hdf5Memory(const std::string& bytes);
  ~Hdf5Memory();
  Hdf5Memory(const Hdf5Memory&) = delete;
  Hdf5Memory& operator=(const Hdf5Memory&) = delete;

  // A data set with its groups ("clumps/position"), rows of `columns` values, and its attribute
  // `unit`, unless that is empty. Texts are UTF-8 of variable length.
  void write(const std::string& path, const std::vector<double>& values, int columns,
             const std::string& unit);
  void write(const std::string& path, const std::vector<float>& values, int columns,
             const std::string& unit);
  void write(const std::string& path, const std::vector<int>& values, int columns,
             const std::string& unit);
  void write(const std::string& path, const std::vector<std::int64_t>& values, int columns,
             const std::string& unit);
  void write(const std::string& path, const std::vector<std::uint8_t>& values, int columns,
             const std::string& unit);
  void write(const std::string& path, const std::vector<std::string>& values, int columns,
             const std::string& unit);
  // Of a group or data set that is there.
  void set_attribute(const std::string& path, const std::string& name, double value);
  void set_attribute(const std::string& path, const std::string& name,
                     const std::vector<std::int64_t>& values);
  // ASCII of fixed length.
  void set_attribute(const std::string& path, const std::string& name, const std::string& text);
  void make_group(const std::string& path);
  // Another name, with its groups, for a data set that is there.
  void link(const std::string& path, const std::string& data_set);
  // An object of another file, by its name relative to the folder of this one.
  void link(const std::string& path, const std::string& file, const std::string& object);

  std::string bytes() const;

  // --- Reading ----------------------------------------------------------------------------------
  enum class Type { number, integer, text };
  struct DataSet {
    std::string path;
    Type type = Type::number;
    int columns = 1;
    std::string unit;
  };
  std::vector<DataSet> data_sets() const;
  void read(const std::string& path, std::vector<double>& values) const;
  void read(const std::string& path, std::vector<std::int64_t>& values) const;
  void read(const std::string& path, std::vector<std::string>& values) const;

private:
  std::int64_t file_; // hid_t
};
} // namespace interlock::coupling
