/// AnalysisResult: what an analysis of a model writes and prints, e.g. `dynamy orbit MODEL`:
/// runs/MODEL.orbit/orbit.json, and a text or the same JSON on the screen.
#pragma once
#include <dynamy/io/files/json_writer.hpp>
#include <filesystem>
#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace dynamy::app {

struct Program;

class AnalysisResult {
 public:
  /// `name`: of the analysis, of its file and of its folder, e.g. "orbit".
  explicit AnalysisResult(std::string name) : name_(std::move(name)) {}
  /// Declares --out, --plugin, --trust and --json. `files`: names of the files in the folder.
  void declare(CLI::App& command, Program& program, const std::string& files);
  /// The folder of the results of a model file, which is made if there is none.
  std::filesystem::path folder(const std::string& model) const;
  /// Writes NAME.json with these members of its object and prints it, or `text`. `other`: in place
  /// of NAME. \throws FileError
  void tell(const std::string& model, const std::function<void(JsonWriter&)>& members,
            const std::string& text, const std::string& other = {}) const;

 private:
  std::string name_, out_;
  bool json_ = false;
};

}  // namespace dynamy::app
