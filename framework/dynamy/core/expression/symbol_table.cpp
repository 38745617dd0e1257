#include <algorithm>
#include <dynamy/core/expression/symbol_table.hpp>
#include <stdexcept>

namespace dynamy {

int SymbolTable::variable(const std::string& name) {
  const int slot = variableCount_;
  variable(name, slot);
  return slot;
}

void SymbolTable::variable(const std::string& name, int slot) {
  if (slot < 0) throw std::invalid_argument("SymbolTable: the slot of " + name + " is negative");
  const Symbol* before = find(name);
  const bool hides = before != nullptr && (before->hides || !before->isVariable);
  symbols_[name] = {true, slot, 0.0, hides};
  variableCount_ = std::max(variableCount_, slot + 1);
}

void SymbolTable::constant(const std::string& name, double value) {
  symbols_[name] = {false, 0, value, false};
}

const SymbolTable::Symbol* SymbolTable::find(std::string_view name) const {
  const auto it = symbols_.find(name);
  return it == symbols_.end() ? nullptr : &it->second;
}

std::vector<std::string> SymbolTable::names() const {
  std::vector<std::string> result;
  result.reserve(symbols_.size());
  for (const auto& entry : symbols_) result.push_back(entry.first);
  return result;
}

}  // namespace dynamy
