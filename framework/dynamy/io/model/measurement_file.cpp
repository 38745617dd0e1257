#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/core/foreign_format.hpp>
#include <dynamy/core/utf8.hpp>
#include <dynamy/io/files/csv.hpp>
#include <dynamy/io/files/output_file.hpp>
#include <dynamy/io/model/measurement_file.hpp>
#include <fstream>
#include <map>

namespace dynamy {
namespace {

constexpr double kNotKnown = std::numeric_limits<double>::quiet_NaN();
constexpr std::string_view kSpaces = " \t\r";

/// A cell without blanks around it, and the byte of its line at which it begins.
struct MeasuredCell {
  std::string text;
  std::size_t at = 0;
};

MeasuredCell trimmedCell(std::string_view text, std::size_t at) {
  const std::size_t begin = text.find_first_not_of(kSpaces);
  if (begin == std::string_view::npos) return {"", at};
  const std::size_t end = text.find_last_not_of(kSpaces);
  return {std::string(text.substr(begin, end - begin + 1)), at + begin};
}

std::vector<MeasuredCell> measuredCells(std::string_view line) {
  std::vector<MeasuredCell> out;
  std::size_t begin = 0;
  bool quoted = false;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    if (i < line.size() && line[i] == '"') quoted = !quoted;
    if (i < line.size() && (quoted || line[i] != ',')) continue;
    std::vector<std::string> field;
    const std::string_view raw = line.substr(begin, i - begin);
    const bool quotes = raw.find('"') != std::string_view::npos;
    if (quotes) readCsvLine(raw, field);
    out.push_back(quotes ? trimmedCell(field.front(), begin) : trimmedCell(raw, begin));
    begin = i + 1;
  }
  return out;
}

/// A column: of times, of a signal or of its standard deviations.
struct MeasuredColumn {
  enum class Kind { time, signal, sigma, wrong };
  Kind kind = Kind::wrong;
  std::string signal;
  double factor = 1.0;  ///< SI value of one unit
  bool hasUnit = false;
  int sigma = -1;  ///< of a signal: the column of its standard deviations
};

bool isNumber(std::string_view text) {
  double x = 0.0;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), x);
  return !text.empty() && end.ec == std::errc() && end.ptr == text.data() + text.size();
}

class MeasurementReader {
 public:
  MeasurementReader(std::string_view text, std::string file, const Model& model)
      : text_(text), file_(std::move(file)), model_(model) {}

  std::vector<MeasuredValue> read() {
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
    refuseBytes();
    while (nextLine()) {
      const std::vector<MeasuredCell> cells = measuredCells(line_);
      if (columns_.empty())
        readHead(cells);
      else
        readRow(cells);
      if (failed_) break;  // without columns nothing below means anything
    }
    if (columns_.empty() && faults_.empty())
      faults_.add({.place = Place(file_),
                   .text = "holds nothing",
                   .hint = "a head is expected, t, ball.z, and a row per instant"});
    if (faults_.empty() && values_.empty())
      faults_.add({.place = Place(file_), .text = "holds no measurements"});
    faults_.throwIfAny();
    return std::move(values_);
  }

 private:
  /// Throws if the file holds no text in UTF-8.
  void refuseBytes() const {
    const auto fail = [this](std::string text, std::string hint) {
      throw ModelError(
          Diagnostic{.place = Place(file_), .text = std::move(text), .hint = std::move(hint)});
    };
    if (const ForeignFormat format = foreignFormat(text_); !format.name.empty())
      fail("is " + std::string(format.name) + ", no text", std::string(format.remedy));
    if (text_.starts_with("\xFF\xFE") || text_.starts_with("\xFE\xFF"))
      fail("the text is UTF-16", "store the file as UTF-8");
    for (std::size_t i = 0; i < text_.size();) {
      const Utf8Character c = nextCharacter(text_, i);
      if (!c.valid || c.code == 0)
        fail("holds bytes that are no text", "a table of measurements is a CSV file in UTF-8");
      i += c.bytes.size();
    }
  }

  /// Moves on to the next line that is neither empty nor a comment.
  bool nextLine() {
    while (!text_.empty()) {
      const std::size_t end = std::min(text_.find('\n'), text_.size());
      line_ = text_.substr(0, end);
      text_.remove_prefix(std::min(end + 1, text_.size()));
      ++number_;
      const std::size_t first = line_.find_first_not_of(kSpaces);
      if (first != std::string_view::npos && line_[first] != '#') return true;
    }
    return false;
  }

