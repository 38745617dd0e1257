#include <algorithm>
#include <dynamy/system/kinematics.hpp>
#include <dynamy/system/read_signals.hpp>
#include <limits>
#include <new>

namespace dynamy {
namespace {

/// Thrown by a signal that is under evaluation already.
struct Loop {
  std::vector<int> signals;
};

}  // namespace

SignalHandle ReadSignals::request(std::string_view name, const Place& place,
                                  const Element& element) {
  requests_.push_back({std::string(name), place, &element});
  return {static_cast<int>(requests_.size()) - 1};
}

double ReadSignals::value(SignalHandle h, const Kinematics& k) const {
  const auto i = static_cast<std::size_t>(h.index);
  if (i >= sources_.size()) return std::numeric_limits<double>::quiet_NaN();  // not yet bound
  const Source& s = sources_[i];
  if (path_ == nullptr) return evaluate(s, k);
  const auto again = std::find(path_->begin(), path_->end(), s.signal);
  if (again != path_->end()) throw Loop{{again, path_->end()}};
  path_->push_back(s.signal);
  const double value = evaluate(s, k);
  path_->pop_back();
  return value;
}

double ReadSignals::evaluate(const Source& s, const Kinematics& k) const {
  SignalView v;
  v.t = k.t();
  if (s.system >= 0) new (&v.q) ConstVec(k.q(s.system)), new (&v.u) ConstVec(k.u(s.system));
  new (&v.memory) ConstVec(k.memory(s.memory));
  v.kinematics = &k;
  return s.value(v);
}

std::vector<int> ReadSignals::loop(const Kinematics& k) const {
  std::vector<int> path;
  path_ = &path;
  std::vector<int> found;
  try {
    for (std::size_t i = 0; i < sources_.size(); ++i) {
      path.clear();
      value({static_cast<int>(i)}, k);
    }
  } catch (Loop& loop) {
    found = std::move(loop.signals);
  }
  path_ = nullptr;
  return found;
}

}  // namespace dynamy
