#include <algorithm>
#include <cstdio>
#include <dynamy/core/decompositions.hpp>
#include <dynamy/io/fclib/problem_dump.hpp>
#include <dynamy/law/rolling_friction.hpp>
#include <dynamy/simulation/model/model.hpp>
#include <dynamy/simulation/report/contact_facts.hpp>

namespace dynamy {
namespace {

constexpr int kMostDumped = 3000;  ///< elimination of joints makes W full
constexpr int kMostUnsolved = 100;

/// The properties of a law that FCLIB can hold.
struct Friction {
  bool known = false;
  double mu = 0.0, muRolling = 0.0;
};

Friction frictionOf(const InclusionProblem& p, int i) {
  const SimpleSet set = p.law(i).simpleSet(p.input(i));
  if (set.shape == SimpleSet::Shape::friction) return {true, set.upper, 0.0};
  if (set.shape == SimpleSet::Shape::interval && p.law(i).unilateral() && set.lower == 0.0)
    return {true, 0.0, 0.0};
  const auto* rolling = dynamic_cast<const UnilateralRolling*>(&p.law(i));
  if (rolling && p.input(i).dim == 5) {
    const double tangent[4] = {1.0, 0.0, 0.0, 0.0}, moment[4] = {0.0, 0.0, 1.0, 0.0};
    return {true, rolling->support(p.input(i), 4, tangent),
            rolling->support(p.input(i), 4, moment)};
  }
  return {};
}

/// Rows of joints and of contacts.
struct Split {
  std::vector<int> joints, contacts;
};

/// Computes W and q of the contacts with joints eliminated, from G as a full matrix. False: numbers
/// are not finite.
bool eliminate(const InclusionProblem& p, const Split& rows, Eigen::MatrixXd& W,
               Eigen::VectorXd& q) {
  Eigen::MatrixXd G(p.rows(), p.rows());
  for (int j = 0; j < p.rows(); ++j) {
    const Eigen::VectorXd e = Eigen::VectorXd::Unit(p.rows(), j);
    p.G->apply(e.data(), G.col(j).data());
  }
  const ConstVec c(p.c.data(), p.rows());
  W = G(rows.contacts, rows.contacts), q = c(rows.contacts);
  if (!G.allFinite() || !c.allFinite()) return false;  // decompositions read out of bounds then
  if (rows.joints.empty()) return true;
  PseudoInverse inverse;
  inverse.compute(G(rows.joints, rows.joints));
  const Eigen::MatrixXd Gcj = G(rows.contacts, rows.joints);
  W -= Gcj * inverse.solve(G(rows.joints, rows.contacts));
  Eigen::VectorXd free;
  inverse.solve(c(rows.joints), free);
  q -= Gcj * free;
  return W.allFinite() && q.allFinite();
}

std::string shortName(long step) {
  char text[32];
  std::snprintf(text, sizeof text, "step_%07ld.hdf5", step);
  return text;
}

}  // namespace

FclibCopy fclibCopy(const InclusionProblem& p, ConstVec Lambda) {
  FclibCopy out;
  Split rows;
  std::vector<Friction> friction;
  int dim = 1;
  for (int i = 0; i < p.size(); ++i) {
    const bool joint = p.law(i).simpleSet(p.input(i)).shape == SimpleSet::Shape::all;
    std::vector<int>& into = joint ? rows.joints : rows.contacts;
    for (int k = 0; k < p.dim(i); ++k) into.push_back(p.row0(i) + k);
    if (joint) continue;
    friction.push_back(frictionOf(p, i));
    if (!friction.back().known) {
      out.refused = "FCLIB's layout has no law <" + std::string(p.law(i).type()) + ">";
      out.refusedAt = i;
      return out;
    }
    out.contact.push_back(i);
    dim = std::max(dim, p.dim(i) > 3 ? 5 : p.dim(i));
  }
  if (out.contact.empty()) out.refused = p.size() > 0 ? "it has joints only" : "it has no contacts";
  if (p.rows() > kMostDumped) out.refused = "it has more than 3000 rows";
  if (!out.refused.empty()) return out;

  Eigen::MatrixXd W;
  Eigen::VectorXd q;
  if (!eliminate(p, rows, W, q)) {
    out.refused = "its numbers are not finite";
    return out;
  }
  const auto n = static_cast<int>(out.contact.size());
  FclibProblem& f = out.problem;
  f.dim = dim;
  std::vector<int> place;  // row of the file for every row of W
  for (int k = 0; k < n; ++k)
    for (int r = 0; r < p.dim(out.contact[static_cast<std::size_t>(k)]); ++r)
      place.push_back(dim * k + r);
  f.q.setZero(dim * n), out.solution.r.setZero(dim * n), out.solution.u.setZero(dim * n);
  f.q(place) = q;
  out.solution.r(place) = Lambda(rows.contacts);
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index a = 0; a < W.rows(); ++a)
    for (Eigen::Index b = 0; b < W.cols(); ++b)
      if (W(a, b) != 0.0)
        entries.emplace_back(place[static_cast<std::size_t>(a)], place[static_cast<std::size_t>(b)],
                             W(a, b));
  f.mu.resize(dim == 1 ? 0 : n), f.muRolling.resize(dim == 5 ? n : 0);
  for (int k = 0; k < n; ++k) {
    const int i = out.contact[static_cast<std::size_t>(k)];
    const double lambda = contactLambda(p.G->diagonalBlock(i), p.dim(i));
    for (int r = p.dim(i); r < dim; ++r) entries.emplace_back(dim * k + r, dim * k + r, lambda);
    if (dim > 1) f.mu[k] = friction[static_cast<std::size_t>(k)].mu;
    if (dim == 5) f.muRolling[k] = friction[static_cast<std::size_t>(k)].muRolling;
  }
  f.W.resize(dim * n, dim * n);
  f.W.setFromTriplets(entries.begin(), entries.end());
  out.solution.u = f.W * out.solution.r + f.q;
  f.mathInfo = rows.joints.empty() ? "G as it was"
                                   : std::to_string(rows.joints.size()) + " joint rows eliminated";
  return out;
}

