/// PairReport: one pair of shapes at one instant, and where its contacts are reported.
///
///   γ = (n, t1, t2)ᵀ (v_B(P) − v_A(P)),   P the point of contact
///
/// γ_N = ġ holds exactly, also while P moves over a rolling body. The bias includes the velocity Ṗ:
///   γ̇ − Wᵀu̇ = ḋ·v_BA + d·(β_B + Ω_B × (Ṗ − v_B) − β_A − Ω_A × (Ṗ − v_A))
#pragma once
#include <dynamy/contact/contact_sink.hpp>
#include <dynamy_elements/contacts/kernels/pair_kernel.hpp>
#include <vector>

namespace dynamy {

/// The contact rule of the shapes of two groups.
struct PairRule {
  const PairKernel* kernel = nullptr;
  const SetValuedForceLaw* law = nullptr;
  std::size_t plane = 0;       ///< number of the plane of motion, 0: space
  bool grain = false;          ///< one of the two shapes has a grain
  std::uint64_t features = 1;  ///< most contacts of two such shapes
  std::uint64_t followed = 0;  ///< number of the first followed pair of features
  int rows = 4;  ///< normal, tangents, spin about the normal; in a plane normal, tangent
  Following following = Following::gaps;
  double work = kGapWork;  ///< of one gap, in evaluations of one velocity
};

class PairReport {
 public:
  /// `id`: number of the pair's first contact. `reach`: up to which gap contacts are reported [m].
  /// `near`: empty room for numbers of features.
  PairReport(const PosedPair& pair, const PairRule& rule, std::uint64_t id, double reach,
             ContactSink& sink, std::vector<int>& near)
      : pair_(pair), rule_(rule), id_(id), reach_(reach), sink_(sink), near_(near) {}
  /// The same pair, reported elsewhere.
  PairReport(const PairReport& of, double reach, ContactSink& sink)
      : PairReport(of.pair_, of.rule_, of.id_, reach, sink, of.near_) {}

  const PosedPair& pair() const { return pair_; }
  const PairRule& rule() const { return rule_; }
  std::uint64_t id() const { return id_; }
  double reach() const { return reach_; }
  ContactSink& sink() const { return sink_; }
  const ContactRequest& request() const { return sink_.request(); }
  std::vector<int>& near() const { return near_; }

  /// Reports the gap g of a feature [m]; `at` computes the contact if it is closed.
  template <class At>
  void add(std::size_t feature, double g, At&& at) {
    // Among many shapes only contacts that can close in the step are reported.
    if (g > reach_) return;
    if (ContactRows rows = sink_.add(id_ + feature, g, *rule_.law, rule_.rows))
      write(rows, feature, at());
  }
  void add(std::size_t feature, const ContactPoint& at) {
    add(feature, at.g, [&]() -> const ContactPoint& { return at; });
  }
  /// Reports the first n of some contacts.
  template <class Found>
  void addAll(const Found& found, int n) {
    for (auto c = found.begin(); c != found.begin() + n; ++c)
      add(static_cast<std::size_t>(c->id), c->at);
  }

 private:
  void write(ContactRows& rows, std::size_t feature, const ContactPoint& found) const;

  const PosedPair& pair_;
  const PairRule& rule_;
  std::uint64_t id_;
  double reach_;
  ContactSink& sink_;
  std::vector<int>& near_;
};

}  // namespace dynamy
