#include "live/inputs_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <dynamy/io/files/csv.hpp>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/files/json_writer.hpp>
#include <optional>

namespace dynamy::app {
namespace {

constexpr const char* kInputsHead = "step,t,what,name,values\n";

constexpr double kMostSteps = 1e15;  // more than a run can take

struct ActionKind {
  Action::What what;
  const char* name;
  std::size_t values;
};
constexpr ActionKind kActionKinds[] = {
    {Action::What::set, "set", 1},         {Action::What::input, "input", 1},
    {Action::What::grab, "grab", 9},       {Action::What::move, "move", 3},
    {Action::What::release, "release", 0}, {Action::What::end, "end", 0}};

const ActionKind& actionKind(Action::What what) {
  return kActionKinds[static_cast<std::size_t>(what)];
}

/// A finite number that is the whole text.
std::optional<double> numberIn(const std::string& text) {
  char* end = nullptr;
  const double x = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(x)) return {};
  return x;
}

/// Numbers with one blank between them; none if one of them is no number.
std::optional<std::vector<double>> numbersIn(const std::string& text) {
  std::vector<double> out;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t blank = std::min(text.find(' ', from), text.size());
    const auto x = numberIn(text.substr(from, blank - from));
    if (!x) return {};
    out.push_back(*x);
    from = blank + 1;
  }
  return out;
}

std::optional<Action> actionIn(const std::vector<std::string>& fields) {
  if (fields.size() != 5) return {};
  const auto step = numberIn(fields[0]), t = numberIn(fields[1]);
  auto values = numbersIn(fields[4]);
  for (const ActionKind& kind : kActionKinds) {
    if (fields[2] != kind.name) continue;
    if (!step || !t || !values || values->size() != kind.values ||
        !(*step >= 0.0 && *step <= kMostSteps))
      return {};
    return Action{static_cast<long>(*step), *t, kind.what, fields[3], std::move(*values)};
  }
  return {};
}

}  // namespace

const char* nameOf(Action::What what) { return actionKind(what).name; }

InputsFile::InputsFile(const std::filesystem::path& path) : file_(path) {
  std::string head = kInputsHead;
  file_.write(head);
}

void InputsFile::add(const Action& a) {
  std::string line = std::to_string(a.step) + ',';
  appendNumber(line, a.t);
  line += std::string(",") + nameOf(a.what) + ',';
  appendCsvField(line, a.name);
  line += ',';
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    if (i > 0) line += ' ';
    appendNumber(line, a.values[i]);
  }
  line += '\n';
  file_.write(line);
  ++actions_;
}

std::vector<Action> readInputs(const std::filesystem::path& path) {
  const std::string text = readWholeFile(path);
  if (!text.starts_with(kInputsHead))
    throw FileError(path.string(),
                    "is no list of inputs: its first line is not step,t,what,name,values");
  std::vector<Action> out;
  const std::vector<std::vector<std::string>> lines = readCsv(text);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    auto action = actionIn(lines[i]);
    if (!action || (!out.empty() && action->step < out.back().step))
      throw FileError(path.string() + ':' + std::to_string(i + 1),
                      "is no input of a live run, or it does not come after the line before");
    out.push_back(std::move(*action));
  }
  return out;
}

}  // namespace dynamy::app
