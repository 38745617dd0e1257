/// ShapeContacts: all contacts between shapes that have a material, one element for the model.
///
///   feature of a shape, half space      g = n·(c − p) − h(−n)         n fixed in the half space
///   ball or point, ball                 g = |c_B − c_A| − R_A − R_B   n = (c_B − c_A)/|…|
///   ball or point, box                  g = |c − p| − R               p of the box, nearest to c
///   polyhedra, boxes among them         vertices on faces, edges on edges (facets.hpp)
///   polyhedron, capsule on a mesh       all that stands out (surface_contact.hpp)
///
///   γ = (n, t1, t2)ᵀ (v_B(P) − v_A(P)),   P the point of contact
///
/// γ_N = ġ holds exactly, also while P moves over a rolling body. The bias includes the velocity Ṗ:
///   γ̇ − Wᵀu̇ = ḋ·v_BA + d·(β_B + Ω_B × (Ṗ − v_B) − β_A − Ω_A × (Ṗ − v_A))
///
/// A contact of two systems that move in one plane has the rows n, t only. PairLaws gives the law
/// of each pair of materials. Equal shapes form a group, and the contact rule is found once per
/// pair of groups, so that 100 000 grains cost no more memory than themselves. BroadPhase finds the
/// shapes that are near each other; half spaces are compared with all shapes.
/// One element per `<Contact>` was rejected: each would need its own search for pairs.
#pragma once
#include <dynamy/contact/non_smooth_element.hpp>
#include <dynamy/law/pair_laws.hpp>
#include <dynamy_elements/contacts/search/broad_phase.hpp>
#include <dynamy_elements/contacts/search/meeting.hpp>
#include <dynamy_elements/contacts/shapes/contact_geometry.hpp>
#include <dynamy_elements/contacts/shapes/contour.hpp>
#include <dynamy_elements/contacts/shapes/polyhedron.hpp>
#include <dynamy_elements/contacts/shapes/surface.hpp>

namespace dynamy {

class Model;
struct SignalView;
struct ContactNumbers;

class ShapeContacts final : public NonSmoothElement {
 public:
  /// `laws`: borrowed from the model.
  explicit ShapeContacts(PairLaws& laws) : laws_(&laws) {}

  /// Finds out which shapes can touch each other. Throws ModelError naming every pair of materials
  /// without a rule or with two, and every pair of shapes whose contact is not implemented.
  void connect(Topology& topology) override;
  void contacts(const Kinematics& k, ContactSink& sink) const override;
  void describe(Description& d) const override;
  std::string contactName(std::uint64_t id) const override;
  int piecesToSweep(const Kinematics& k, double dt) const override;
  Passing firstPassing(const SweptPath& path, int element) const override;
  /// How many pairs of shapes can touch.
  std::int64_t pairs() const { return pairs_; }

