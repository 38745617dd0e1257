/// RestTrial: whether islands that hardly move would rest by their own forces (theory 58).
///
///   u^E = u^A + M⁻¹(h Δt + W Λ),   −ξ ∈ N_C(Λ):   |u^E| ≤ 1e-8 Δt |M⁻¹h|
///
/// is required of two inclusions of their own, without other islands. With u^A = 0, a body at the
/// top of its path, a tower that begins to tip or a block on a slope that is a little too steep have
/// some u^E that is not zero, however slow they are. With the u^A that they have, a ball that rolls
/// or spins on and whatever creeps keep their u^E, however slow they are: only what one step stops
/// may sleep. Rejected: the speed alone, which is small in all of these.
#pragma once
#include <dynamy/stages/mechanical_system.hpp>
#include <memory>

namespace dynamy {

/// An island whose systems have been slow for some time.
struct QuietIsland {
  std::vector<int> systems;  ///< ascending
  int contacts = 0;
  bool rests = false;  ///< found by the trials
};

class RestTrial {
 public:
  /// `perUnit`: a length over the unit scale of each velocity, which makes all of them speeds [m/s].
  explicit RestTrial(Eigen::VectorXd perUnit) : perUnit_(std::move(perUnit)) {}
  /// Finds out which of the islands rest at x, for a step Δt [s]. All other systems are absent, but
  /// those that stand still (`still`, not 0, per system). Evaluations count as those of `s`.
  void find(MechanicalSystem& s, InclusionSolver& solver, const State& x, double dt,
            const std::vector<char>& still, std::vector<QuietIsland>& islands);
  /// Force of a contact of the islands that rest, rows as in the trial [N]; null: there is none.
  const double* force(ContactKey key, int dim) const;

 private:
  using Group = std::span<QuietIsland>;
  struct Step {
    MechanicalSystem& s;
    InclusionSolver& solver;
    const State& x;
    double dt;
    const std::vector<char>& still;
  };
  void tryAll(const Step& step, Group islands);
  bool solve(const Step& step);
  void viewOf(const Step& step, Group islands);
  void judge(const Step& step, bool solved, Group islands) const;
  void keepForces(double dt);
  double largest(const QuietIsland& island, const Eigen::VectorXd& u) const;

  Eigen::VectorXd perUnit_;
  SystemSubset subset_;
  std::unique_ptr<MechanicalSystem> view_;  // on subset_
  State x_;
  double reach_ = 0.0;  // gaps that count as closed [m]
  KeyIndex index_;
  std::vector<ContactKey> keys_;
  std::vector<int> first_;
  std::vector<double> forces_;
};

}  // namespace dynamy
