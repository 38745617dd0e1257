/// FrozenPhase: the motion between two switches, with the status of every contact held
/// (theory 50.1):
///
///   M u̇ = h + W (P π + p₀),   Sᵀ (Wᵀ u̇ + w̄) = 0     ⇒     (Sᵀ G P) π = −Sᵀ (Wᵀ M⁻¹(h + W p₀) + w̄)
///
///   joint, sticking or frictionless closed contact     P = S = I
///   slip of a cone                                     P = e_N − μ t,  S = e_N,  t = γ_T/|γ_T|
///   slip of a reservoir B in several rows              P = e_N − ∇S_B(γ_T),  S = e_N
///   each of several discs over one λ_N                 stick: I;  slip: P = −μ_b t beside e_N
///   slip of a set of given size                        p₀ = −a t, no unknown
///   set on a displacement x: at x = 0; beside it       P = S = I;  p₀ = the force at x
///
/// In one tangent t is a sign that was decided at the switch. It does not flip while stages pass
/// zero, so that the motion continues smoothly past the end of slip, and the path shows the end.
/// Redundant rows share the forces of the last decision, changed as little as possible; the
/// accelerations do not depend on that choice.
#pragma once
#include <array>
#include <dynamy/core/decompositions.hpp>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/stages/mechanical_system.hpp>
#include <span>

namespace dynamy {

/// Names the rows of a contact that have a status of their own: those from `first` on.
struct HeldKey {
  ContactKey key;
  int first = 0;
  bool operator==(const HeldKey& other) const = default;
};

/// One contact with its status, or a part of a contact: the first part has the normal and sliding
/// rows, later parts those of rolling or spinning.
struct Held {
  /// A slip slower than this has the direction that was decided [m/s]. The error of friction that
  /// depends on the slip is its slope times this speed.
  static constexpr double kLeastSlip = 1e-12;
  ContactKey key;
  int first = 0, rows = 0;  ///< first row within the contact, and number of rows; 0: all
  bool slips = false;       ///< slides; for a set on a displacement x: x is not zero, or leaves it
  double sign = 0.0;        ///< sign of γ_T where slip has one direction; sign of x
  /// True: a slip in several rows has just begun, and γ_T is too small to have a direction. The
  /// slip then has the direction of γ̇_T, by an inclusion on acceleration level (theory 20.6).
  bool starts = false;
  double turned = 0.0;  ///< ∫ |γ_T| dθ over the turning direction since the slip started [m/s]
  std::array<double, kMostRows - 1> direction{
      1.0};                  ///< as decided; while the slip starts: the present direction
  double mutedUntil = -1.0;  ///< time until which its force and slip are ignored [s]
  double weight = 1.0;       ///< weight of its forces in redundant rows: λ_N of the decision [N]
  std::array<double, kMostRows> lambda{};  ///< as the last decision gave them [N]
};

class FrozenPhase {
 public:
  enum class Form : std::uint8_t { joint, normal, cone, disc, reservoir, given, notch };

  /// Joints, then closed contacts and sets of given size, in order of emission.
  std::vector<Held> held;

  const Held* find(ContactKey key) const;
  Held* find(ContactKey key);
  const Held* find(HeldKey part) const;
  /// Sorted keys of all held contacts.
  void keys(std::vector<ContactKey>& out) const;
  /// Accelerations from the evaluation `e`, with the velocities u. False: fault() says why.
  bool accelerate(const Evaluation& e, const Eigen::VectorXd& u, Eigen::VectorXd& a);
  /// Half-explicit: forces at the evaluation `e`, with u, such that `before` + τ a does not move in
  /// the held rows of `next`, the contacts at the next position. Only slips that start use the
  /// bias. False: fault() says why.
  bool advance(const Evaluation& e, const Eigen::VectorXd& u, const ContactSet& next,
               const Eigen::VectorXd& before, double tau, Eigen::VectorXd& a);
  /// Where rows are redundant, chooses their forces from now on: between those of the decision and
  /// the smallest ones, the forces that stay furthest from all bounds.
  bool share(const Evaluation& e, const Eigen::VectorXd& u, Eigen::VectorXd& a);
  std::string_view fault() const { return fault_; }
  /// The fault where contact lost() is held but not reported.
  static constexpr std::string_view kLost = "a contact that is held is no longer reported";
  /// The fault where contact lost() slips and its set has no bounds at this slip: a set that
  /// depends on γ^A has become another one, without a gap or the end of a slip as a switch before
  /// it.
  static constexpr std::string_view kOtherSet =
      "the set of a law that slips loses its bounds at some slip: no smooth phase holds past it";
  ContactKey lost() const { return lost_; }

  /// Forces of the last acceleration: rows of held[i] from row0(i) on.
  const Eigen::VectorXd& lambda() const { return lambda_; }
  int row0(std::size_t i) const { return row0_[i]; }
  /// Index of held[i] among the contacts of the last evaluation.
  int contact(std::size_t i) const { return index_[i]; }
  int dim(std::size_t i) const { return row0_[i + 1] - row0_[i]; }
  int rows() const { return row0_.empty() ? 0 : row0_.back(); }
  /// Number of rows of the held contacts, by their dimensions in the evaluation `e`.
  int countRows(const Evaluation& e) const;
  Form form(std::size_t i) const { return form_[i]; }
  /// True: the set of held[i] is nothing but zero, as of a reservoir that is switched off; it has
  /// no status.
  bool idle(std::size_t i) const { return bounds_[i].idle(); }
  /// First row of the slip of held[i]; slipRows(): the number of its rows.
  int slip0(std::size_t i) const {
    return row0_[i] + (form_[i] == Form::cone || form_[i] == Form::reservoir ? 1 : 0);
  }
  int slipRows(std::size_t i) const { return row0_[i + 1] - slip0(i); }
  /// Weight of row r of the slip, so that spins compare with speeds: S_B(e_r) over the largest one.
  double slipWeight(std::size_t i, int r) const {
    return bounds_[i].weight[static_cast<std::size_t>(r)];
  }
  /// γ and γ̇ of the rows of held[i] from row0(i) on, in the last acceleration.
  const Eigen::VectorXd& gamma() const { return gamma_; }
  double gammaDot(int row) const { return gammaDot_[row]; }
  /// Powers in the last acceleration: of forces without potential, friction, normal, joints, moving
  /// ground [W].
  const std::array<double, 5>& power() const { return power_; }
  /// `value`: distance of the force of held[i] from its bound, positive as long as the force
  /// permits the status; to be compared with forceScale(). False: the force has no bound.
  bool margin(std::size_t i, double& value) const;
  double forceScale() const { return forceScale_; }

