// Field lists: a type says once what it consists of, and is written, read, hashed and compared by
// that.
//
//   template <class Archive> void exchange(Archive& archive, Wall& wall)
//   {
//     archive("corner", wall.corner, "m"); // name, member, unit (none for a pure number)
//     archive("contact", wall.contact);    // a type with a field list of its own
//   }
//
// A list may hold numbers, words, Eigen vectors and quaternions, types with a field list, and
// std::vector, std::optional and std::variant of them. A vector of a type with a field list is
// stored as columns, one array a field and one row an entry; where its fields are themselves lists
// (StoredAsGroups), as one group an entry. In std::variant each type needs `static constexpr const
// char* kind`. `Archive::reading` tells the direction.
#pragma once

#include "coupling/state/field_values.h"
#include "coupling/state/state_tree.h"
#include "dem/input_error.h"

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>

namespace interlock::coupling
{
// Types whose field list holds lists, so that entries of a vector of them differ in size: they say
// so with `static constexpr bool stored_as_groups = true`.
template <class T, class = void> struct StoredAsGroups : std::false_type {
};
template <class T>
struct StoredAsGroups<T, std::void_t<decltype(T::stored_as_groups)>> : std::true_type {
};
template <class... Types> struct StoredAsGroups<std::variant<Types...>> : std::true_type {
};

namespace detail
{
template <class T, class = void> struct HasValidate : std::false_type {
};
template <class T>
struct HasValidate<T, std::void_t<decltype(std::declval<const T&>().validate())>> : std::true_type {
};
} // namespace detail

// Writes into a tree. Objects may be const: a field list only reads them then.
class StateWriter
{
public:
  static constexpr bool reading = false;

  explicit StateWriter(StateTree& tree, std::string prefix = "")
      : tree_(tree), prefix_(std::move(prefix))
  {
  }

  template <class T> void operator()(const char* name, const T& field, const char* unit = "")
  {
    write(prefix_ + name, const_cast<T&>(field), unit);
  }

private:
  // Columns: the rows of a vector, field by field, appended to the same arrays.
  class ColumnWriter;

  template <class T> void write(const std::string& path, T& field, const char* unit)
  {
    if constexpr (detail::FieldValue<T>::known) {
      append(tree_, path, field, unit);
    } else if constexpr (detail::FieldRows<T>::known) {
      using Rows = detail::FieldRows<T>;
      using Value = detail::FieldValue<typename Rows::Value>;
      std::vector<typename Value::Number> numbers(Rows::size(field) * Value::columns);
      for (std::size_t k = 0; k < Rows::size(field); ++k)
        Value::put(Rows::get(field, k), numbers.data() + k * Value::columns);
      tree_[path] = {std::move(numbers), Value::columns, unit};
    } else {
      write_composed(path, field);
    }
  }

  template <class T> void write_composed(const std::string& path, std::vector<T>& list);
  template <class T> void write_composed(const std::string& path, std::optional<T>& field)
  {
    StateWriter inside(tree_, path + "/");
    bool there = field.has_value();
    inside("there", there);
    if (field) inside("value", *field);
  }
  template <class... Types>
  void write_composed(const std::string& path, std::variant<Types...>& field)
  {
    std::visit(
        [&](auto& value) {
          StateWriter inside(tree_, path + "/");
          const std::string kind = std::decay_t<decltype(value)>::kind;
          inside("kind", kind);
          exchange(inside, value);
        },
        field);
  }
  template <class T> void write_composed(const std::string& path, T& object)
  {
    StateWriter inside(tree_, path + "/");
    exchange(inside, object);
  }

  template <class T>
  static void append(StateTree& tree, const std::string& path, const T& value, const char* unit)
  {
    using Value = detail::FieldValue<T>;
    StateArray& array = tree[path];
    if (array.size() == 0) array = {std::vector<typename Value::Number>(), Value::columns, unit};
    auto& numbers = std::get<std::vector<typename Value::Number>>(array.values);
    numbers.resize(numbers.size() + Value::columns);
    Value::put(value, &numbers[numbers.size() - Value::columns]);
  }

  StateTree& tree_;
  std::string prefix_;
};

class StateWriter::ColumnWriter
{
public:
  static constexpr bool reading = false;

  ColumnWriter(StateTree& tree, std::string prefix) : tree_(tree), prefix_(std::move(prefix)) {}

  template <class T> void operator()(const char* name, const T& field, const char* unit = "")
  {
    if constexpr (detail::FieldValue<T>::known) {
      append(tree_, prefix_ + name, field, unit);
    } else {
      ColumnWriter inside(tree_, prefix_ + name + "/");
      exchange(inside, const_cast<T&>(field));
    }
  }

private:
  StateTree& tree_;
  std::string prefix_;
};

template <class T> void StateWriter::write_composed(const std::string& path, std::vector<T>& list)
{
  StateWriter inside(tree_, path + "/");
  const std::size_t count = list.size();
  inside("count", count);
  if constexpr (StoredAsGroups<T>::value) {
    for (std::size_t k = 0; k < count; ++k) inside(std::to_string(k).c_str(), list[k]);
  } else {
    ColumnWriter columns(tree_, path + "/");
    for (T& entry : list) exchange(columns, entry);
  }
}

// Reads from a tree what a StateWriter with the same field lists has written. Throws InputError,
// one sentence that names the path, for what is missing or of another type or size; and whatever
// `validate()` of an object throws, where it has one.
class StateReader
{
public:
  static constexpr bool reading = true;

