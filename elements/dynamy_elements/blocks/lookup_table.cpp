#include <algorithm>
#include <charconv>
#include <cmath>
#include <dynamy/core/foreign_format.hpp>
#include <dynamy/system/announced_signals.hpp>
#include <dynamy_elements/blocks/lookup_table.hpp>
#include <fstream>
#include <limits>

namespace dynamy {
namespace {

constexpr std::size_t kMostLines = 1000000;

/// The numbers of a line, separated by commas, semicolons or blanks; empty if it has other words.
std::vector<double> numbersOf(const std::string& line) {
  std::vector<double> out;
  const char* at = line.data();
  const char* const end = at + line.size();
  const auto separates = [](char c) {
    return c == ',' || c == ';' || c == ' ' || c == '\t' || c == '\r';
  };
  while (true) {
    while (at != end && separates(*at)) ++at;
    if (at == end) return out;
    double value = 0.0;
    const auto [stop, error] = std::from_chars(at, end, value);
    if (error != std::errc() || (stop != end && !separates(*stop)) || !std::isfinite(value))
      return {};
    out.push_back(value), at = stop;
  }
}

}  // namespace

void LookupTable::declare(Attributes& a) {
  a.about(
      "Function given by points (x, y): linear between them, held beyond them. The points stand in "
      "the model, or in two columns of a CSV file. Signal: out.");
  a.add(AttributeType::expression, "of", std::nullopt,
        "x as a formula of t and signals, where the function is taken");
  Attribute& points =
      a.add(AttributeType::vector, "points", std::nullopt, "points x y x y …, x ascending");
  points.unit = Unit::any, points.size = 0;
  points.mayBeAbsent();
  a.add(AttributeType::text, "file", std::nullopt,
        "CSV file beside the model; lines that do not begin with numbers are names")
      .mayBeAbsent();
  a.add(AttributeType::integer, "column", "2", "column of y in the file; x is column 1")
      .between(2, 10000);
  a.example("<Table name=\"map\" of=\"cart.vx\" points=\"0 0  1 2  3 2.5\"/>");
}

LookupTable::LookupTable(const Parameters& x) : ExternalForce(x), of_(x, "of", 1) {
  if (x.has("points") == x.has("file"))
    throw ModelError("either points or a file has to be given", "points=\"0 0  1 2\"");
  if (x.has("file")) {
    read(x);
  } else {
    const std::vector<double>& n = x["points"].numbers;
    if (n.size() % 2 != 0)
      throw x["points"].fault("the last point has no y", "points are pairs x y", 0,
                              x["points"].text.size());
    for (std::size_t i = 0; i < n.size(); i += 2) x_.push_back(n[i]), y_.push_back(n[i + 1]);
  }
  const ParameterValue& given = x[x.has("file") ? "file" : "points"];
  if (x_.empty()) throw given.fault("there is no point", "", 0, given.text.size());
  for (std::size_t i = 1; i < x_.size(); ++i)
    if (!(x_[i] > x_[i - 1]))
      throw given.fault(
          "x of point " + std::to_string(i + 1) + " is not above that of the one before",
          "x " + numberText(x_[i]) + " after " + numberText(x_[i - 1]), 0, given.text.size());
}

void LookupTable::read(const Parameters& x) {
  const ParameterValue& file = x["file"];
  std::ifstream in(file.existingFile());
  std::string begin(8, '\0');
  in.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  if (const ForeignFormat format = foreignFormat(begin); !format.name.empty())
    throw file.fault("the file is " + std::string(format.name) + ", no text",
                     std::string(format.remedy), 0, file.text.size());
  in.clear(), in.seekg(0);
  const auto column = static_cast<std::size_t>(x["column"].integer());
  std::string line;
  for (std::size_t n = 1; std::getline(in, line); ++n) {
    const std::vector<double> numbers = numbersOf(line);
    if (n > kMostLines)
      throw file.fault("the file has more than " + std::to_string(kMostLines) + " lines", "", 0,
                       file.text.size());
    if (numbers.empty() && x_.empty()) continue;  // names
    if (numbers.empty() && line.find_first_not_of(" \t\r") == std::string::npos) continue;
    if (numbers.size() < column)
      throw file.fault("line " + std::to_string(n) + " of the file has no " +
                           std::to_string(column) + " numbers",
                       "", 0, file.text.size());
    x_.push_back(numbers[0]), y_.push_back(numbers[column - 1]);
  }
}

double LookupTable::at(double x) const {
  if (std::isnan(x)) return x;
  const auto next = std::upper_bound(x_.begin(), x_.end(), x);
  if (next == x_.begin()) return y_.front();
  if (next == x_.end()) return y_.back();
  const auto i = static_cast<std::size_t>(next - x_.begin());
  const double part = (x - x_[i - 1]) / (x_[i] - x_[i - 1]);
  return y_[i - 1] + part * (y_[i] - y_[i - 1]);
}

double LookupTable::nextInstant(double t) const {
  double next = of_.nextInstant(t);
  const std::optional<std::pair<double, double>> line = of_.lineInTime();
  if (!line || line->second == 0.0) return next;
  for (const double x : x_)
    if (const double at = (x - line->first) / line->second; at > t) next = std::min(next, at);
  return next;
}

void LookupTable::describe(Description& d) const {
  d.signal("out", Unit::any, "value of the function",
           [this](const SignalView& v) { return at(of_.value(*v.kinematics)); });
  announceInstants(d, [this](double t) { return nextInstant(t); });
}

}  // namespace dynamy
