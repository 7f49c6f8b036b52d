// Numbers of a summary for people: four digits and the unit behind.
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace interlock::apps
{
// "pull force at end = 282.1 N" of the key pull_force_at_end_N and its value: the unit is what the
// key ends with, or the one that suits the size of the value: mm below 1 m, us below 1 ms, kN from
// 10 kN, kPa from 1 kPa on. Whole numbers, words and truth values are printed as they are; null,
// which stands for a number that is not finite, as "not finite".
std::string result_text(const std::string& key, const nlohmann::ordered_json& value);
} // namespace interlock::apps