  explicit StateReader(const StateTree& tree, std::string prefix = "")
      : tree_(tree), prefix_(std::move(prefix)), used_(std::make_shared<std::set<std::string>>())
  {
  }

  template <class T> void operator()(const char* name, T& field, const char* = "")
  {
    read(prefix_ + name, field);
  }

  // Throws InputError when an array below the prefix has not been read.
  void expect_all_read() const
  {
    for (const auto& entry : tree_)
      if (entry.first.compare(0, prefix_.size(), prefix_) == 0 && used_->count(entry.first) == 0)
        throw InputError("The state holds \"" + entry.first +
                         "\", which this version does not know.");
  }

private:
  class ColumnReader;

  StateReader inside(const std::string& path) const
  {
    StateReader reader(tree_, path + "/");
    reader.used_ = used_;
    return reader;
  }

  template <class Number>
  const std::vector<Number>& numbers(const std::string& path, int columns) const
  {
    used_->insert(path);
    const auto entry = tree_.find(path);
    if (entry == tree_.end()) throw InputError("The state lacks \"" + path + "\".");
    const auto* values = std::get_if<std::vector<Number>>(&entry->second.values);
    if (!values || entry->second.columns != columns || values->size() % columns != 0)
      throw InputError("The state holds \"" + path + "\" with another type or shape.");
    return *values;
  }

  template <class T> void read(const std::string& path, T& field)
  {
    if constexpr (detail::FieldValue<T>::known) {
      get(path, 0, 1, field);
    } else if constexpr (detail::FieldRows<T>::known) {
      using Rows = detail::FieldRows<T>;
      using Value = detail::FieldValue<typename Rows::Value>;
      const auto& from = numbers<typename Value::Number>(path, Value::columns);
      Rows::resize(field, from.size() / Value::columns);
      for (std::size_t k = 0; k < Rows::size(field); ++k) {
        typename Rows::Value value;
        Value::get(value, from.data() + k * Value::columns);
        Rows::set(field, k, value);
      }
    } else {
      read_composed(path, field);
    }
  }

  template <class T> void read_composed(const std::string& path, std::vector<T>& list);
  template <class T> void read_composed(const std::string& path, std::optional<T>& field)
  {
    StateReader reader = inside(path);
    bool there = false;
    reader("there", there);
    field.reset();
    if (there) reader("value", field.emplace());
  }
  template <class... Types>
  void read_composed(const std::string& path, std::variant<Types...>& field)
  {
    StateReader reader = inside(path);
    std::string kind;
    reader("kind", kind);
    bool found = false;
    const auto try_type = [&](auto value) {
      if (found || kind != decltype(value)::kind) return;
      exchange(reader, value);
      field = std::move(value);
      found = true;
    };
    (try_type(Types()), ...);
    if (!found)
      throw InputError("The state holds \"" + path + "\" of the kind \"" + kind +
                       "\", which this version does not know.");
  }
  template <class T> void read_composed(const std::string& path, T& object)
  {
    StateReader reader = inside(path);
    exchange(reader, object);
    if constexpr (detail::HasValidate<T>::value) object.validate();
  }

  template <class T>
  void get(const std::string& path, std::size_t row, std::size_t rows, T& field) const
  {
    using Value = detail::FieldValue<T>;
    const auto& from = numbers<typename Value::Number>(path, Value::columns);
    if (from.size() != rows * Value::columns)
      throw InputError("The state holds \"" + path + "\" with " +
                       std::to_string(from.size() / Value::columns) + " rows instead of " +
                       std::to_string(rows) + ".");
    Value::get(field, from.data() + row * Value::columns);
  }

  const StateTree& tree_;
  std::string prefix_;
  std::shared_ptr<std::set<std::string>> used_; // paths, of this reader and those inside
};

class StateReader::ColumnReader
{
public:
  static constexpr bool reading = true;

  ColumnReader(const StateReader& reader, std::string prefix, std::size_t row, std::size_t rows)
      : reader_(reader), prefix_(std::move(prefix)), row_(row), rows_(rows)
  {
  }

  template <class T> void operator()(const char* name, T& field, const char* = "")
  {
    if constexpr (detail::FieldValue<T>::known) {
      reader_.get(prefix_ + name, row_, rows_, field);
    } else {
      ColumnReader inside(reader_, prefix_ + name + "/", row_, rows_);
      exchange(inside, field);
    }
  }

private:
  const StateReader& reader_;
  std::string prefix_;
  std::size_t row_, rows_;
};

template <class T> void StateReader::read_composed(const std::string& path, std::vector<T>& list)
{
  StateReader reader = inside(path);
  std::size_t count = 0;
  reader("count", count);
  list.clear();
  // Not all at once: a number from a file is no reason to reserve memory.
  for (std::size_t k = 0; k < count; ++k) {
    T entry;
    if constexpr (StoredAsGroups<T>::value) {
      reader(std::to_string(k).c_str(), entry);
    } else {
      ColumnReader columns(reader, path + "/", k, count);
      exchange(columns, entry);
    }
    list.push_back(std::move(entry));
  }
}
} // namespace interlock::coupling
