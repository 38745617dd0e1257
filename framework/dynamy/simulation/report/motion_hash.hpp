/// MotionHash: one number for the motion of a run.
///
/// It covers, bit for bit and in this order, t, q, u and the memory of the elements at the start,
/// then t, q, u, memory and the percussions Λ at the end of each accepted step. The hash does not
/// depend on what is recorded, drawn or checked, on the number of threads, or on whether the run
/// was stopped and resumed. Of systems that sleep, q and u are left out: they keep their bits.
/// Rejected: a hash of the recorded numbers, because one more signal
/// changes it while the motion is the same.
#pragma once
#include <dynamy/core/hash.hpp>
#include <dynamy/simulation/model/observer.hpp>

namespace dynamy {

class MotionHash final : public Observer {
 public:
  std::uint64_t value() const { return hash_.value(); }
  void start(const StepView& initial) override { add(initial.after); }
  void step(const StepView& view) override {
    const SystemSubset* some = view.system.parts().subset;
    some && some->anyRests() ? add(view, *some) : add(view.after);
    hash_.add(std::span(view.Lambda.data(), static_cast<std::size_t>(view.Lambda.size())));
  }
  void archive(Archive& a) override { a(hash_); }

 private:
  void add(const StepView& view, const SystemSubset& some) {
    const State& x = view.after;
    hash_.add(x.t);
    for (const int i : some.systems()) {
      const SystemHandle& s = view.system.parts().topology->system(i);
      hash_.add(std::span(x.q.data() + s.q0, static_cast<std::size_t>(s.nq)));
      hash_.add(std::span(x.u.data() + s.u0, static_cast<std::size_t>(s.nu)));
    }
    hash_.add(std::span(x.memory.data(), static_cast<std::size_t>(x.memory.size())));
  }
  void add(const State& x) {
    hash_.add(x.t);
    for (const Eigen::VectorXd* v : {&x.q, &x.u, &x.memory})
      hash_.add(std::span(v->data(), static_cast<std::size_t>(v->size())));
  }
  Hash hash_;
};

}  // namespace dynamy
