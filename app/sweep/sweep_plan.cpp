#include "sweep/sweep_plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/io/files/csv.hpp>
#include <dynamy/io/files/file_error.hpp>
#include <dynamy/io/files/output_file.hpp>
#include <numbers>
#include <random>
#include <set>

namespace dynamy::app {
namespace {

constexpr std::size_t kMostRuns = 1'000'000;

[[noreturn]] void fail(const std::string& option, const std::string& name, const std::string& text,
                       const std::string& why) {
  throw CLI::ValidationError(option, '"' + name + '=' + text + "\": " + why);
}

/// Splits a text at `separator`, but not inside brackets and braces.
std::vector<std::string> pieces(const std::string& text, char separator) {
  std::vector<std::string> out(1);
  int depth = 0;
  for (const char c : text) {
    depth += (c == '(' || c == '{') ? 1 : (c == ')' || c == '}') ? -1 : 0;
    if (c == separator && depth == 0)
      out.emplace_back();
    else
      out.back() += c;
  }
  return out;
}

/// Reads a number with or without a unit; returns it in SI units.
double quantity(const Variation& v, const std::string& text, const std::string& option) {
  Attribute a;
  a.unit = Unit::any;
  ParameterValue value;
  value.declaration = &a, value.text = text, value.given = true;
  if (const auto fault = readValue(a, value)) fail(option, v.name, text, fault->text);
  return value.numbers.at(0);
}

/// Formats a value with twelve digits: 0.15 and not 0.15000000000000002. The run uses the formatted
/// value.
std::string written(double x) { return fmt::format("{:.12g}", x); }

void readRange(Variation& v, const std::vector<std::string>& part, const std::string& text,
               const std::string& option) {
  const bool log = part.size() == 4 && part[3] == "log";
  if (part.size() < 3 || (part.size() > 3 && !log))
    fail(option, v.name, text, "a range is FROM:TO:COUNT, or FROM:TO:COUNT:log");
  const double from = quantity(v, part[0], option), to = quantity(v, part[1], option);
  const double count = quantity(v, part[2], option);
  if (count != std::floor(count) || count < 2 || count > static_cast<double>(kMostRuns))
    fail(option, v.name, text,
         "the last number of FROM:TO:COUNT is how many values there are: a whole number from 2 on");
  if (log && !(from > 0.0 && to > 0.0))
    fail(option, v.name, text, "a range with equal ratios needs positive bounds");
  // FROM:STEP:TO, as other programs write it, has a last number beyond the second one and whole steps.
  const double steps = (count - from) / to;
  if (!log && from < to && to < 1.0 && steps == std::round(steps))
    v.doubt = fmt::format(
        "{} {}={} is FROM:TO:COUNT, {} values from {} to {}; steps of {} up to {} are {}={}:{}:{}",
        option, v.name, text, part[2], part[0], part[1], part[1], part[2], v.name, part[0], part[2],
        static_cast<long>(steps) + 1);
  for (double i = 0; i < count; ++i) {
    const double s = i / (count - 1);
    v.values.push_back(written(log ? from * std::pow(to / from, s) : from + (to - from) * s));
  }
}

/// Reads "uniform(a,b)" or "normal(m,s)"; false if the text is neither.
bool readDraw(Variation& v, const std::string& text, const std::string& option) {
  const std::size_t open = text.find('(');
  const std::string word = text.substr(0, open);
  if (open == std::string::npos || open == 0 || !text.ends_with(')')) return false;
  if (word != "uniform" && word != "normal")
    fail(option, v.name, text, "draws are uniform(A,B) and normal(MEAN,DEVIATION)");
  const auto part = pieces(text.substr(open + 1, text.size() - open - 2), ',');
  if (part.size() != 2) fail(option, v.name, text, word + " takes two numbers");
  v.draw = word == "uniform" ? Variation::Draw::uniform : Variation::Draw::normal;
  v.a = quantity(v, part[0], option), v.b = quantity(v, part[1], option);
  if (v.draw == Variation::Draw::uniform ? v.a >= v.b : v.b <= 0.0)
    fail(option, v.name, text,
         word == "uniform" ? "the lower bound comes first" : "the deviation must be positive");
  return true;
}

/// A random number, uniform in (0, 1). It is the same on every machine, unlike the distributions of
/// the standard library.
double uniform(std::mt19937_64& random) {
  return (static_cast<double>(random() >> 11) + 0.5) * 0x1p-53;
}

std::string drawn(const Variation& v, std::mt19937_64& random) {
  const double x = uniform(random);
  if (v.draw == Variation::Draw::uniform) return written(v.a + (v.b - v.a) * x);
  const double angle = 2.0 * std::numbers::pi * uniform(random);  // Box and Muller
  return written(v.a + v.b * std::sqrt(-2.0 * std::log(x)) * std::cos(angle));
}

}  // namespace

Variation readVariation(const std::string& name, const std::string& text,
                        const std::string& option) {
  Variation v;
  v.name = name;
  if (readDraw(v, text, option)) return v;
  const auto list = pieces(text, ',');
  const auto range = pieces(text, ':');
  if (list.size() == 1 && range.size() > 1)
    readRange(v, range, text, option);
  else
    v.values = list;
  for (const std::string& value : v.values)
    if (value.empty()) fail(option, name, text, "a value is missing");
  return v;
}

Variation readBounds(const std::string& name, const std::string& text, int count,
                     const std::string& option) {
  if (pieces(text, ':').size() != 2)
    fail(option, name, text, "two bounds are needed, " + name + "=A:B");
  return readVariation(name, text + fmt::format(":{}", count), option);
}

SweepPlan planOf(const std::vector<Variation>& variations, int samples, std::uint64_t seed) {
  SweepPlan plan;
  std::vector<const Variation*> varied;
  bool draws = false;
  for (const Variation& v : variations) {
    if (v.fixed()) continue;
    varied.push_back(&v), plan.names.push_back(v.name);
    draws = draws || v.draw != Variation::Draw::none;
  }
  if (varied.empty())
    throw CLI::ValidationError("sweep", "nothing varies: give --set NAME=FROM:TO:COUNT or a list");
  if (draws != (samples > 0))
    throw CLI::ValidationError("--samples", draws ? "needed: how many values are to be drawn?"
                                                  : "no value is drawn: --set NAME=uniform(A,B)");
  std::size_t runs = draws ? static_cast<std::size_t>(samples) : 1;
  for (const Variation* v : varied) {
    if (v->draw == Variation::Draw::none) runs *= v->values.size();
    if (runs > kMostRuns)
      throw CLI::ValidationError("sweep", fmt::format("more than {} runs", kMostRuns));
  }
  std::mt19937_64 random(seed);
  for (std::size_t row = 0; row < runs; ++row) {
    std::size_t rest = draws ? row / static_cast<std::size_t>(samples) : row;
    std::vector<std::string> values(varied.size());
    for (std::size_t k = varied.size(); k-- > 0;) {
      if (varied[k]->draw != Variation::Draw::none) continue;
      values[k] = varied[k]->values[rest % varied[k]->values.size()];
      rest /= varied[k]->values.size();
    }
    for (std::size_t k = 0; k < varied.size(); ++k)
      if (varied[k]->draw != Variation::Draw::none) values[k] = drawn(*varied[k], random);
    plan.rows.push_back(std::move(values));
  }
  return plan;
}

SweepPlan readTable(const std::string& file) {
  const auto lines = readCsv(readWholeFile(file));
  if (lines.size() < 2) throw FileError(file, "expected a line of names and one line a run");
  SweepPlan plan;
  const std::size_t first = lines[0][0] == "id" ? 1 : 0;
  plan.names.assign(lines[0].begin() + static_cast<std::ptrdiff_t>(first), lines[0].end());
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (lines[i].size() != lines[0].size())
      throw FileError(file + ':' + std::to_string(i + 1),
                      fmt::format("expected {} values", lines[0].size()));
    plan.rows.emplace_back(lines[i].begin() + static_cast<std::ptrdiff_t>(first), lines[i].end());
  }
  return plan;
}

std::string valuesText(const SweepPlan& plan) {
  constexpr std::size_t kAll = 6, kFirst = 3;
  std::string out;
  for (std::size_t k = 0; k < plan.names.size(); ++k) {
    std::vector<std::string> values;
    std::set<std::string> seen;
    for (const auto& row : plan.rows)
      if (seen.insert(row[k]).second) values.push_back(row[k]);
    out += fmt::format(" {} = ", plan.names[k]);
    if (values.size() <= kAll)
      out += fmt::format("{}\n", fmt::join(values, ", "));
    else
      out += fmt::format("{}, … {}   {} values\n",
                         fmt::join(values.begin(), values.begin() + kFirst, ", "), values.back(),
                         values.size());
  }
  return out;
}

std::string manifestText(const SweepPlan& plan) {
  std::string out = "id";
  for (const std::string& name : plan.names) out += ',', appendCsvField(out, name);
  for (std::size_t i = 0; i < plan.rows.size(); ++i) {
    out += fmt::format("\n{}", i + 1);
    for (const std::string& value : plan.rows[i]) out += ',', appendCsvField(out, value);
  }
  return out + '\n';
}

}  // namespace dynamy::app