 private:
  /// The contact rule of the shapes of two groups.
  struct PairRule {
    Meeting meets = Meeting::never;
    const SetValuedForceLaw* law = nullptr;
    std::size_t plane = 0;       ///< index into `planes_`
    bool grain = false;          ///< one of the two shapes has a grain
    std::uint64_t features = 1;  ///< most contacts of two such shapes
    std::uint64_t followed = 0;  ///< number of the first followed pair of features
    int rows = 4;  ///< normal, tangents, spin about the normal; in a plane normal, tangent
  };
  /// Two shapes, A the one of the higher kind (half space before box before ball); among equal
  /// kinds A has the smaller index.
  struct Pair {
    const PairRule* rule = nullptr;
    const TouchingShape *A = nullptr, *B = nullptr;
    std::uint64_t id = 0;      ///< number of its first contact
    std::size_t i = 0, j = 0;  ///< indices of the shapes, i < j
    explicit operator bool() const { return rule != nullptr; }
  };
  struct Search;
  void group(Search& search);
  void addRule(Search& search, std::size_t a, std::size_t b);
  std::size_t planeIndex(const Vec3& plane, Search& search);
  void countPairs(const Search& search);
  /// Index into `table_` of the shapes i and j.
  std::size_t entry(std::size_t i, std::size_t j) const {
    return static_cast<std::size_t>(group_[i]) * groups_ + static_cast<std::size_t>(group_[j]);
  }
  /// Fills reach_: how far beyond its bounding ball each shape is to be seen [m].
  void lookAhead(const Kinematics& k, const ContactRequest& request) const;
  /// The near pairs of balls_. Throws ModelError if there are more than a step could take.
  const std::vector<BroadPhase::Pair>& nearPairs(std::size_t each) const;
  /// Fills gap_ and way_ of the near pairs; those with gap_ ≤ way_ can touch. It continues from the
  /// values that the half spaces have left in turned_.
  void followTurns(const Kinematics& k, const std::vector<BroadPhase::Pair>& near) const;
  /// Gap of two shapes [m] and its rate [m/s].
  struct Approach {
    double gap = 0.0, rate = 0.0;
  };
  Approach approach(const Kinematics& k, std::size_t i, std::size_t j) const;
  /// The pair of the shapes i, j in any order; false: they never touch.
  Pair pairOf(int i, int j) const;
  void namedAlone(const Kinematics& k, ContactSink& sink) const;
  void narrow(const Pair& pair, const Kinematics& k, ContactSink& sink) const;
  void narrowInPlane(const Pair& pair, const Kinematics& k, ContactSink& sink) const;
  static ContactPoint singleInPlane(const Pair& pair, const Frame& A, const Frame& B,
                                    const Vec3& plane);
  void narrowSmooth(const Pair& pair, const Kinematics& k, ContactSink& sink) const;
  void narrowOnSurface(const Pair& pair, const Kinematics& k, ContactSink& sink) const;
  void narrowFaceted(const Pair& pair, const Kinematics& k, ContactSink& sink) const;
  template <class Found>
  void emitAll(const Pair& pair, const Found& found, int n, const Kinematics& k,
               ContactSink& sink) const;
  // Pairs of features whose contacts appear and vanish, one by one (follow_pairs.cpp).
  static bool comesAndGoes(const Pair& pair);
  void follow(const Pair& pair, const Kinematics& k, ContactSink& sink) const;
  // Pairs of shapes that are noted before they touch (follow_pairs.cpp).
  static bool jumps(const Pair& pair);
  bool waits(const Pair& pair) const;
  template <class Gap>
  bool mayClose(const Pair& pair, const Kinematics& k, const ContactSink& sink, Gap&& gap) const;
  void watch(const Pair& pair, const Kinematics& k, ContactSink& sink) const;
  void watchFlat(const Pair& pair, const OverHalfSpace& over, const Kinematics& k,
                 ContactSink& sink) const;
  template <class Body>
  void followBodies(const Pair& pair, const Body& a, const Body& b, const Kinematics& k,
                    ContactSink& sink) const;
  double reachOf(const Pair& pair, const ContactSink& sink) const;
  double seenFrom(const Pair& pair, const ContactSink& sink) const;
  void overHalfSpace(const Pair& pair, const Kinematics& k, ContactSink& sink) const;
  /// Reports the gap g of a feature; `at` computes the contact if it is closed.
  template <class At>
  void emit(const Pair& pair, std::size_t feature, double g, const Kinematics& k, ContactSink& sink,
            At&& at) const;
  void emitPoint(const Pair& pair, std::size_t feature, const ContactPoint& at, const Kinematics& k,
                 ContactSink& sink) const;
  // Along the path of a step (shape_sweep.cpp).
  /// Calls `f` for the near pairs of balls_, and for each half space with each shape in balls_.
  template <class F>
  void forNearPairs(F&& f) const;
  double gap(const Pair& pair, std::size_t f, const Frame& A, const Frame& B) const;
  /// First passing of feature f, if it begins before `latest` [s].
  Passing passing(const Pair& pair, std::size_t f, const SweptPath& path, double latest) const;

  static ContactNumbers numbers(const Pair& pair, std::uint64_t f);
  double load(const SignalView& v, int ground, int axis) const;
  void makeSurfaces();
  PairLaws* laws_;
  std::vector<Vec3> planes_;  ///< normals of the planes of motion; the first is zero: space
  /// The features of all shapes, in space and in each plane.
  std::vector<std::vector<TouchingShape>> shapes_;
  std::vector<std::unique_ptr<const Surface>> surfaces_;
  std::vector<std::unique_ptr<const Polyhedron>> polyhedra_;
  std::vector<std::unique_ptr<const Contour>> contours_;
  std::vector<int> body_;             ///< per shape; shapes of one body never touch
  std::vector<int> group_;            ///< per shape
  std::vector<int> ground_;           ///< per shape: index into `grounds_`, −1: not on a ground
  std::vector<std::string> grounds_;  ///< names of systems without velocities
  std::vector<double> early_;         ///< per shape: distance at which it is reported [m]
  std::vector<int> flats_;            ///< half spaces
  std::size_t groups_ = 0;
  std::vector<int> table_;  ///< groups × groups: index into `pairRules_`, −1: never
  std::vector<PairRule> pairRules_;
  std::vector<std::string> names_;               ///< per shape
  std::vector<std::pair<int, int>> namedPairs_;  ///< all pairs, if they are few
  std::int64_t pairs_ = 0;
  std::uint64_t features_ = 1;         ///< most contacts of one pair
  double thinnest_ = 0.0;              ///< least thickness of all shapes [m]
  mutable std::vector<double> reach_;  ///< per shape [m]
  mutable double tau_ = 0.0;           ///< time that reach_ looks ahead [s]; 0: all pairs are taken
  mutable std::vector<double> turned_;     ///< per shape [m]
  mutable std::vector<double> gap_, way_;  ///< per near pair: least gap, most approach [m]
  mutable std::vector<int> near_;          ///< pairs of features
  mutable std::vector<Vec3> turns_;        ///< rotation vectors per frame and piece
  mutable std::vector<BroadPhase::Ball> balls_;
  mutable BroadPhase broad_;
};

/// Completion of a model: adds ShapeContacts if any shape has a material.
void addShapeContacts(Model& model);

}  // namespace dynamy
