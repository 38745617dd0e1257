/// The entry of a plug-in: from a file to the plain C struct that says what it is, each step
/// checked before the next.
///
///   headers of the file (no code runs) → dynamic linker (constructors run) → symbol of the entry
///   (a function of this library?) → struct (inside of the library?) → versions (equal?)
#pragma once
#include <dynamy/io/plugin/plugin.hpp>
#include <filesystem>
#include <string>

namespace dynamy {

/// What makes `plugin` unfit for a program with fingerprint `host`, both sides said, with what to
/// do; "" if it fits. Compilers may differ as long as their standard libraries agree.
/// If the numbers of the binary interface differ, nothing else is read.
std::string pluginMismatch(const PluginInfo& plugin, const PluginInfo& host);

/// Loads the library `file` (canonical) for the rest of the program and returns what it says of
/// itself, fit for this program. Nothing is registered yet. Throws ModelError.
const PluginInfo& openPlugin(const std::filesystem::path& file);

}  // namespace dynamy
