#include "analysis/analysis_result.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <dynamy/io/files/output_file.hpp>

#include "paths.hpp"
#include "program.hpp"

namespace dynamy::app {

namespace fs = std::filesystem;

void AnalysisResult::declare(CLI::App& command, Program& program, const std::string& files) {
  command.add_option("--out", out_, "folder of " + files + "; default: runs/MODEL." + name_)
      ->type_name("DIR")
      ->check(someName());
  addPlugins(command, program);
  command.add_flag("--json", json_, "print JSON");
}

fs::path AnalysisResult::folder(const std::string& model) const {
  const std::string standard = fs::path(model).stem().string() + "." + name_;
  fs::path out = out_.empty() ? fs::path("runs") / standard : fs::path(out_);
  fs::create_directories(out);
  return out;
}

void AnalysisResult::tell(const std::string& model, const std::function<void(JsonWriter&)>& members,
                          const std::string& text, const std::string& other) const {
  std::string json;
  JsonWriter j(json, 2);
  j.beginObject();
  members(j);
  j.endObject();
  json += '\n';
  writeWholeFile(folder(model) / ((other.empty() ? name_ : other) + ".json"), json);
  fmt::print("{}", json_ ? json : text);
}

}  // namespace dynamy::app