  /// δ = M⁻¹W Λ with g + Wᵀδ = 0 for the positions g of all held rows; false: all g are zero.
  bool positionCorrection(const Evaluation& e, Eigen::VectorXd& delta);
  /// δ = M⁻¹W Λ with γ + Wᵀδ = 0 for the velocities γ of all held rows; false: all γ are zero.
  bool velocityCorrection(const Evaluation& e, const Eigen::VectorXd& u, Eigen::VectorXd& delta);

  /// True: the law has a set on a displacement x, and h holds x = 0.
  static bool inNotch(const SetValuedForceLaw& law, int dim, const Held& h) {
    NotchedForce unused;
    return !h.slips && law.notched({.dim = dim, .dt = 1.0}, unused);
  }
  /// Form of a law with `dim` rows, and its bounds for forces (Δt = 1).
  struct Bounds {
    Form form = Form::joint;
    double lower = 0.0, upper = 0.0;
    bool idle() const { return form == Form::given && !(upper > lower); }
    const NormalTimesReservoir* set = nullptr;  ///< the reservoir, if the form is one
    std::array<double, kMostRows - 1> weight{1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
  };
  /// Finds the bounds of a law; `first`: first row of the part, in a law of discs. False: the law
  /// has no such form.
  static bool bounds(const SetValuedForceLaw& law, const LawInput& in, Bounds& out, int first = 0);
  /// Finds the bounds of a held contact with the relative velocities `slip`, which are changed.
  /// Trial steps may go past the end of a slip in one direction. There, friction that depends on
  /// the speed continues as the polynomial of degree 3 through its values at 0, v, 2v, 3v. With |v|
  /// it would have a kink there, and each step would end at the kink.
  static bool slipBounds(const SetValuedForceLaw& law, LawInput in, const Held& h, double* slip,
                         Bounds& out);
  /// Parts of a contact with `dim` rows that have a status of their own: first row, number of rows.
  static void parts(const SetValuedForceLaw& law, int dim, std::vector<std::array<int, 2>>& out);

 private:
  /// W column `row` += row `of` of contact `at`.
  static void addRow(const ContactSet& c, int at, int of, Eigen::MatrixXd& W, int row);
  bool shapes(const Evaluation& e);
  bool rowsAhead(const ContactSet& next, const Eigen::VectorXd& before, double tau);
  void startDirections(const Evaluation& e);
  /// Forces for which the kept rows of `R` and `bias` have Rᵀ u̇ + bias = 0.
  void solve(const Evaluation& e, const Eigen::MatrixXd& R, const Eigen::VectorXd& bias);
  double leastMargin() const;
  double gauge(std::size_t i, const double* x) const;
  double normalForce(std::size_t i) const;
  double turnStarting();
  bool gather(const Evaluation& e, const Eigen::VectorXd& u);
  void columns(std::size_t i);
  void finish(const Evaluation& e, const Eigen::VectorXd& u);
  bool correction(const Evaluation& e, Eigen::VectorXd& delta);
  void multiplyByP();
  /// Velocities u0 … u0 + nu − 1 on which a row acts: elsewhere its column of W is zero.
  struct Moved {
    int u0, nu;
  };
  /// Velocities on which a row of the held contacts acts.
  std::span<const Moved> moved(int row) const {
    const auto first = moved0_.begin() + row;
    return {moved_.data() + first[0], moved_.data() + first[1]};
  }
  std::vector<Moved> moved_;
  std::vector<int> moved0_;  // index in moved_ of the first entry of each row, and the end
  std::vector<int> row0_, index_;
  std::vector<Form> form_;
  std::vector<Bounds> bounds_;
  std::string_view fault_;
  ContactKey lost_;
  std::string ownFault_;
  Eigen::MatrixXd W_, MInvW_;  // nu × rows
  Eigen::MatrixXd ahead_;      // W at the next position
  Eigen::MatrixXd P_;          // rows × unknowns
  std::vector<int> kept_;      // S: the row of each unknown
  Eigen::Index normal_ = 0;    // unknown λ_N of the contact whose parts come next
  Eigen::VectorXd p0_, gamma_, bias_, biasAhead_, lambda_, gammaDot_, free_, work_, rhs_, position_,
      scale_;
  Eigen::MatrixXd A_, MP_;
  PseudoInverse inverse_{1e-10};  // pivots below this share belong to redundant rows
  std::vector<double> chi_;
  std::array<double, 5> power_{};
  double forceScale_ = 0.0;
  bool redundant_ = false;
};

/// Speed of a slip γ_T of `rows` rows, spins by their weights [m/s].
double slipSpeed(const FrozenPhase::Bounds& b, int rows, const double* gamma);

}  // namespace dynamy
