/// BallSweeps: Gauss–Seidel over contacts of balls with Coulomb friction, packed.   (theory 38.5)
///
///   Λ_N ← max(0, Λ_N − ξ_N/G_NN),   Λ_T ← disc of radius μΛ_N (Λ_T − ξ_T/G_TT)
///
/// A contact of balls in space has G_ii = diag(G_NN, G_TT, G_TT), so that this step solves it
/// exactly for fixed forces of the others (theory 4.12). The normal force turns no ball, the linear
/// rows of both bodies are opposite, and M⁻¹ of a ball has two distinct numbers. So a contact takes
/// 27 numbers instead of 72 and a third of the work. Contacts with other laws or bodies form
/// rest(); the caller solves them after a sweep.
///
/// Many contacts are divided into parts by the numbers of their bodies. Contacts within a part are
/// swept first, the parts one after the other or on several threads; contacts between parts follow.
/// The order depends on the problem alone, and so does every bit of the result. Colouring was
/// rejected: it needs ten barriers per sweep instead of one.
#pragma once
#include <dynamy/solver/problem/inclusion_problem.hpp>

namespace dynamy {

class BallSweeps {
 public:
  /// Packs the contacts of balls. False: they are too few, and none is packed. Nothing is allocated
  /// once the arrays are large enough.
  bool prepare(const InclusionProblem& problem);
  bool prepared() const { return !contacts_.empty(); }
  /// Contacts that sweep() leaves out, ascending. \pre prepared()
  const std::vector<int>& rest() const { return rest_; }
  /// Makes one sweep over the packed contacts and updates the sweep velocities of the problem's G,
  /// whose begin() must have been called.
  void sweep(const InclusionProblem& problem, double* Lambda);

 private:
  struct Contact {
    double n[3], t[3], s[3];        ///< linear rows of B: N, T1, T2; of A: their opposite
    double ta[3], sa[3];            ///< angular rows of A: T1, T2
    double tb[3], sb[3];            ///< of B
    double ma, ja, mb, jb;          ///< M⁻¹: linear, angular; 0: no body
    double rN, rT, mu;              ///< 1/G_NN, 1/G_TT
    int ua = -1, ub = -1, row = 0;  ///< first velocities, −1: no body
  };
  static bool pack(const InclusionProblem& problem, int i, Contact& out);
  int partOf(const Contact& c, int velocities) const;
  void solve(const Contact& c, const double* free, double* Lambda, double* v) const;
  std::vector<Contact> contacts_, given_;  ///< sorted by part; in the problem's order
  std::vector<int> first_;  ///< first contact of each part; the last part: contacts between parts
  std::vector<int> rest_;
};

}  // namespace dynamy
