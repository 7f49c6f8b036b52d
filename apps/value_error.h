// Why a value cannot be taken, in words.
#pragma once

#include "coupling/parameters/parameter_table.h"

#include <string>

namespace interlock::apps
{
// A full sentence without the place: the entry, the value and what is allowed. A number with its
// unit typed behind it ("2.4 GPa") is answered with the number to write instead where the unit is
// the entry's own with a decimal prefix.
std::string explain_bad_value(const coupling::ParameterEntry& entry, const std::string& value);
} // namespace interlock::apps
