// Words and numbers of a text file, with the number of the line for the sentences about them.
#pragma once

#include "dem/scans/input_file.h"

#include <array>

namespace interlock::dem
{
// Starts at the start of `text`, which is line `first_line` of the file. Words are separated by
// blanks, tabs and the characters of `separators`. A line ends with LF, CR LF, CR CR LF (a file
// converted twice) or CR alone. Where the first line ends with CR alone, CR and LF end a line each:
// the byte behind the head of a binary file may happen to be an LF.
class TextScanner
{
public:
  TextScanner(const InputFile& file, std::string_view text, std::string_view separators = "",
              int first_line = 1);

  // The next word of this line; empty at its end.
  std::string_view word();
  // The next word of this line or of a later one; empty at the end of the text.
  std::string_view word_on_any_line();
  // Goes to the start of the next line; false when there is none.
  bool next_line();
  // Goes past the next word of any line, a value that nobody asks for and that may be anything
  // ("nan", "-1.#IND"). Throws InputError when the text ends before.
  void skip_word();

  int line() const { return line_; }
  std::size_t position() const { return position_; } // of the next character in the text

  // Numbers in the notation of C whatever the locale. Throw InputError naming line and word when it
  // is none, or not finite, or (integer) does not fit into 64 bits.
  double number(std::string_view word) const;
  long long integer(std::string_view word) const;
  // A number that may be infinite or none ("nan"): that is a fault only where the value is used.
  double number_or_nan(std::string_view word) const;

private:
  [[noreturn]] void refuse_missing_number() const;

  const InputFile& file_;
  std::string_view text_;
  std::array<bool, 256> separates_{};
  std::size_t position_ = 0;
  bool is_first_end_ = true, cr_alone_ = false; // of the line ends
  int line_;
};
} // namespace interlock::dem