void ProblemDump::consider(const StepView& v) {
  const InclusionProblem& p = v.system.problem();
  const SolveReport& solved = v.report.solved;
  if (p.size() == 0 || v.report.contacts != p.size() || v.Lambda.size() != p.rows()) return;
  const auto easier = [](const Kept& a, const Kept& b) {
    return a.file.iterations < b.file.iterations;
  };
  const bool full = static_cast<int>(hard_.size()) >= count_;
  const auto least = std::min_element(hard_.begin(), hard_.end(), easier);
  if (solved.ok() && full && (count_ == 0 || solved.iterations <= least->file.iterations)) return;
  if (!solved.ok() && unsolved_.size() >= kMostUnsolved) return;

  Kept kept{{shortName(v.index), v.index, v.after.t, solved.iterations, p.size(), solved.ok()},
            fclibCopy(p, v.Lambda)};
  if (!kept.copy.refused.empty()) {
    const int at = kept.copy.refusedAt;
    if (refused_++ == 0)
      refusedBecause_ =
          kept.copy.refused +
          (at >= 0 ? " of " + contactText(v.model, p.contacts->key[static_cast<std::size_t>(at)])
                   : "");
    return;
  }
  FclibProblem& f = kept.copy.problem;
  f.title = (v.model.title.empty() ? v.model.file.name : v.model.title) + ", step " +
            std::to_string(v.index);
  f.description = "contacts:";
  for (const int i : kept.copy.contact)
    f.description += ' ' + contactName(v.model, p.contacts->key[static_cast<std::size_t>(i)]);
  if (!solved.ok())
    unsolved_.push_back(std::move(kept));
  else if (full)
    *least = std::move(kept);
  else
    hard_.push_back(std::move(kept));
}

void ProblemDump::finish(const StepView&) {
  std::filesystem::create_directories(folder_);
  std::vector<const Kept*> all;
  for (const Kept& k : hard_) all.push_back(&k);
  for (const Kept& k : unsolved_) all.push_back(&k);
  std::stable_sort(all.begin(), all.end(),
                   [](const Kept* a, const Kept* b) { return a->file.step < b->file.step; });
  files_.clear();
  for (const Kept* k : all) {
    File file = k->file;
    // A rejected step is tried again under the same number.
    int again = 1;
    const std::string stem = file.name.substr(0, file.name.size() - 5);
    while (std::any_of(files_.begin(), files_.end(),
                       [&](const File& f) { return f.name == file.name; }))
      file.name = stem + "_" + std::to_string(++again) + ".hdf5";
    writeFclib(folder_ / file.name, k->copy.problem, k->copy.solution);
    files_.push_back(std::move(file));
  }
}

}  // namespace dynamy
