/// run --watch: runs in a process of its own, and again whenever one of its files changes. Files
/// are looked at four times a second, which also sees file systems of other machines and files that
/// an editor replaces; a new process loads a plug-in that was built anew, which one that holds the
/// old library cannot.
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace dynamy::app {

using TellFiles = std::function<void(const std::vector<std::filesystem::path>&)>;

/// Calls `run`, which tells the files it depends on; until Ctrl-C, which ends a run that goes on as
/// it always does. `model` is watched from the beginning. Returns the exit code.
int watch(const std::string& model, const std::function<int(const TellFiles&)>& run);

}  // namespace dynamy::app
