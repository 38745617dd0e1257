/// ShapeContacts: all contacts between shapes that have a material, one element for the model.
///
///   ball, point or corner, half space   g = n·(c − p) − R             n fixed in the half space
///   ball or point, ball                 g = |c_B − c_A| − R_A − R_B   n = (c_B − c_A)/|…|
///   ball or point, box                  g = |c − p| − R               p of the box, nearest to c
///   box, box                            vertices on faces, edges on edges (box_contact.hpp)
///
///   γ = (n, t1, t2)ᵀ (v_B(P) − v_A(P)),   P the point of contact
///
/// γ_N = ġ holds exactly, also while P wanders over a rolling body. The bias is that of the moving
/// P:
///   γ̇ − Wᵀu̇ = ḋ·v_BA + d·(β_B + Ω_B × (Ṗ − v_B) − β_A − Ω_A × (Ṗ − v_A))
///
/// A contact of two systems that move in one plane has the rows n, t only. The laws come from
/// ContactRules by pair of materials. One element per `<Contact>` was rejected: each would need its
/// own search for pairs.
#pragma once
#include <dynamy/contact/contact_rule.hpp>
#include <dynamy/contact/non_smooth_element.hpp>
#include <dynamy_elements/contacts/contact_geometry.hpp>

namespace dynamy {

class Model;

class ShapeContacts final : public NonSmoothElement {
 public:
  /// `rules`: borrowed from the model.
  explicit ShapeContacts(std::vector<const ContactRule*> rules) : rules_(std::move(rules)) {}

  /// Finds the pairs. Throws ModelError naming every pair of materials without a rule or with two,
  /// and every pair of shapes whose contact is not implemented.
  void connect(Topology& topology) override;
  void contacts(const Kinematics& k, ContactSink& sink) const override;
  void describe(Description& d) const override;
  std::string contactName(std::uint64_t id) const override;
  int piecesToSweep(const Kinematics& k, double dt) const override;
  Passing firstPassing(const SweptPath& path, int element) const override;
  int pairs() const { return static_cast<int>(pairs_.size()); }

 private:
  /// Two shapes that can touch; A is the half space if there is one, else the box.
  struct Pair {
    TouchingShape A, B;
    const SetValuedForceLaw* law = nullptr;
    Vec3 plane = Vec3::Zero();
    int rows = 4;        ///< normal, tangents, spin about the normal; in a plane normal and tangent
    double balls = 0.0;  ///< boxes whose centres are further apart than this are not looked at [m]
    double offsets = 0.0;  ///< of the centres from the origins of their frames [m]
    std::string name;
  };
  struct Search;
  void addPair(const ShapeInstance& a, const ShapeInstance& b, Search& search);
  void expectOneRulePerPair() const;
  const ContactRule* rule(const std::string& a, const std::string& b) const;
  /// Reports gap g; `at` makes the contact of it if it is closed.
  template <class At>
  void emit(const Pair& pair, std::uint64_t id, double g, const Kinematics& k, ContactSink& sink,
            At&& at) const;
  void boxes(const Pair& pair, std::uint64_t id, const Kinematics& k, ContactSink& sink) const;
  // Along the path of a step (shape_sweep.cpp).
  /// A shape that takes part in a pair, and how far of the frame's origin it reaches [m].
  struct Mover {
    const Shape* shape;
    FrameHandle frame;
    double lever;
  };
  void noteMovers();
  static double thickness(const Pair& pair);
  static double gap(const Pair& pair, std::size_t f, const Frame& A, const Frame& B);
  static Passing passing(const Pair& pair, std::size_t f, const SweptPath& path);
  static constexpr std::uint64_t kMaxFeatures = 256;  ///< of one pair
  std::vector<const ContactRule*> rules_;
  std::vector<Pair> pairs_;
  std::vector<Mover> movers_;
  double thinnest_ = 0.0;  ///< of all pairs [m]
};

/// Completion of a model: adds ShapeContacts if any shape has a material.
void addShapeContacts(Model& model);

}  // namespace dynamy
