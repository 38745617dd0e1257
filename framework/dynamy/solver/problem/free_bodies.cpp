#include <dynamy/contact/spatial_rows.hpp>
#include <dynamy/solver/problem/free_bodies.hpp>

namespace dynamy {

bool freeBodies(const ContactSet& c, const MassMatrix& mass, std::vector<double>& minvW,
                DiagonalBlocks& diagonal) {
  using Pair = Eigen::Array2d;
  using Load = Eigen::Map<const Pair>;
  if (!spatial::all(c)) return false;
  for (const Segment& s : c.segment)
    if (!mass.inverseDiagonal(s.block)) return false;
  const auto size = static_cast<std::size_t>(c.size());
  diagonal.resize(c);
  for (std::size_t i = 0; i < size; ++i) {
    const int first = c.segment0[i], end = c.segment0[i + 1];
    const Segment* segment = c.segment.data() + first;
    if (end - first > 2 || (end - first == 2 && segment[0].block == segment[1].block)) return false;
    // Six of nine numbers, G_ii is symmetric.
    Pair nn = Pair::Zero(), nt = nn, ns = nn, tt = nn, ts = nn, ss = nn;
    for (int k = first; k < end; ++k, ++segment) {
      const double *W = c.W.data() + spatial::kNumbers * k,
                   *D = mass.inverseDiagonal(segment->block);
      double* M = minvW.data() + spatial::kNumbers * k;
      for (int j = 0; j < 6; j += 2) {
        const Pair d = Load(D + j), n = Load(W + j), t = Load(W + 6 + j), s = Load(W + 12 + j);
        const Pair Mn = n * d, Mt = t * d, Ms = s * d;
        Eigen::Map<Pair>{M + j} = Mn;
        Eigen::Map<Pair>{M + 6 + j} = Mt;
        Eigen::Map<Pair>{M + 12 + j} = Ms;
        nn += n * Mn, nt += n * Mt, ns += n * Ms, tt += t * Mt, ts += t * Ms, ss += s * Ms;
      }
    }
    double* G = diagonal.value.data() + 9 * i;
    G[0] = nn.sum(), G[1] = G[3] = nt.sum(), G[2] = G[6] = ns.sum();
    G[4] = tt.sum(), G[5] = G[7] = ts.sum(), G[8] = ss.sum();
  }
  return true;
}

}  // namespace dynamy
