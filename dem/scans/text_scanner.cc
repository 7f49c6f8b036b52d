#include "dem/scans/text_scanner.h"

#include <charconv>
#include <cmath>

namespace interlock::dem
{
namespace
{
bool ends_line(char c)
{
  return c == '\n' || c == '\r';
}
} // namespace

TextScanner::TextScanner(const InputFile& file, std::string_view text, std::string_view separators,
                         int first_line)
    : file_(file), text_(text), line_(first_line)
{
  for (const unsigned char c : {' ', '\t', '\v', '\f'}) separates_[c] = true;
  for (const unsigned char c : separators) separates_[c] = true;
}

std::string_view TextScanner::word()
{
  const auto separates = [&](char c) { return separates_[static_cast<unsigned char>(c)]; };
  while (position_ < text_.size() && separates(text_[position_])) ++position_;
  const std::size_t start = position_;
  while (position_ < text_.size() && !ends_line(text_[position_]) && !separates(text_[position_]))
    ++position_;
  return text_.substr(start, position_ - start);
}

std::string_view TextScanner::word_on_any_line()
{
  for (;;) {
    const std::string_view result = word();
    if (!result.empty() || !next_line()) return result;
  }
}

bool TextScanner::next_line()
{
  while (position_ < text_.size() && !ends_line(text_[position_])) ++position_;
  if (position_ == text_.size()) return false;
  const std::string_view end = text_.substr(position_, 3);
  const std::size_t length = end.substr(0, 2) == "\r\n" ? 2 : end == "\r\r\n" ? 3 : 1;
  if (is_first_end_) cr_alone_ = end[0] == '\r' && length == 1;
  is_first_end_ = false;
  position_ += cr_alone_ ? 1 : length;
  ++line_;
  return true;
}

void TextScanner::refuse_missing_number() const
{
  file_.refuse("ends or breaks its line too early: a number is missing in line ", line_, ".");
}

void TextScanner::skip_word()
{
  if (word_on_any_line().empty()) refuse_missing_number();
}

double TextScanner::number_or_nan(std::string_view word) const
{
  // from_chars takes no plus sign; "+-1" must not slip through.
  std::string_view digits = word;
  if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (word.empty()) refuse_missing_number();
  if (error != std::errc() || end != digits.data() + digits.size())
    file_.refuse("has ", quoted(word), " in line ", line_, ", where a number must be.");
  return value;
}

double TextScanner::number(std::string_view word) const
{
  const double value = number_or_nan(word);
  if (!std::isfinite(value))
    file_.refuse("has ", quoted(word), ", which is not a finite number, in line ", line_, ".");
  return value;
}

long long TextScanner::integer(std::string_view word) const
{
  long long value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty()) refuse_missing_number();
  if (error != std::errc() || end != word.data() + word.size())
    file_.refuse("has ", quoted(word), " in line ", line_, ", where an integer must be.");
  return value;
}
} // namespace interlock::dem
