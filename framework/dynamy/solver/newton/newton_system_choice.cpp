#include <algorithm>
#include <dynamy/solver/newton/newton_system.hpp>

namespace dynamy {
namespace {

/// Velocities of the largest mass block up to which the equations in velocities are sparse.
constexpr int kMaxSparse = 6;
/// Velocities of all touched mass blocks up to which dense equations in velocities are used.
constexpr int kMaxDense = 96;

}  // namespace

NewtonSystem* NewtonSystemChoice::prepare(const InclusionProblem& p) {
  velocities_ = false;
  if (p.G->hasBodies()) {
    const TouchedVelocities v = touchedVelocities(p, seen_);
    const bool sparse = v.largest <= kMaxSparse;
    if (v.count > 0 && v.count < p.rows() && (sparse || v.count <= kMaxDense)) {
      auto& form = inVelocities_[v.largest <= 3 ? 0 : (sparse ? 1 : 2)];
      if (!form) form = NewtonSystem::inVelocities(v.largest);
      velocities_ = form->prepare(p);
      if (velocities_) return form.get();
    }
  }
  int dim = 1;
  for (int i = 0; i < p.size(); ++i) dim = std::max(dim, p.dim(i));
  if (!percussions_ || percussionDim_ != dim) percussions_ = NewtonSystem::inPercussions(dim);
  percussionDim_ = dim;
  return percussions_ && percussions_->prepare(p) ? percussions_.get() : nullptr;
}

TouchedVelocities touchedVelocities(const InclusionProblem& p, std::vector<char>& seen) {
  TouchedVelocities out;
  seen.assign(static_cast<std::size_t>(p.G->mass().blocks()), 0);
  for (const Segment& s : p.contacts->segment) {
    if (seen[s.block]) continue;
    seen[s.block] = 1;
    out.count += s.nu, out.largest = std::max(out.largest, s.nu);
  }
  return out;
}

}  // namespace dynamy
