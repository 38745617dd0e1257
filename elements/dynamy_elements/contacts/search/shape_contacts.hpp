/// ShapeContacts: all contacts between shapes that have a material, one element for the model.
///
///   ShapeSet     the shapes, in space and in each plane of motion          at the start
///   PairRules    which of them can touch: kernel, law, rows                at the start
///   NearPairs    which of them are near each other                         at each instant
///   PairKernel   gap, point and directions of the contacts of a pair
///   PairReport   their rows of W, χ and bias
///   ShapeSweep   which contact a fast body passes                          once a step
///
/// A contact of two systems that move in one plane has the rows n, t only. PairLaws gives the law
/// of each pair of materials. One element per `<Contact>` was rejected: each would need its own
/// search for pairs.
#pragma once
#include <dynamy/contact/non_smooth_element.hpp>
#include <dynamy_elements/contacts/search/near_pairs.hpp>
#include <dynamy_elements/contacts/search/shape_sweep.hpp>

namespace dynamy {

class Model;

class ShapeContacts final : public NonSmoothElement {
 public:
  /// `laws`: borrowed from the model.
  explicit ShapeContacts(PairLaws& laws) : laws_(&laws) {}

  /// Finds out which shapes can touch each other. Throws ModelError naming every pair of materials
  /// without a rule or with two, and every pair of shapes whose contact is not implemented.
  void connect(Topology& topology) override;
  void contacts(const Kinematics& k, ContactSink& sink) const override;
  bool nearOnPath(const Kinematics& start, const PathReach& reach, int element,
                  NearContacts& out) const override;
  bool framesOf(std::uint64_t id, std::vector<FrameHandle>& out) const override;
  void describe(Description& d) const override;
  std::string contactName(std::uint64_t id) const override { return rules_.contactName(id); }
  int piecesToSweep(const Kinematics& k, double dt) const override { return sweep_.pieces(k, dt); }
  Passing firstPassing(const SweptPath& path, int element) const override {
    return sweep_.firstPassing(path, element);
  }
  /// How many pairs of shapes can touch.
  std::int64_t pairs() const { return rules_.count(); }

 private:
  /// Whether contacts of a pair are listed, or noted before they touch if nothing can follow them.
  enum class Look : std::uint8_t { here, ahead };
  void report(const TouchingPair& pair, Look look, const Kinematics& k, ContactSink& sink) const;
  void namedAlone(const Kinematics& k, ContactSink& sink) const;
  TouchingPair pairOf(std::uint64_t id) const;

  PairLaws* laws_;
  PairTable kernels_;  ///< of the standard shapes and of those of plug-ins in the model
  ShapeSet shapes_;
  PairRules rules_;
  mutable NearPairs near_;
  mutable ShapeSweep sweep_;
  mutable std::vector<int> features_;        ///< room for numbers of features
  mutable std::vector<TouchingPair> named_;  ///< room for pairs that are requested by key
};

/// Completion of a model: adds ShapeContacts if any shape has a material.
void addShapeContacts(Model& model);

}  // namespace dynamy
