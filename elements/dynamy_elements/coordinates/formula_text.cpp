#include <algorithm>
#include <dynamy/core/declared/formula_fault.hpp>
#include <dynamy/core/expression/expression_lexer.hpp>
#include <dynamy_elements/coordinates/formula_text.hpp>
#include <numeric>

namespace dynamy {

FormulaText::FormulaText(const Parameters& x, std::string_view attribute)
    : element_(x.name.empty() ? x.type : x.type + " name=\"" + x.name + '"'),
      attribute_(attribute) {
  const ParameterValue& value = x[attribute];
  text_ = value.text;
  split();
  file_ = value.place.file;
  if (!value.locate) {
    if (value.place.line > 0)
      spots_.assign(text_.size() + 1, {value.place.line, value.place.column});
    return;
  }
  file_ = value.locate(0, 1).file;
  spots_.reserve(text_.size() + 1);
  for (std::size_t i = 0; i <= text_.size(); ++i) {
    const Place place = value.locate(i, 1);
    spots_.push_back({place.line, place.column});
  }
}

/// Splits the text into formulas without blanks around them; "||" is an
/// operator and does not end a row.
void FormulaText::split() {
  constexpr std::string_view kBlanks = " \t\r\n";
  if (text_.find_first_not_of(kBlanks) == std::string::npos) return;
  std::size_t begin = 0;
  for (std::size_t i = 0; i <= text_.size(); ++i) {
    const bool end = i == text_.size();
    if (!end && text_.compare(i, 2, "||") == 0) {
      ++i;
      continue;
    }
    if (!end && text_[i] != ';' && text_[i] != '|') continue;
    std::string_view part = std::string_view(text_).substr(begin, i - begin);
    const std::size_t first = std::min(part.find_first_not_of(kBlanks), part.size());
    part.remove_prefix(first);
    part = part.substr(0, part.find_last_not_of(kBlanks) + 1);
    parts_.push_back({std::string(part), begin + first});
    if (end || text_[i] == '|') rowEnd_.push_back(static_cast<int>(parts_.size()));
    begin = i + 1;
  }
}

bool FormulaText::rowsHave(int n) const {
  int begin = 0;
  for (const int end : rowEnd_) {
    if (end - begin != n) return false;
    begin = end;
  }
  return true;
}

int FormulaText::compile(int i, ExpressionCompiler& compiler, Diagnostics& faults) const {
  const ValuePart& part = parts_[static_cast<std::size_t>(i)];
  try {
    return compiler.add(part.text);
  } catch (const ExpressionError& e) {
    faults.add(faultAt(part.offset + e.offset(), e.length(), e.message(), formulaHint(e)));
  }
  return -1;
}

void FormulaText::compileAll(ExpressionCompiler& compiler, Diagnostics& faults) const {
  for (int i = 0; i < size(); ++i) compile(i, compiler, faults);
}

std::vector<std::pair<std::string, Place>> FormulaText::signals(int i) const {
  const ValuePart& part = parts_[static_cast<std::size_t>(i)];
  std::vector<std::pair<std::string, Place>> out;
  for (NameInFormula& signal : signalNames(part.text))
    out.emplace_back(std::move(signal.name),
                     faultAt(part.offset + signal.offset, signal.length, "", "").place);
  return out;
}

Diagnostic FormulaText::fault(int i, std::string text, std::string hint) const {
  if (i < 0) return faultAt(0, text_.size(), std::move(text), std::move(hint));
  const ValuePart& part = parts_[static_cast<std::size_t>(i)];
  return faultAt(part.offset, part.text.size(), std::move(text), std::move(hint));
}

Diagnostic FormulaText::faultAt(std::size_t offset, std::size_t length, std::string text,
                                std::string hint) const {
  Diagnostic d{.element = element_, .text = std::move(text), .hint = std::move(hint)};
  if (spots_.empty()) {
    d.text = attribute_ + "=\"" + text_ + "\": " + d.text;
    return d;
  }
  const std::size_t first = std::min(offset, spots_.size() - 1);
  d.place = Place(file_, spots_[first].line, spots_[first].column);
  // The length ends with the line. It counts characters, and bytes of one character share a column.
  const std::size_t last = std::min(first + std::max<std::size_t>(length, 1), spots_.size()) - 1;
  for (std::size_t i = first; i <= last && spots_[i].line == d.place.line; ++i)
    d.place.length = std::max(1, spots_[i].column - d.place.column + 1);
  return d;
}

std::vector<int> FormulaNames::qSlots() const {
  std::vector<int> out(q.size());
  std::iota(out.begin(), out.end(), 1);
  return out;
}

std::vector<int> FormulaNames::uSlots() const {
  std::vector<int> out(q.size());
  std::iota(out.begin(), out.end(), 1 + n());
  return out;
}

SymbolTable FormulaNames::symbols() const {
  SymbolTable table;
  for (const auto& [name, value] : parameters) table.constant(name, value);
  table.variable("t", kTime);
  for (int i = 0; i < n(); ++i) table.variable(q[static_cast<std::size_t>(i)], qSlot(i));
  for (int i = 0; i < n(); ++i) table.variable(u[static_cast<std::size_t>(i)], uSlot(i));
  for (std::size_t i = 0; i < signals.size(); ++i)
    table.variable(signals[i], 1 + 2 * n() + static_cast<int>(i));
  return table;
}

Tape::Tape(ExpressionSet set, const FormulaNames& names) : set_(std::move(set)), work_(set_) {
  const auto m = static_cast<std::size_t>(set_.outputCount());
  const auto inputs = static_cast<std::size_t>(names.inputs());
  for (auto* buffer : {&value_, &first_, &other_, &second_}) buffer->assign(m, 0.0);
  gradient_.assign(m * inputs, 0.0);
  v_.assign(inputs, 0.0), w_.assign(inputs, 0.0);
}

const double* Tape::eval(const double* x) {
  set_.eval(x, value_.data(), work_);
  return value_.data();
}

const double* Tape::gradient(const double* x, const std::vector<int>& slots) {
  set_.gradient(x, slots, value_.data(), gradient_.data(), work_);
  return gradient_.data();
}

const double* Tape::derivative(const double* x, const double* v) {
  set_.evalD(x, v, value_.data(), first_.data(), work_);
  return first_.data();
}

const double* Tape::second(const double* x, const double* v, const double* w) {
  set_.evalDD(x, v, w, value_.data(), first_.data(), other_.data(), second_.data(), work_);
  return second_.data();
}

const double* Tape::partial(const double* x, int slot) {
  const auto s = static_cast<std::size_t>(slot);
  v_[s] = 1.0;
  derivative(x, v_.data());
  v_[s] = 0.0;
  return first_.data();
}

const double* Tape::secondPartial(const double* x, int i, int j) {
  v_[static_cast<std::size_t>(i)] = 1.0;
  w_[static_cast<std::size_t>(j)] = 1.0;
  second(x, v_.data(), w_.data());
  v_[static_cast<std::size_t>(i)] = 0.0;
  w_[static_cast<std::size_t>(j)] = 0.0;
  return second_.data();
}

bool Tape::dependsOn(const std::vector<int>& slots) const {
  for (int k = 0; k < set_.outputCount(); ++k)
    for (const int s : slots)
      if (set_.dependsOn(k, s)) return true;
  return false;
}

}  // namespace dynamy
