#include "apps/shell_word.h"

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <cctype>

namespace interlock::apps
{
std::string shell_word(const std::string& word)
{
  const bool plain = std::all_of(word.begin(), word.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string("_./=+-:,@%").find(c) != std::string::npos;
  });
  if (plain && !word.empty()) return word;
  return "'" + boost::algorithm::replace_all_copy(word, "'", "'\\''") + "'";
}
} // namespace interlock::apps
