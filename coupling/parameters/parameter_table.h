// Named, documented, range-checked parameters: each entry of a parameter file is bound once to the
// member that it fills. dealii::ParameterHandler holds the values and checks their patterns; the
// table adds what a full sentence about a wrong value needs: the unit, the allowed values in words,
// and whether the entry must be given.
#pragma once

#include <cstdint>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

// Its header takes ten seconds to compile, and half the program sees this one.
namespace dealii
{
class ParameterHandler;
namespace Patterns
{
class PatternBase;
}
} // namespace dealii

namespace interlock::coupling
{
struct ParameterEntry {
  std::string section;     // empty at the top level
  std::string name;        // words with spaces
  std::string sentence;    // what it is, without the unit
  std::string unit;        // "Pa"; "-" for a pure number; empty where the value is a word
  std::string allowed;     // in words: "a number greater than 0"
  bool required = false;   // has no default
  bool is_path = false;    // of a file or folder
  bool is_input = false;   // of a file whose content belongs to the case
  bool is_text = false;    // any text: a name
  std::string replaced_by; // key of an entry that, where it is given, stands for this one, too

  std::string key() const; // "Section/Name", as `--set` writes it
};

// Numbers that an entry may take.
struct Range {
  double lower = 0;
  double upper = 0;
  bool lower_included = true;
};
extern const Range positive;     // greater than 0
extern const Range not_negative; // 0 or more

class ParameterTable
{
public:
  ParameterTable();
  ~ParameterTable();
  ParameterTable(ParameterTable&&) noexcept;

  // The following entries belong to this section.
  void open_section(const std::string& name);

  // Bind one entry to a member, which must live as long as the table and stay where it is. `text`
  // is a sentence that ends with the unit in brackets, "Young's modulus of the ribs. [Pa]". An
  // entry of `require` must be set; one of `offer` starts as `start`.
  void require(const std::string& name, double& member, const Range& range,
               const std::string& text);
  void require(const std::string& name, int& member, const Range& range, const std::string& text);
  void require(const std::string& name, bool& member, const std::string& text);
  // Must be set unless the entry `other` is given; starts as 0.
  void require_unless(const std::string& other, const std::string& name, double& member,
                      const Range& range, const std::string& text);
  void require_choice(const std::string& name, std::string& member,
                      const std::vector<std::string>& choices, const std::string& text);
  void offer(const std::string& name, double& member, double start, const Range& range,
             const std::string& text);
  void offer(const std::string& name, int& member, int start, const Range& range,
             const std::string& text);
  void offer(const std::string& name, bool& member, bool start, const std::string& text);
  // Numbers with commas between them, none of them less than 0; none at first.
  void offer_list(const std::string& name, std::vector<double>& member, const std::string& text);
  void offer_seed(const std::string& name, std::uint64_t& member, const std::string& text);
  void offer_choice(const std::string& name, std::string& member, const std::string& start,
                    const std::vector<std::string>& choices, const std::string& text);
  void offer_text(const std::string& name, std::string& member, const std::string& text);
  void require_file(const std::string& name, std::string& member, const std::string& text);
  void offer_file(const std::string& name, std::string& member, const std::string& text);
  // Whose content belongs to the case, as much as any entry.
  void offer_input_file(const std::string& name, std::string& member, const std::string& text);
  void offer_folder(const std::string& name, std::string& member, const std::string& text);

  // In the order in which they were declared.
  const std::vector<ParameterEntry>& entries() const { return entries_; }

  // Fills the member with `value`. False, and nothing has changed, when the value is not allowed.
  bool set(const ParameterEntry& entry, const std::string& value);

  // The value as text, as it was set.
  std::string get(const ParameterEntry& entry) const;

private:
  template <typename T>
  void bind(const std::string& name, T& member, const T& start,
            const dealii::Patterns::PatternBase& pattern, const std::string& allowed,
            const std::string& text, bool required);

  std::unique_ptr<dealii::ParameterHandler> handler_;
  std::string section_;
  std::vector<ParameterEntry> entries_;
};

// A complete parameter file with every entry, its sentence as a comment above it, and its present
// value.
void write_parameters(std::ostream& out, const ParameterTable& table);
} // namespace interlock::coupling
