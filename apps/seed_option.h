// --seed of the commands that draw random numbers.
#pragma once

#include <CLI/CLI.hpp>

#include <cstdint>
#include <string>

namespace interlock::apps
{
// Takes an integer of 0 or more; CLI11 alone would turn -1 into 2^64 - 1. Throws InputError for
// others when the command line is read.
void add_seed_option(CLI::App& command, std::uint64_t& seed, const std::string& text);
} // namespace interlock::apps
