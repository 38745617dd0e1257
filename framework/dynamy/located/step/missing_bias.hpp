/// MissingBias: elements that leave out the bias γ̇ − Wᵀu̇ of their rows, or report a wrong one
/// (theory 52.4).
///
/// A missing bias is replaced by a difference of γ along the motion (BiasDifferences),
/// and phases that hold such an element are integrated by the half-explicit rule. A wrong bias is
/// refused with an error that names the element.
#pragma once
#include <dynamy/located/phase/phase_motion.hpp>
#include <dynamy/stages/bias_differences.hpp>
#include <string>

namespace dynamy {

class MissingBias {
 public:
  /// Elements without a bias, ascending.
  const std::vector<int>& elements() const { return elements_; }
  /// The differences that replace the bias of these elements.
  BiasDifferences& differences() { return differences_; }
  /// Takes these differences in the scales of `norm` from now on.
  void use(const ErrorNorm& norm) {
    differences_.of(elements_, norm.velocityScales(), norm.time());
  }
  /// Begins with these elements.
  void elements(const ErrorNorm& norm, std::vector<int> without);
  /// Looks for elements without a bias among the contacts of slot 0, evaluated at x: among those
  /// that `phase` requests, or among the others. True: some are new.
  bool find(const MechanicalSystem& s, const State& x, const ErrorNorm& norm,
            const PhaseRequest& phase, bool held);
  /// Columns of the half-explicit rule that the phase requires; 0: none.
  int columns(const FrozenPhase& phase, double tolerance) const;

  enum class Verdict : std::uint8_t { right, missing, wrong, kinked };
  /// Compares γ̇ = Wᵀu̇ + w̄ of the held contacts, evaluated at p in slot 0, with differences of γ
  /// along the motion. `missing`: find() has found elements; `wrong`: why() names the element.
  /// `kinked`, with the reason in why(): lost() is a contact of two shapes, whose gap has a kink here, for example where
  /// another face becomes the nearest one to a corner that lies inside a body.
  Verdict check(MechanicalSystem& s, const PhasePoint& p, const ErrorNorm& norm,
                const PhaseRequest& phase);
  const std::string& why() const { return why_; }
  ContactKey lost() const { return lost_; }

 private:
  bool has(int element) const;
  bool isFresh(const ContactSet& c, int i, const std::vector<ContactKey>& keys, bool held) const;
  bool reports(const MechanicalSystem& s, const State& x, const ErrorNorm& norm,
               std::vector<int>& found, const std::vector<ContactKey>& keys, bool held);
  void gammaAt(MechanicalSystem& s, const PhasePoint& p, const PhaseRequest& phase, double tau,
               Eigen::VectorXd& gamma);
  int firstWrong(const MechanicalSystem& s, const PhasePoint& p, const ErrorNorm& norm, double d);
  Verdict complain(const MechanicalSystem& s, int row);
  std::vector<int> elements_;
  BiasDifferences differences_;
  std::vector<ContactKey> asked_;
  std::string why_;
  ContactKey lost_;
  State at_;
  Eigen::VectorXd rates_;                 // γ̇ by differences, or velocities of a difference
  Eigen::VectorXd found_;                 // γ̇ along the motion
  Eigen::VectorXd reported_;              // γ̇ by the bias of elements
  std::vector<double> sums_, gammaSums_;  // Σ|W u̇| and Σ|W u| per row
};

}  // namespace dynamy
