/// BallSweeps: Gauss–Seidel over contacts of balls with Coulomb friction, packed.   (theory 38.5)
///
///   Λ_N ← max(0, Λ_N − ξ_N/G_NN),   Λ_T ← disc of radius μΛ_N (Λ_T − ξ_T/G_TT)
///
/// A ball in space has G_ii = diag(G_NN, G_TT, G_TT), so that this is the exact solution of one
/// contact while the others rest (theory 4.12). The normal row turns nobody, linear rows of both
/// bodies are opposite, and M⁻¹ is two numbers: 27 numbers a contact instead of 72, a third of the
/// work. Contacts of other laws and other bodies are the rest, solved by others after a sweep.
///
/// Many contacts are cut into parts by the numbers of their bodies: contacts within a part come
/// first, part after part or on as many threads, those between parts after them. The order depends
/// on the problem alone, and so do the bits. Colours were rejected: ten barriers a sweep instead of
/// one.
#pragma once
#include <dynamy/solver/problem/inclusion_problem.hpp>

namespace dynamy {

class BallSweeps {
 public:
  /// False: too few such contacts, none is taken. No allocation once large enough.
  bool prepare(const InclusionProblem& problem);
  bool prepared() const { return !contacts_.empty(); }
  /// Contacts that are left to others, ascending.  \pre prepared()
  const std::vector<int>& rest() const { return rest_; }
  /// One sweep over all but the rest; the problem's G has begun one, and its velocities follow.
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
  std::vector<Contact> contacts_, given_;  ///< by part; as the problem has them
  std::vector<int> first_;                 ///< per part; the last one is between parts
  std::vector<int> rest_;
};

}  // namespace dynamy
