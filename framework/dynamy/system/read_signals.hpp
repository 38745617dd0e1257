/// ReadSignals: the signals that formulas of elements read while forces are evaluated.
///
/// An element requests a signal by its name in connect(), when not all elements are known yet;
/// Model::build() binds all requests once every element has described itself. A signal is a
/// function of t, q, u and the memory of elements, so that a force that reads it is one, too:
/// schemes, searches for switches and derivatives need to know nothing of signals.
///
/// Rejected: values kept for the next evaluation in a fixed order, which needs an order of blocks
/// and would read a signal of the last evaluation where a loop is closed.
#pragma once
#include <dynamy/core/error.hpp>
#include <dynamy/system/description.hpp>
#include <dynamy/system/element_memory.hpp>
#include <string>
#include <vector>

namespace dynamy {

/// One of the signals that elements requested.
struct SignalHandle {
  int index = -1;
};

class ReadSignals {
 public:
  struct Request {
    std::string name;  ///< full name, e.g. "cart.x"
    Place place;       ///< of the name in the model file
    const Element* element = nullptr;
  };
  /// A signal with what its function needs.
  struct Source {
    int signal = -1;  ///< number of the signal in the model
    SignalFunction value;
    int system = -1;  ///< index of its system; −1: it has none
    MemoryHandle memory;
    std::vector<int> systems{};  ///< all that it follows from
  };

  SignalHandle request(std::string_view name, const Place& place, const Element& element);
  const std::vector<Request>& requests() const { return requests_; }
  void bind(std::vector<Source> sources) { sources_ = std::move(sources); }
  double value(SignalHandle h, const Kinematics& k) const;
  /// Numbers of the signals of a loop: a signal that follows from itself at the same instant.
  /// Empty: there is none. Evaluates all signals at k.
  std::vector<int> loop(const Kinematics& k) const;

 private:
  double evaluate(const Source& s, const Kinematics& k) const;
  std::vector<Request> requests_;
  std::vector<Source> sources_;
  /// Signals under evaluation, while loops are looked for; no part of a run.
  mutable std::vector<int>* path_ = nullptr;
};

}  // namespace dynamy