  void fault(const MeasuredCell& cell, std::string text, std::string hint = {}) {
    const int length = std::max(1, characterCount(cell.text));
    faults_.add({.place = Place(file_, number_, columnOf(line_, cell.at), length),
                 .text = std::move(text),
                 .hint = std::move(hint),
                 .sourceLine = std::string(line_)});
  }

  /// "ball.z [mm]" → name and unit.
  static std::pair<std::string, std::string> nameAndUnit(const std::string& text) {
    const std::size_t open = text.rfind('[');
    if (open == std::string::npos || text.back() != ']') return {text, ""};
    return {trimmedCell(std::string_view(text).substr(0, open), 0).text,
            trimmedCell(std::string_view(text).substr(open + 1, text.size() - open - 2), 0).text};
  }

  /// "ball.z (mm)" → "ball.z"; "" if no parentheses stand at the end.
  static std::string withoutParentheses(const std::string& text) {
    const std::size_t open = text.rfind('(');
    if (open == std::string::npos || open == 0 || text.back() != ')') return {};
    return trimmedCell(std::string_view(text).substr(0, open), 0).text;
  }

  double factorOf(const MeasuredCell& cell, Unit unit, const std::string& suffix) {
    try {
      return suffix.empty() ? 1.0 : quantityOf(unit, "1" + suffix, cell.text);
    } catch (const ModelError& e) {
      const Diagnostic& d = e.diagnostics().front();
      fault(cell, d.text, d.hint);
      return 1.0;
    }
  }

  MeasuredColumn columnFor(const MeasuredCell& cell) {
    const auto [name, unit] = nameAndUnit(cell.text);
    MeasuredColumn out;
    out.hasUnit = !unit.empty();
    if (name == "t" || name == "time") {
      out.kind = MeasuredColumn::Kind::time, out.factor = factorOf(cell, Unit::time, unit);
      return out;
    }
    const bool sigma = name.starts_with("sigma(") && name.ends_with(')');
    out.signal = sigma ? name.substr(6, name.size() - 7) : name;
    const NamedSignal* signal = model_.signal(out.signal);
    if (signal == nullptr) {
      const std::string bare = withoutParentheses(name);
      if (!bare.empty() && (bare == "t" || bare == "time" || model_.signal(bare) != nullptr)) {
        fault(cell, "a unit stands in brackets",
              "write \"" + bare + " [" +
                  name.substr(name.rfind('(') + 1, name.size() - name.rfind('(') - 2) + "]\"");
        return out;
      }
      std::vector<std::string> known{"t", "time"};
      for (const NamedSignal& s : model_.signals()) known.push_back(s.name);
      fault(cell, "no signal named \"" + out.signal + '"', unknownNameHint(out.signal, known));
      return out;
    }
    out.kind = sigma ? MeasuredColumn::Kind::sigma : MeasuredColumn::Kind::signal;
    out.factor = factorOf(cell, signal->signal.unit, unit);
    return out;
  }

