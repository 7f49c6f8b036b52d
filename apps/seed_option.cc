#include "apps/seed_option.h"

#include "dem/input_error.h"

namespace interlock::apps
{
void add_seed_option(CLI::App& command, std::uint64_t& seed, const std::string& text)
{
  const auto check = [](const std::string& word) -> std::string {
    if (word.empty() || word.size() > 19 ||
        word.find_first_not_of("0123456789") != std::string::npos)
      throw InputError("The option --seed is " + word +
                       ", but must be an integer from 0 to 9999999999999999999.");
    return "";
  };
  command.add_option("--seed", seed, text)->capture_default_str()->check(check);
}
} // namespace interlock::apps
