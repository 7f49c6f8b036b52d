// Where the files are that the program reads at run time: scripts, the page of the report, the
// library of geogrids.
#pragma once

#include <filesystem>

namespace interlock::apps
{
// The folder share/interlock of this program. It has the layout of the checkout: apps/figures.py,
// apps/report/, cases/geogrids/. Found by one rule, whether installed or not: the nearest folder
// above the file that holds this code (PREFIX/bin/interlock, a library or a module of Python below
// PREFIX) that has a share/interlock in it; the build folder has one with links to the sources. The
// environment variable INTERLOCK_SHARE names another one, for a program that was copied elsewhere.
// Empty where there is none.
std::filesystem::path shared_folder();
} // namespace interlock::apps
