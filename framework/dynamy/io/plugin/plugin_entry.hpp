/// The entry of a plug-in: the way from a file to the plain C struct that describes the plug-in.
/// Each step is checked before the next.
///
///   headers of the file (no code runs) → dynamic linker (constructors run) → symbol of the entry
///   (a function of this library?) → struct (inside of the library?) → versions (equal?)
#pragma once
#include <dynamy/io/plugin/plugin.hpp>
#include <filesystem>
#include <string>

namespace dynamy {

/// Why `plugin` does not fit a program with fingerprint `host`: the versions of both, and advice;
/// "" if it fits. Compilers may differ as long as their standard libraries agree. If the numbers of
/// the binary interface differ, nothing else is read.
std::string pluginMismatch(const PluginInfo& plugin, const PluginInfo& host);

/// Loads the library `file` (canonical) until the end of the program and returns its plug-in entry,
/// which has been checked to fit this program. Nothing is registered yet. Throws ModelError.
const PluginInfo& openPlugin(const std::filesystem::path& file);

}  // namespace dynamy
