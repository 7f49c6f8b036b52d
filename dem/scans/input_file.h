// A user's file in memory, and the sentences about what is wrong with it.
#pragma once

#include "dem/input_error.h"

#include <sstream>
#include <string>
#include <string_view>

namespace interlock::dem
{
// Reads the whole file at once: readers then never run past the end of a stream, and can compare
// the counts that a file claims with the bytes that it has before they allocate anything.
class InputFile
{
public:
  // `kind` begins each sentence ("Stone mesh"). Throws InputError when the file is missing, is not
  // a regular file, cannot be read, is empty, or is larger than largest_file.
  InputFile(std::string kind, std::string path);
  static constexpr std::size_t largest_file = 2000000000; // [bytes], so that an int counts facets

  std::string_view bytes() const { return bytes_; }
  // The same behind a byte order mark of UTF-8, which editors on Windows put at the head of text.
  std::string_view text() const;
  std::string extension() const; // with the dot, in lower case

  // What the first bytes of text() say that the file is ("a JPEG picture", "an STL mesh"), or
  // empty.
  std::string content() const;

  // Gives the memory back; bytes() and text() are empty afterwards.
  void release() { bytes_ = std::string(); }

  // Throws InputError with the sentence "KIND 'PATH' PARTS".
  template <class... Parts> [[noreturn]] void refuse(const Parts&... parts) const
  {
    std::ostringstream text;
    text << kind_ << " '" << path_ << "' ";
    (text << ... << parts);
    throw InputError(text.str());
  }

private:
  std::string kind_, path_, bytes_;
};

// `word` in quotes, fit for a sentence: shortened, and without control characters.
std::string quoted(std::string_view word);
} // namespace interlock::dem
