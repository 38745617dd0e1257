/// BiasDifferences: the bias of rows whose element reports none, as the difference of γ along the
/// motion with u held (theory 52.4),
///
///   γ̇ − Wᵀu̇ ≈ (γ(−2d) − 8 γ(−d) + 8 γ(d) − γ(2d)) / (12 d)
#pragma once
#include <dynamy/stages/contact_look.hpp>

namespace dynamy {

class BiasDifferences {
 public:
  /// For these elements (indices, ascending; borrowed). The length of a difference is 1e-3 of the
  /// time in which x passes through `scales` (of velocities, borrowed), at most 1e-3 of `time` [s].
  void of(std::span<const int> elements, const Eigen::VectorXd& scales, double time) {
    elements_ = elements, scales_ = &scales, time_ = time;
  }
  /// Computes the bias of all rows of the requested contacts, taken `aside` of its lengths ahead of
  /// x along the motion. False: the contacts change within the difference.
  bool rates(const MechanicalSystem& s, const State& x, const std::optional<HeldContacts>& held,
             Eigen::VectorXd& out, double aside = 0.0);
  /// Fills the bias of these elements in `c`, evaluated at x with these contacts held. Where
  /// contacts change within all differences, the bias stays as reported.
  void fill(const MechanicalSystem& s, const State& x, const std::optional<HeldContacts>& held,
            ContactSet& c);

 private:
  /// Computes them with a difference of length d [s].
  bool ratesOver(double d, const MechanicalSystem& s, const State& x,
                 const std::optional<HeldContacts>& held, Eigen::VectorXd& out, double aside);
  bool has(const ContactSet& c, int i) const;
  std::span<const int> elements_;
  const Eigen::VectorXd* scales_ = nullptr;
  double time_ = 1.0;
  ContactLook look_;
  State beside_;
  Eigen::VectorXd gamma_, bias_;
};

}  // namespace dynamy
