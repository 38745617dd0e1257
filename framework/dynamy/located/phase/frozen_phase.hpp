/// FrozenPhase: the motion between two switches, with the status of every contact held
/// (theory 50.1):
///
///   M u̇ = h + W (P π + p₀),   Sᵀ (Wᵀ u̇ + w̄) = 0     ⇒     (Sᵀ G P) π = −Sᵀ (Wᵀ M⁻¹(h + W p₀) + w̄)
///
///   joint, sticking or frictionless closed contact     P = S = I
///   slip of a cone                                     P = e_N − μ t,  S = e_N,  t = γ_T/|γ_T|
///   slip of a reservoir B in several rows              P = e_N − ∇S_B(γ_T),  S = e_N
///   discs over one λ_N, each of them                   stick: I;  slip: P = −μ_b t beside e_N
///   slip of a set of given size                        p₀ = −a t, no unknown
///   set on a displacement x: at x = 0; beside it       P = S = I;  p₀ = the force at x
///
/// In one tangent t is a sign that was decided at the switch: it does not flip while stages pass
/// zero, so the motion goes on smoothly past its end, and one look at the path finds the end.
/// Redundant rows share what the last decision gave them, changed as little as possible; the
/// accelerations do not depend on it.
#pragma once
#include <array>
#include <dynamy/core/decompositions.hpp>
#include <dynamy/law/most_rows.hpp>
#include <dynamy/stages/mechanical_system.hpp>
#include <span>

namespace dynamy {

/// Which rows of which contact have a status of their own: those from `first` on.
struct HeldKey {
  ContactKey key;
  int first = 0;
  bool operator==(const HeldKey& other) const = default;
};

/// One contact with its status, or a part of one: the first has the normal and sliding, those that
/// follow roll or spin.
struct Held {
  /// A slip slower than this has the direction that was decided [m/s]. Friction that depends on the
  /// slip is off by its slope times this.
  static constexpr double kLeastSlip = 1e-12;
  ContactKey key;
  int first = 0, rows = 0;  ///< of the contact; 0 rows: all
  bool slips = false;       ///< of a set on a displacement x: x is off zero, or leaves it
  double sign = 0.0;        ///< of γ_T, where the slip has one direction; of x
  /// In several rows a slip that has just begun has the direction of γ̇_T, by an inclusion on
  /// acceleration level: γ_T is too small to have one (theory 20.6).
  bool starts = false;
  double turned = 0.0;  ///< ∫ |γ_T| dθ of the turning direction since [m/s]
  std::array<double, kMostRows - 1> direction{
      1.0};                  ///< decided; of a slip that starts: the present one
  double mutedUntil = -1.0;  ///< its force and slip are not looked at before [s]
  double weight = 1.0;       ///< of its forces where rows are redundant: λ_N of the decision [N]
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
  /// Sorted keys of all.
  void keys(std::vector<ContactKey>& out) const;
  /// Accelerations from what is evaluated in `e`, with u. False: fault() says why.
  bool accelerate(const Evaluation& e, const Eigen::VectorXd& u, Eigen::VectorXd& a);
  /// Half-explicit: forces at what is evaluated in `e`, with u, such that `before` + τ a does not
  /// move in the held rows of `next`, the contacts at the position that follows; no bias is used
  /// but by slips that start. False: fault() says why.
  bool advance(const Evaluation& e, const Eigen::VectorXd& u, const ContactSet& next,
               const Eigen::VectorXd& before, double tau, Eigen::VectorXd& a);
  /// Where rows are redundant: the forces, between those of the decision and the smallest, that
  /// keep furthest from all bounds, from now on.
  bool share(const Evaluation& e, const Eigen::VectorXd& u, Eigen::VectorXd& a);
  std::string_view fault() const { return fault_; }
  /// The fault where contact lost() is held and not reported.
  static constexpr std::string_view kLost = "a contact that is held is no longer reported";
  /// The fault where the set of lost(), which slips, has no bounds at this slip: a set that depends
  /// on γ^A has become another one, which neither a gap nor the end of a slip announces.
  static constexpr std::string_view kOtherSet =
      "the set of a law that slips loses its bounds at some slip: no smooth phase holds past it";
  ContactKey lost() const { return lost_; }

