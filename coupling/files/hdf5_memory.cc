#include "coupling/files/hdf5_memory.h"

#include <hdf5.h>

#include <atomic>
#include <stdexcept>

namespace interlock::coupling
{
namespace
{
// Closes what the library opened.
class Handle
{
public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close)
  {
    if (id_ < 0) throw std::runtime_error("HDF5 refuses an object in memory");
  }
  ~Handle() { close_(id_); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }

private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

void require(herr_t status)
{
  if (status < 0) throw std::runtime_error("HDF5 fails on a file in memory");
}

// The library prints every error otherwise.
void silence()
{
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

hid_t in_memory(const std::string* bytes)
{
  constexpr std::size_t growth = 1 << 20;
  // HDF5 tells open files apart by their names, those in memory too.
  static std::atomic<int> files{0};
  const std::string name = "memory_" + std::to_string(++files);
  silence();
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  require(H5Pset_fapl_core(access, growth, 0));
  if (!bytes) return H5Fcreate(name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);
  require(H5Pset_file_image(access, const_cast<char*>(bytes->data()), bytes->size()));
  return H5Fopen(name.c_str(), H5F_ACC_RDONLY, access);
}

Handle text_type()
{
  return Handle(H5Tcopy(H5T_C_S1), H5Tclose);
}

template <class T> hid_t type_of();
template <> hid_t type_of<double>()
{
  return H5T_NATIVE_DOUBLE;
}
template <> hid_t type_of<float>()
{
  return H5T_NATIVE_FLOAT;
}
template <> hid_t type_of<int>()
{
  return H5T_NATIVE_INT;
}
template <> hid_t type_of<std::int64_t>()
{
  return H5T_NATIVE_INT64;
}

template <> hid_t type_of<std::uint8_t>()
{
  return H5T_NATIVE_UINT8;
}

void make_variable_text(hid_t type)
{
  require(H5Tset_size(type, H5T_VARIABLE));
  require(H5Tset_cset(type, H5T_CSET_UTF8));
}

void set_unit(hid_t object, const std::string& unit)
{
  if (unit.empty()) return;
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  make_variable_text(type);
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(H5Acreate2(object, "unit", type, space, H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose);
  const char* text = unit.c_str();
  require(H5Awrite(attribute, type, &text));
}

std::string unit_of(hid_t object)
{
  if (H5Aexists(object, "unit") <= 0) return {};
  const Handle attribute(H5Aopen(object, "unit", H5P_DEFAULT), H5Aclose);
  const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  make_variable_text(type);
  char* text = nullptr;
  require(H5Aread(attribute, type, &text));
  std::string unit = text ? text : "";
  H5free_memory(text);
  return unit;
}

// The properties of a link whose groups need not be there; to be closed.
hid_t with_groups()
{
  const hid_t groups = H5Pcreate(H5P_LINK_CREATE);
  require(H5Pset_create_intermediate_group(groups, 1));
  return groups;
}

Handle created(hid_t file, const std::string& path, hid_t type, std::size_t n, int columns)
{
  const hsize_t sizes[2] = {n / columns, static_cast<hsize_t>(columns)};
  const Handle space(H5Screate_simple(columns > 1 ? 2 : 1, sizes, nullptr), H5Sclose);
  const Handle groups(with_groups(), H5Pclose);
  // Equal numbers are equal files: no wall-clock time in them.
  const Handle timeless(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  require(H5Pset_obj_track_times(timeless, false));
  return Handle(H5Dcreate2(file, path.c_str(), type, space, groups, timeless, H5P_DEFAULT),
                H5Dclose);
}

template <class T>
void write_numbers(hid_t file, const std::string& path, const std::vector<T>& values, int columns,
                   const std::string& unit)
{
  const Handle set = created(file, path, type_of<T>(), values.size(), columns);
  if (!values.empty())
    require(H5Dwrite(set, type_of<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
  set_unit(set, unit);
}

void write_attribute(hid_t file, const std::string& path, const std::string& name, hid_t type,
                     hid_t space, const void* values)
{
  const Handle object(H5Oopen(file, path.c_str(), H5P_DEFAULT), H5Oclose);
  const Handle attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
                         H5Aclose);
  require(H5Awrite(attribute, type, values));
}

std::size_t values_in(hid_t set)
{
  const Handle space(H5Dget_space(set), H5Sclose);
  return static_cast<std::size_t>(H5Sget_simple_extent_npoints(space));
}

template <class T> void read_numbers(hid_t file, const std::string& path, std::vector<T>& values)
{
  const Handle set(H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose);
  values.resize(values_in(set));
  if (!values.empty())
    require(H5Dread(set, type_of<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()));
}

Hdf5Memory::Type type_of_set(hid_t set)
{
  const Handle type(H5Dget_type(set), H5Tclose);
  const H5T_class_t kind = H5Tget_class(type);
  if (kind == H5T_STRING) return Hdf5Memory::Type::text;
  return kind == H5T_INTEGER ? Hdf5Memory::Type::integer : Hdf5Memory::Type::number;
}

int columns_of(hid_t set)
{
  const Handle space(H5Dget_space(set), H5Sclose);
  hsize_t sizes[2] = {0, 1};
  const int dimensions = H5Sget_simple_extent_ndims(space);
  if (dimensions > 2) throw std::runtime_error("a data set has more than two dimensions");
  H5Sget_simple_extent_dims(space, sizes, nullptr);
  return dimensions == 2 ? static_cast<int>(sizes[1]) : 1;
}

herr_t list_data_set(hid_t file, const char* path, const H5O_info_t* info, void* list)
{
  if (info->type == H5O_TYPE_DATASET)
    static_cast<std::vector<std::string>*>(list)->emplace_back(path);
  return file < 0 ? -1 : 0;
}
} // namespace

Hdf5Memory::Hdf5Memory() : file_(in_memory(nullptr))
{
  if (file_ < 0) throw std::runtime_error("HDF5 cannot make a file in memory");
}

Hdf5Memory::Hdf5Memory(const std::string& bytes) : file_(in_memory(&bytes))
{
  if (file_ < 0) throw std::runtime_error("this is no HDF5 file");
}

Hdf5Memory::~Hdf5Memory()
{
  H5Fclose(file_);
}

void Hdf5Memory::write(const std::string& path, const std::vector<double>& values, int columns,
                       const std::string& unit)
{
  write_numbers(file_, path, values, columns, unit);
}

void Hdf5Memory::write(const std::string& path, const std::vector<float>& values, int columns,
                       const std::string& unit)
{
  write_numbers(file_, path, values, columns, unit);
}

void Hdf5Memory::write(const std::string& path, const std::vector<int>& values, int columns,
                       const std::string& unit)
{
  write_numbers(file_, path, values, columns, unit);
}

void Hdf5Memory::write(const std::string& path, const std::vector<std::int64_t>& values,
                       int columns, const std::string& unit)
{
  write_numbers(file_, path, values, columns, unit);
}

void Hdf5Memory::write(const std::string& path, const std::vector<std::uint8_t>& values,
                       int columns, const std::string& unit)
{
  write_numbers(file_, path, values, columns, unit);
}

void Hdf5Memory::write(const std::string& path, const std::vector<std::string>& values, int columns,
                       const std::string& unit)
{
  const Handle type = text_type();
  make_variable_text(type);
  const Handle set = created(file_, path, type, values.size(), columns);
  std::vector<const char*> texts;
  for (const std::string& value : values) texts.push_back(value.c_str());
  if (!texts.empty()) require(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, texts.data()));
  set_unit(set, unit);
}

void Hdf5Memory::make_group(const std::string& path)
{
  const Handle group(H5Gcreate2(file_, path.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                     H5Gclose);
}

void Hdf5Memory::set_attribute(const std::string& path, const std::string& name, double value)
{
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  write_attribute(file_, path, name, H5T_NATIVE_DOUBLE, space, &value);
}

void Hdf5Memory::set_attribute(const std::string& path, const std::string& name,
                               const std::vector<std::int64_t>& values)
{
  const hsize_t size = values.size();
  const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
  write_attribute(file_, path, name, H5T_NATIVE_INT64, space, values.data());
}

void Hdf5Memory::set_attribute(const std::string& path, const std::string& name,
                               const std::string& text)
{
  const Handle type = text_type(), space(H5Screate(H5S_SCALAR), H5Sclose);
  require(H5Tset_size(type, text.size()));
  write_attribute(file_, path, name, type, space, text.data());
}

void Hdf5Memory::link(const std::string& path, const std::string& data_set)
{
  const Handle groups(with_groups(), H5Pclose);
  require(H5Lcreate_hard(file_, data_set.c_str(), file_, path.c_str(), groups, H5P_DEFAULT));
}

void Hdf5Memory::link(const std::string& path, const std::string& file, const std::string& object)
{
  require(H5Lcreate_external(file.c_str(), object.c_str(), file_, path.c_str(), H5P_DEFAULT,
                             H5P_DEFAULT));
}

std::string Hdf5Memory::bytes() const
{
  require(H5Fflush(file_, H5F_SCOPE_GLOBAL));
  const ssize_t size = H5Fget_file_image(file_, nullptr, 0);
  if (size < 0) throw std::runtime_error("HDF5 gives no image of a file in memory");
  std::string bytes(static_cast<std::size_t>(size), '\0');
  if (H5Fget_file_image(file_, bytes.data(), bytes.size()) != size)
    throw std::runtime_error("HDF5 gives no image of a file in memory");
  return bytes;
}

std::vector<Hdf5Memory::DataSet> Hdf5Memory::data_sets() const
{
  std::vector<std::string> paths;
  require(H5Ovisit2(file_, H5_INDEX_NAME, H5_ITER_INC, list_data_set, &paths, H5O_INFO_BASIC));
  std::vector<DataSet> sets;
  for (const std::string& path : paths) {
    const Handle set(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), H5Dclose);
    sets.push_back({path, type_of_set(set), columns_of(set), unit_of(set)});
  }
  return sets;
}

void Hdf5Memory::read(const std::string& path, std::vector<double>& values) const
{
  read_numbers(file_, path, values);
}

void Hdf5Memory::read(const std::string& path, std::vector<std::int64_t>& values) const
{
  read_numbers(file_, path, values);
}

void Hdf5Memory::read(const std::string& path, std::vector<std::string>& values) const
{
  const Handle set(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), H5Dclose);
  const Handle type = text_type();
  make_variable_text(type);
  std::vector<char*> texts(values_in(set), nullptr);
  if (!texts.empty()) require(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, texts.data()));
  values.clear();
  for (char* text : texts) {
    values.emplace_back(text ? text : "");
    H5free_memory(text);
  }
}
} // namespace interlock::coupling
