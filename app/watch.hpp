/// run --watch: runs a model in a separate process, and again whenever one of its files changes.
/// The files are polled four times a second. Polling also notices changes on network file systems
/// and files that an editor replaces. A new process can load a rebuilt plug-in; a process that
/// holds the old library cannot.
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace dynamy::app {

using TellFiles = std::function<void(const std::vector<std::filesystem::path>&)>;

/// Calls `run` at once and again after every change, until Ctrl-C. `run` reports the files that it
/// depends on; the file `model` is watched from the beginning. Ctrl-C ends a running simulation in
/// the same way as without --watch. Returns the exit code.
int watch(const std::string& model, const std::function<int(const TellFiles&)>& run);

}  // namespace dynamy::app
