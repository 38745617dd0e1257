#include <dynamy/io/xml/fault_list.hpp>

namespace dynamy {
namespace {

std::string keyOf(const Diagnostic& d) {
  return d.place.format() + '\n' + d.element + '\n' + d.text + '\n' + d.hint;
}

}  // namespace

void FaultList::add(Diagnostic diagnostic) {
  ++added_;
  if (known_.insert(keyOf(diagnostic)).second) items_.push_back(std::move(diagnostic));
  if (full()) throwAll();
}

void FaultList::throwIfAny() const {
  if (!items_.empty()) throwAll();
}

void FaultList::throwAll() const {
  Diagnostics all;
  for (const Diagnostic& d : items_) all.add(d);
  std::vector<Diagnostic> sorted = all.sorted();
  // The last diagnostic says that there may be more errors.
  if (full()) {
    Diagnostic end{.place = sorted.back().place, .text = "reading ends after so many errors"};
    end.hint = "mend the first ones";
    sorted.push_back(std::move(end));
  }
  throw ModelError(std::move(sorted));
}

}  // namespace dynamy
