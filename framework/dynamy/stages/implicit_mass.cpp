#include <algorithm>
#include <cmath>
#include <dynamy/stages/implicit_mass.hpp>

namespace dynamy {
namespace {

/// Velocities of a group: n³ over kFactor are the work of its factorisation, n² over kSolve that of a solve with
/// its share of Ĝ, in evaluations of one velocity. Of a step with a group of 42 they take 5 and 35 %.
constexpr double kFactor = 4000.0, kSolve = 300.0;

/// f += factor · W_row of contact i.
void addRow(const ContactSet& c, int i, int row, double factor, Eigen::VectorXd& f) {
  const auto at = static_cast<std::size_t>(i);
  for (int k = c.segment0[at]; k < c.segment0[at + 1]; ++k) {
    const Segment& s = c.segment[static_cast<std::size_t>(k)];
    const double* w = c.W.data() + s.w + static_cast<std::ptrdiff_t>(row) * s.nu;
    for (int j = 0; j < s.nu; ++j) f[s.u0 + j] += factor * w[j];
  }
}

/// W_rowᵀ v of contact i.
double along(const ContactSet& c, int i, int row, const Eigen::VectorXd& v) {
  double sum = 0.0;
  const auto at = static_cast<std::size_t>(i);
  for (int k = c.segment0[at]; k < c.segment0[at + 1]; ++k) {
    const Segment& s = c.segment[static_cast<std::size_t>(k)];
    const double* w = c.W.data() + s.w + static_cast<std::ptrdiff_t>(row) * s.nu;
    for (int j = 0; j < s.nu; ++j) sum += w[j] * v[s.u0 + j];
  }
  return sum;
}

}  // namespace

void ImplicitMass::mapBlocks(const MassMatrix& mass) {
  if (!blockOf_.empty()) return;
  blockOf_.assign(static_cast<std::size_t>(nu_), -1);
  for (int b = 0; b < mass.blocks(); ++b)
    for (int j = 0; j < mass.nu(b); ++j) blockOf_[static_cast<std::size_t>(mass.u0(b) + j)] = b;
}

int ImplicitMass::groupRoot(int block) {
  auto& parent = parent_;
  while (parent[static_cast<std::size_t>(block)] != block) {
    int& p = parent[static_cast<std::size_t>(block)];
    block = p = parent[static_cast<std::size_t>(p)];
  }
  return block;
}

/// Groups of the blocks that entries couple, in the order of their blocks.
void ImplicitMass::touch(const MassMatrix& mass, const std::vector<StiffEntry>& entries) {
  mapBlocks(mass);
  const auto blocks = static_cast<std::size_t>(mass.blocks());
  parent_.resize(blocks), group_.assign(blocks, -1);
  for (std::size_t b = 0; b < blocks; ++b) parent_[b] = static_cast<int>(b);
  constexpr int kTouched = 0;
  for (const StiffEntry& e : entries) {
    const int a = groupRoot(blockOf(e.i)), b = groupRoot(blockOf(e.j));
    parent_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    group_[static_cast<std::size_t>(blockOf(e.i))] = kTouched;
    group_[static_cast<std::size_t>(blockOf(e.j))] = kTouched;
  }
  local_.assign(static_cast<std::size_t>(nu_), -1);
  used_ = 0;
  for (int b = 0; b < mass.blocks(); ++b) {
    const auto at = static_cast<std::size_t>(b);
    if (group_[at] < 0) continue;
    const int root = groupRoot(b);  // the first block of its group
    if (root == b) {
      group_[at] = used_++;
      if (groups_.size() < static_cast<std::size_t>(used_)) groups_.emplace_back();
      groups_[static_cast<std::size_t>(group_[at])].u.clear();
    }
    group_[at] = group_[static_cast<std::size_t>(root)];
    Group& g = groups_[static_cast<std::size_t>(group_[at])];
    for (int j = mass.u0(b); j < mass.u0(b) + mass.nu(b); ++j) {
      local_[static_cast<std::size_t>(j)] = static_cast<int>(g.u.size());
      g.u.push_back(j);
    }
  }
}

void ImplicitMass::factor(const MassMatrix& mass, double dt, const WeightedStiffness& stiffness) {
  touch(mass, stiffness.entries);
  for (int k = 0; k < used_; ++k) {
    Group& g = groups_[static_cast<std::size_t>(k)];
    const auto n = static_cast<Eigen::Index>(g.u.size());
    g.Mhat.setZero(n, n);
  }
  for (int b = 0; b < mass.blocks(); ++b) {
    const int k = group_[static_cast<std::size_t>(b)];
    if (k < 0) continue;
    const int at = local_[static_cast<std::size_t>(mass.u0(b))];
    groups_[static_cast<std::size_t>(k)].Mhat.block(at, at, mass.nu(b), mass.nu(b)) = mass.M(b);
  }
  for (std::size_t k = 0; k < stiffness.entries.size(); ++k) {
    const StiffEntry& e = stiffness.entries[k];
    const ImplicitWeights& w = stiffness.weights(k);
    Group& g = groups_[static_cast<std::size_t>(group_[static_cast<std::size_t>(blockOf(e.i))])];
    g.Mhat(local_[static_cast<std::size_t>(e.i)], local_[static_cast<std::size_t>(e.j)]) -=
        w.b * dt * e.D + w.a * dt * dt * e.K;
  }
  for (int k = 0; k < used_; ++k) {
    Group& g = groups_[static_cast<std::size_t>(k)];
    g.lu.compute(g.Mhat);
    const auto n = static_cast<double>(g.u.size());
    work_ += std::ceil(n * n * n / kFactor);
  }
}

void ImplicitMass::applyInverse(const MassMatrix& mass, const Eigen::VectorXd& in,
                                Eigen::VectorXd& out) const {
  mass.applyInverse(view(in), view(out));
  for (int k = 0; k < used_; ++k) solveGroup(groups_[static_cast<std::size_t>(k)], in, out);
}

void ImplicitMass::solveGroup(const Group& g, const Eigen::VectorXd& in,
                              Eigen::VectorXd& out) const {
  const auto n = static_cast<Eigen::Index>(g.u.size());
  part_.resize(n);
  for (Eigen::Index k = 0; k < n; ++k) part_[k] = in[g.u[static_cast<std::size_t>(k)]];
  g.lu.solve(part_, part_);
  for (Eigen::Index k = 0; k < n; ++k) out[g.u[static_cast<std::size_t>(k)]] = part_[k];
}

/// Finds contacts that are coupled: those that share a group, or a mass block without stiff
/// elements.
void ImplicitMass::neighbours(const ContactSet& contacts, int blocks) {
  atBlock_.resize(std::max(atBlock_.size(), static_cast<std::size_t>(blocks + used_)));
  for (std::vector<int>& list : atBlock_) list.clear();
  const auto place = [&](const Segment& s) {
    const int g = group_[static_cast<std::size_t>(s.block)];
    return static_cast<std::size_t>(g < 0 ? s.block : blocks + g);
  };
  const auto forSegments = [&](int i, auto&& call) {
    const auto at = static_cast<std::size_t>(i);
    for (int k = contacts.segment0[at]; k < contacts.segment0[at + 1]; ++k)
      call(contacts.segment[static_cast<std::size_t>(k)]);
  };
  const int n = contacts.size();
  for (int i = 0; i < n; ++i)
    forSegments(i, [&](const Segment& s) {
      std::vector<int>& list = atBlock_[place(s)];
      if (list.empty() || list.back() != i) list.push_back(i);
    });
  near_.resize(std::max(near_.size(), static_cast<std::size_t>(n)));
  for (int i = 0; i < n; ++i) {
    std::vector<int>& near = near_[static_cast<std::size_t>(i)];
    near.clear();
    forSegments(i, [&](const Segment& s) {
      const std::vector<int>& list = atBlock_[place(s)];
      near.insert(near.end(), list.begin(), list.end());
    });
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
  }
}

/// column ← M̂⁻¹ w of a row of contact j, in its blocks and groups.
void ImplicitMass::respond(const ContactSet& contacts, const MassMatrix& mass, int j, int row) {
  const auto at = static_cast<std::size_t>(j);
  addRow(contacts, j, row, 1.0, force_);
  for (int k = contacts.segment0[at]; k < contacts.segment0[at + 1]; ++k) {
    const Segment& s = contacts.segment[static_cast<std::size_t>(k)];
    const int g = group_[static_cast<std::size_t>(s.block)];
    if (g >= 0) {
      const Group& group = groups_[static_cast<std::size_t>(g)];
      solveGroup(group, force_, column_);
      const auto n = static_cast<double>(group.u.size());
      solved_ += n * n / kSolve;
    } else {
      column_.segment(s.u0, s.nu) = mass.inverse(s.block) * force_.segment(s.u0, s.nu);
    }
  }
}

/// Sets force_ and column_ back to zero.
void ImplicitMass::clearResponse(const ContactSet& contacts, int j) {
  const auto at = static_cast<std::size_t>(j);
  for (int k = contacts.segment0[at]; k < contacts.segment0[at + 1]; ++k) {
    const Segment& s = contacts.segment[static_cast<std::size_t>(k)];
    force_.segment(s.u0, s.nu).setZero(), column_.segment(s.u0, s.nu).setZero();
    const int g = group_[static_cast<std::size_t>(s.block)];
    if (g < 0) continue;
    for (const int u : groups_[static_cast<std::size_t>(g)].u) column_[u] = 0.0;
  }
}

void ImplicitMass::delassus(const ContactSet& contacts, const MassMatrix& mass,
                            Delassus& delassus) {
  const int n = contacts.size();
  neighbours(contacts, mass.blocks());
  BlockRows G = delassus.release();
  G.clear();
  G.first.resize(static_cast<std::size_t>(n) + 1, 0);
  std::ptrdiff_t size = 0;
  for (int i = 0; i < n; ++i) {
    for (const int j : near_[static_cast<std::size_t>(i)]) {
      G.column.push_back(j), G.value0.push_back(size);
      size += static_cast<std::ptrdiff_t>(contacts.dim(i)) * contacts.dim(j);
    }
    G.first[static_cast<std::size_t>(i) + 1] = static_cast<int>(G.column.size());
  }
  G.value.resize(static_cast<std::size_t>(size));
  force_.setZero(nu_), column_.setZero(nu_);
  filled_.assign(G.first.begin(), G.first.end());  // columns come in ascending order
  solved_ = 0.0;
  for (int j = 0; j < n; ++j) {
    const std::vector<int>& near = near_[static_cast<std::size_t>(j)];
    for (int c = 0; c < contacts.dim(j); ++c) {
      respond(contacts, mass, j, c);
      for (const int i : near) {
        const auto block = static_cast<std::size_t>(filled_[static_cast<std::size_t>(i)]);
        double* value = G.value.data() + G.value0[block];
        for (int r = 0; r < contacts.dim(i); ++r)
          value[r * contacts.dim(j) + c] = along(contacts, i, r, column_);
      }
      clearResponse(contacts, j);
    }
    for (const int i : near) ++filled_[static_cast<std::size_t>(i)];
  }
  work_ += std::ceil(solved_);
  delassus.given(contacts, std::move(G));
}

void ImplicitMass::addVelocity(const ContactSet& contacts, const MassMatrix& mass,
                               const double* Lambda, Eigen::VectorXd& u) {
  force_.setZero(nu_), column_.resize(nu_);
  for (int i = 0; i < contacts.size(); ++i)
    for (int r = 0; r < contacts.dim(i); ++r)
      addRow(contacts, i, r, Lambda[contacts.row0[static_cast<std::size_t>(i)] + r], force_);
  applyInverse(mass, force_, column_);
  u += column_;
}

}  // namespace dynamy