  /// Forces of the last acceleration: rows of held[i] from row0(i) on.
  const Eigen::VectorXd& lambda() const { return lambda_; }
  int row0(std::size_t i) const { return row0_[i]; }
  /// Number of held[i] among the contacts of the last evaluation.
  int contact(std::size_t i) const { return index_[i]; }
  int dim(std::size_t i) const { return row0_[i + 1] - row0_[i]; }
  int rows() const { return row0_.empty() ? 0 : row0_.back(); }
  /// The number of rows that the phase has in `e`, which reports its contacts.
  int countRows(const Evaluation& e) const;
  Form form(std::size_t i) const { return form_[i]; }
  /// A set that is nothing but zero, a reservoir that is switched off: no status to look at.
  bool idle(std::size_t i) const { return bounds_[i].idle(); }
  /// First row of the slip of held[i], and their number.
  int slip0(std::size_t i) const {
    return row0_[i] + (form_[i] == Form::cone || form_[i] == Form::reservoir ? 1 : 0);
  }
  int slipRows(std::size_t i) const { return row0_[i + 1] - slip0(i); }
  /// What row r of the slip is worth, so that spins compare with speeds: S_B(e_r) over the largest.
  double slipWeight(std::size_t i, int r) const {
    return bounds_[i].weight[static_cast<std::size_t>(r)];
  }
  /// γ and γ̇ of the same rows in the last acceleration.
  const Eigen::VectorXd& gamma() const { return gamma_; }
  double gammaDot(int row) const { return gammaDot_[row]; }
  /// Power of the last acceleration: without potential, friction, normal, joints, moving ground
  /// [W].
  const std::array<double, 5>& power() const { return power_; }
  /// Number that is positive as long as the force of held[i] permits the status, over the largest
  /// force; not for those without a bound (false).
  bool margin(std::size_t i, double& value) const;
  double forceScale() const { return forceScale_; }

  /// δ = M⁻¹W Λ with g + Wᵀδ = 0 for all positions of the rows that are held; false: none is off.
  bool positionCorrection(const Evaluation& e, Eigen::VectorXd& delta);
  /// The same with γ of the held rows.
  bool velocityCorrection(const Evaluation& e, const Eigen::VectorXd& u, Eigen::VectorXd& delta);

  /// Is x = 0 held of a law whose set lives on displacements?
  static bool inNotch(const SetValuedForceLaw& law, int dim, const Held& h) {
    NotchedForce unused;
    return !h.slips && law.notched({.dim = dim, .dt = 1.0}, unused);
  }
  /// Form of a law with `dim` rows, and its numbers for forces (Δt = 1); false: it has none.
  struct Bounds {
    Form form = Form::joint;
    double lower = 0.0, upper = 0.0;
    bool idle() const { return form == Form::given && !(upper > lower); }
    const NormalTimesReservoir* set = nullptr;  ///< of a reservoir
    std::array<double, kMostRows - 1> weight{1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
  };
  /// `first`: of the part of a law of discs.
  static bool bounds(const SetValuedForceLaw& law, const LawInput& in, Bounds& out, int first = 0);
  /// The same for one that is held, with the relative velocities `slip`, which are changed. Past
  /// the end of a slip in one direction, where steps that are still to be cut go, friction that
  /// depends on the speed goes on as the polynomial of degree 3 through its values at 0, v, 2v, 3v:
  /// with |v| it would have a kink there, and each step would end at it.
  static bool slipBounds(const SetValuedForceLaw& law, LawInput in, const Held& h, double* slip,
                         Bounds& out);
  /// The parts of a contact with `dim` rows that have a status of their own: first row and number.
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
  /// Velocities that a row of W moves; others of its column are zero.
  struct Moved {
    int u0, nu;
  };
  /// Those of a row of the held contacts.
  std::span<const Moved> moved(int row) const {
    const auto first = moved0_.begin() + row;
    return {moved_.data() + first[0], moved_.data() + first[1]};
  }
  std::vector<Moved> moved_;
  std::vector<int> moved0_;  // the first of each row, and the end
  std::vector<int> row0_, index_;
  std::vector<Form> form_;
  std::vector<Bounds> bounds_;
  std::string_view fault_;
  ContactKey lost_;
  std::string ownFault_;
  Eigen::MatrixXd W_, MInvW_;  // nu × rows
  Eigen::MatrixXd ahead_;      // W at the position that follows
  Eigen::MatrixXd P_;          // rows × unknowns
  std::vector<int> kept_;      // S: the row of each unknown
  Eigen::Index normal_ = 0;    // unknown of the contact whose parts follow
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
