/// Checks of user elements: do M, h, q̇, frames, W, χ, bias and prox fit together?
///
///   const Verdict check = checkSystem(toy);
///   EXPECT_TRUE(check) << check.message();  // toy: M[2,1] = 0.3 but M[1,2] = 0.2: not symmetric
///
/// Every derivative is compared with a 4-point difference along the motion q ← q ⊕ s q̇, at random
/// states near the start. The difference carries its own error bound (two step lengths), so that no
/// tolerance has to be guessed per element. Fixed tolerances were rejected: a stiff spring and a
/// slow crane need different ones.
#pragma once
#include <dynamy/law/set_valued_force_law.hpp>
#include <dynamy/simulation/model/model.hpp>
#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

namespace dynamy {

class Registry;
class PluginLoader;

/// True if nothing is wrong; else each wrong entry in words.
class Verdict {
 public:
  explicit operator bool() const { return faults_.empty(); }
  /// One fault per line; "" if there is none.
  std::string message() const;
  const std::vector<std::string>& faults() const { return faults_; }
  void fault(std::string text);
  /// What was not compared with differences, and why: each once.
  const std::vector<std::string>& uncompared() const { return uncompared_; }
  void leftOut(std::string text);
  /// Takes over the faults of a part, and what it left out.
  void add(const Verdict& part);

 private:
  std::vector<std::string> faults_, uncompared_;
};
std::ostream& operator<<(std::ostream& out, const Verdict& check);

struct CheckOptions {
  unsigned seed = 1;
  int states = 6;       ///< random states; a law is checked at 40 times as many arguments
  double reach = 0.05;  ///< longest time for which the start moves at random velocities [s]
  double speed = 1.0;   ///< size of the random velocities added to those of the start [m/s, rad/s]
  bool bias = true;     ///< contacts: compare the bias with differences of γ
};

/// Checks one system by itself: all entries of M and h are written; M is symmetric, positive
/// definite, and constant if so declared; q̇ is affine in u; `move` starts with the rate q̇, and
/// `normalise` does not change its result; with T = ½uᵀMu, along the motion
///
///   h·u + ½uᵀṀu + V̇ = h_nonPotential·u         [W]   (left out where q̇ or V depend on t directly)
///
/// and the same balance for `gravity`; frames: v = J u + ν, ṙ_OS = v_S, Ȧ = Ω × A, A proper
/// orthonormal, β = v̇ at u̇ = 0, equal results at the second call.
Verdict checkSystem(const PartialMechanicalSystem& system, const CheckOptions& options = {});

/// Checks all contact elements of a built model. Every contact counts as closed, for either sign of
/// its gap. W and χ must not depend on u; γ_N = Wᵀu + χ must equal dg/dt [m/s], else the wrong
/// entries of W_N and χ_N are named; the bias must equal dγ/dt at u̇ = 0 [m/s²]; segments must name
/// existing mass blocks. Contacts that are not met near the start, or vanish at states nearby, are
/// listed as left out.
Verdict checkContacts(Model& model, const CheckOptions& options = {});

/// Checks the forces of a built model that state a potential: force·u + V̇ = 0 [W].
Verdict checkForces(Model& model, const CheckOptions& options = {});

/// Checks a force law with `dim` rows at random arguments z = Λ − r ξ: prox is idempotent, does not
/// expand distances in the metric diag(r)⁻¹ (at equal normal force), its result is in C, solutions
/// do not depend on r, Λ·ξ ≤ 0 if 0 ∈ C, `naturalMap` vanishes at solutions, `proxDerivative`
/// equals differences, `status` fits the projection.
Verdict checkLaw(const SetValuedForceLaw& law, int dim, const CheckOptions& options = {});

/// Checks all systems, forces, contacts and laws of a built model. Also checks that a second call
/// of remember() at the same state leaves memory as it is.
Verdict checkModel(Model& model, const CheckOptions& options = {});

/// Checks the model in a file. Errors of the file itself are faults like the others.
Verdict checkModel(const std::filesystem::path& file, Registry& registry, PluginLoader& plugins,
                   const CheckOptions& options = {});

}  // namespace dynamy