  void readHead(const std::vector<MeasuredCell>& cells) {
    if (cells.size() == 1 && cells[0].text.find_first_of(";\t") != std::string::npos) {
      fault(cells[0], "the cells are not separated by commas", "write t,ball.z");
      failed_ = true;
      return;
    }
    if (std::all_of(cells.begin(), cells.end(), [](const auto& c) { return isNumber(c.text); })) {
      fault(cells[0], "the head is missing: the first row holds numbers",
            "put the names of the columns above them, such as t,ball.z");
      failed_ = true;
      return;
    }
    std::map<std::pair<std::string, int>, int> seen;
    for (const MeasuredCell& cell : cells) {
      columns_.push_back(columnFor(cell));
      const MeasuredColumn& c = columns_.back();
      const int index = static_cast<int>(columns_.size()) - 1;
      if (c.kind == MeasuredColumn::Kind::wrong) continue;
      if (!seen.emplace(std::pair(c.signal, static_cast<int>(c.kind)), index).second)
        fault(cell, "the column \"" + cell.text + "\" is given twice");
    }
    for (const MeasuredColumn& c : columns_)
      failed_ = failed_ || c.kind == MeasuredColumn::Kind::wrong;
    time_ = seen.contains({"", 0}) ? seen.at({"", 0}) : -1;
    if (time_ < 0) {
      fault(cells[0], "no column holds the time",
            "call it t or time, with a unit if it is not s: "
            "t [ms]");
      failed_ = true;
    }
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      MeasuredColumn& c = columns_[i];
      if (c.kind != MeasuredColumn::Kind::sigma) continue;
      const auto of = seen.find({c.signal, static_cast<int>(MeasuredColumn::Kind::signal)});
      if (of == seen.end()) {
        fault(cells[i], "standard deviations of \"" + c.signal + "\", which is no column");
        continue;
      }
      MeasuredColumn& signal = columns_[static_cast<std::size_t>(of->second)];
      signal.sigma = static_cast<int>(i);
      if (!c.hasUnit) c.factor = signal.factor;
    }
  }

  /// The number in a cell; NaN and a fault if it is none.
  double number(const MeasuredCell& cell, double factor) {
    const std::string_view text = std::string_view(cell.text).substr(cell.text[0] == '+' ? 1 : 0);
    double x = 0.0;
    const auto end = std::from_chars(text.data(), text.data() + text.size(), x);
    if (end.ec == std::errc() && end.ptr == text.data() + text.size() && std::isfinite(x))
      return x * factor;
    fault(cell, '"' + cell.text + "\" is no number",
          "leave the cell empty where nothing was measured");
    return kNotKnown;
  }

  void readRow(const std::vector<MeasuredCell>& cells) {
    if (cells.size() != columns_.size()) {
      fault(cells.back(),
            fmt::format("{} cells where the head has {}", cells.size(), columns_.size()));
      return;
    }
    const MeasuredCell& time = cells[static_cast<std::size_t>(time_)];
    const double t = time.text.empty()
                         ? kNotKnown
                         : number(time, columns_[static_cast<std::size_t>(time_)].factor);
    if (time.text.empty()) fault(time, "the time is missing");
    if (std::isnan(t) || !isTime(time, t)) return;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const MeasuredColumn& c = columns_[i];
      if (c.kind != MeasuredColumn::Kind::signal || cells[i].text.empty()) continue;
      MeasuredValue& m = values_.emplace_back();
      m.signal = c.signal, m.t = t, m.value = number(cells[i], c.factor), m.sigma = kNotKnown;
      if (c.sigma < 0) continue;
      const MeasuredCell& sigma = cells[static_cast<std::size_t>(c.sigma)];
      if (sigma.text.empty()) {
        fault(sigma, "the standard deviation of \"" + c.signal + "\" is missing");
        continue;
      }
      m.sigma = number(sigma, columns_[static_cast<std::size_t>(c.sigma)].factor);
      if (m.sigma <= 0.0) fault(sigma, "a standard deviation is > 0");
    }
  }

  bool isTime(const MeasuredCell& cell, double t) {
    const auto [earlier, fresh] = lines_.emplace(t, number_);
    const double end = model_.simulation.until;
    if (!fresh)
      fault(cell, fmt::format("the time {:g} s stands in line {} already", t, earlier->second));
    else if (t < 0.0 || t > end)
      fault(cell,
            fmt::format("the time {:g} s is {} the run, which goes from 0 to {:g} s", t,
                        t < 0.0 ? "before" : "after", end),
            "let the model run longer, or leave the row out");
    else
      return true;
    return false;
  }

  std::string_view text_, line_;
  std::string file_;
  const Model& model_;
  int number_ = 0, time_ = -1;
  std::vector<MeasuredColumn> columns_;
  std::map<double, int> lines_;  // of times
  bool failed_ = false;
  Diagnostics faults_;
  std::vector<MeasuredValue> values_;
};

}  // namespace

std::vector<MeasuredValue> readMeasurements(const std::filesystem::path& file, const Model& model) {
  return measurementsIn(readWholeFile(file), file.string(), model);
}

std::vector<MeasuredValue> measurementsIn(std::string_view text, const std::string& file,
                                          const Model& model) {
  return MeasurementReader(text, file, model).read();
}

std::vector<std::string> measuredNames(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line;
  while (std::getline(in, line))
    if (const std::size_t at = line.find_first_not_of(kSpaces);
        at != std::string::npos && line[at] != '#')
      break;
  std::vector<std::string> out;
  for (const MeasuredCell& cell : measuredCells(line))
    out.push_back(cell.text.substr(0, cell.text.find_first_of(" [")));
  return out;
}

double quantityOf(Unit unit, const std::string& text, const std::string& what) {
  Attribute attribute;
  attribute.unit = unit;
  ParameterValue value;
  value.declaration = &attribute, value.text = text, value.given = true;
  if (const auto fault = readValue(attribute, value))
    throw ModelError('"' + what + "\": " + fault->text, fault->hint);
  return value.numbers[0];
}

}  // namespace dynamy
