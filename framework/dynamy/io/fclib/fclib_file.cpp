#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <dynamy/core/error.hpp>
#include <dynamy/io/fclib/fclib_file.hpp>
#include <dynamy/io/hdf5/hdf5_file.hpp>
#include <dynamy/law/rolling_friction.hpp>
#include <dynamy/law/standard_laws.hpp>

namespace dynamy {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// Checks the indices at which the columns or rows begin: they start at 0 and never decrease.
void checkPointers(const Hdf5File& file, const std::string& place, const std::vector<int>& p,
                   int outer, std::size_t entries) {
  const auto wanted = static_cast<std::size_t>(outer) + 1;
  if (p.size() < wanted) file.fail(place, "is too short");
  if (p.size() > wanted)
    file.fail(place, "has " + std::to_string(p.size()) + " entries, not " + std::to_string(wanted));
  if (p.front() != 0) file.fail(place, "begins with " + std::to_string(p.front()) + ", not 0");
  for (std::size_t k = 1; k < p.size(); ++k)
    if (p[k] < p[k - 1])
      file.fail(place, "decreases at entry " + std::to_string(k) + ", from " +
                           std::to_string(p[k - 1]) + " to " + std::to_string(p[k]));
  if (static_cast<std::size_t>(p.back()) > entries) file.fail(place, "points beyond the entries");
}

/// Reads the number of rows or columns. It must match the vectors of the file before a matrix of
/// that size is created.
int readSize(const Hdf5File& file, const std::string& place, Eigen::Index wanted) {
  const int size = file.integer(place);
  if (size < 0) file.fail(place, "is negative");
  if (size != wanted)
    file.fail(place, "is " + std::to_string(size) + ", but the vectors have " +
                         std::to_string(wanted) + " entries");
  return size;
}

/// Reads a matrix stored as triplets (nz ≥ 0), compressed columns (−1) or rows (−2); repeated
/// entries are summed.
Sparse readMatrix(const Hdf5File& file, const std::string& place, Eigen::Index rows,
                  Eigen::Index columns) {
  const int m = readSize(file, place + "/m", rows), n = readSize(file, place + "/n", columns),
            nz = file.integer(place + "/nz");
  const std::vector<int> p = file.integers(place + "/p"), i = file.integers(place + "/i");
  const Eigen::VectorXd x = file.numbers(place + "/x");
  if (nz < -2) file.fail(place + "/nz", "is not a storage: -1 columns, -2 rows, else triplets");
  const std::size_t size = i.size();
  if (size != static_cast<std::size_t>(x.size()))
    file.fail(place + "/i", "has " + std::to_string(size) + " entries, but " + place + "/x has " +
                                std::to_string(x.size()));
  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&](int row, int column, std::size_t k) {
    if (row < 0 || row >= m || column < 0 || column >= n)
      file.fail(place, "entry " + std::to_string(k) + " lies outside of the matrix");
    entries.emplace_back(row, column, x[static_cast<Eigen::Index>(k)]);
  };
  if (nz >= 0) {
    if (static_cast<std::size_t>(nz) > std::min(size, p.size()))
      file.fail(place + "/nz", "counts more entries than there are");
    for (std::size_t k = 0; k < static_cast<std::size_t>(nz); ++k) add(i[k], p[k], k);
  } else {
    const int outer = nz == -1 ? n : m;
    checkPointers(file, place + "/p", p, outer, size);
    for (int j = 0; j < outer; ++j)
      for (auto k = static_cast<std::size_t>(p[j]); k < static_cast<std::size_t>(p[j + 1]); ++k)
        nz == -1 ? add(i[k], j, k) : add(j, i[k], k);
  }
  Sparse out(m, n);
  out.setFromTriplets(entries.begin(), entries.end());
  for (int k = 0; k < out.outerSize(); ++k)
    for (Sparse::InnerIterator e(out, k); e; ++e)
      if (!std::isfinite(e.value())) file.fail(place, "the sum of repeated entries is not finite");
  return out;
}

void writeMatrix(Hdf5File& file, const std::string& place, Sparse A) {
  A.makeCompressed();
  const auto n = static_cast<int>(A.nonZeros());
  file.write(place + "/m", std::vector<int>{static_cast<int>(A.rows())});
  file.write(place + "/n", std::vector<int>{static_cast<int>(A.cols())});
  file.write(place + "/nzmax", std::vector<int>{n});
  file.write(place + "/nz", std::vector<int>{-1});
  file.write(place + "/p", std::vector<int>(A.outerIndexPtr(), A.outerIndexPtr() + A.cols() + 1));
  file.write(place + "/i", std::vector<int>(A.innerIndexPtr(), A.innerIndexPtr() + n));
  file.write(place + "/x", Eigen::VectorXd(Eigen::Map<Eigen::VectorXd>(A.valuePtr(), n)));
}

void expectSize(const Hdf5File& file, const std::string& place, Eigen::Index is,
                Eigen::Index wanted) {
  if (is != wanted)
    file.fail(place, "has " + std::to_string(is) + " entries, not " + std::to_string(wanted));
}

std::string groupName(const FclibProblem& p) {
  if (p.dim == 1) return "/lcp";
  return std::string(p.global ? "/fclib_global" : "/fclib_local") + (p.dim == 5 ? "_rolling" : "");
}

/// Checks sizes and signs of the coefficients of each contact; `rows`: rows of the problem.
void checkContacts(const Hdf5File& file, const FclibProblem& p, Eigen::Index rows,
                   const std::string& group) {
  if (rows % p.dim != 0)
    file.fail(group, "the " + std::to_string(rows) + " rows are no multiple of spacedim");
  expectSize(file, group + "/vectors/mu", p.mu.size(), rows / p.dim);
  if ((p.mu.array() < 0.0).any()) file.fail(group + "/vectors/mu", "is negative");
  if (p.dim != 5) return;
  expectSize(file, group + "/vectors/mu_r", p.muRolling.size(), rows / p.dim);
  if ((p.muRolling.array() < 0.0).any()) file.fail(group + "/vectors/mu_r", "is negative");
}

/// M⁻¹ of a global problem.
class MassInverse {
 public:
  explicit MassInverse(const Sparse& M) {
    if (M.rows() == 0) return;  // nothing to factor
    for (int k = 0; k < M.outerSize(); ++k)
      if (!Sparse::InnerIterator(M, k)) throw singular();
    solver_.compute(M);
    if (solver_.info() != Eigen::Success) throw singular();
  }
  Eigen::VectorXd operator*(const Eigen::VectorXd& x) const {
    if (x.size() == 0) return x;
    Eigen::VectorXd out = solver_.solve(x);
    if (!out.allFinite()) throw singular();
    return out;
  }

 private:
  static ModelError singular() {
    return ModelError("the mass matrix M of the global problem is singular",
                      "every velocity needs a mass");
  }
  Eigen::SparseLU<Sparse> solver_;
};

}  // namespace

FclibProblem readFclib(const std::filesystem::path& path) {
  const Hdf5File file(path, Hdf5File::Mode::read);
  FclibProblem p;
  std::string group;
  for (const char* name :
       {"/fclib_local", "/fclib_global", "/fclib_local_rolling", "/fclib_global_rolling", "/lcp"})
    if (file.has(name)) group = name;
  if (group.empty())
    file.fail("",
              "holds no contact problem: none of /fclib_local, /fclib_global, "
              "/fclib_local_rolling, /fclib_global_rolling, /lcp is there");
  if (group == "/lcp") {
    p.dim = 1;
    p.q = file.numbers("/lcp/q");
    p.W = readMatrix(file, "/lcp/M", p.q.size(), p.q.size());
    return p;
  }
  p.global = group.starts_with("/fclib_global");
  const bool rolling = group.ends_with("_rolling");
  p.dim = file.integer(group + "/spacedim");
  if (p.dim != 2 && p.dim != 3 && p.dim != 5) file.fail(group + "/spacedim", "is not 2, 3 or 5");
  if (rolling) p.dim = 5;
  p.title = file.text(group + "/info/title");
  p.description = file.text(group + "/info/description");
  p.mathInfo = file.text(group + "/info/math_info");
  p.mu = file.numbers(group + "/vectors/mu");
  if (rolling) p.muRolling = file.numbers(group + "/vectors/mu_r");
  if (p.global) {
    p.f = file.numbers(group + "/vectors/f");
    p.w = file.numbers(group + "/vectors/w");
    checkContacts(file, p, p.w.size(), group);
    p.M = readMatrix(file, group + "/M", p.f.size(), p.f.size());
    p.H = readMatrix(file, group + "/H", p.f.size(), p.w.size());
  } else {
    p.q = file.numbers(group + "/vectors/q");
    checkContacts(file, p, p.q.size(), group);
    p.W = readMatrix(file, group + "/W", p.q.size(), p.q.size());
  }
  return p;
}

void writeFclib(const std::filesystem::path& path, const FclibProblem& p,
                const FclibSolution& solution) {
  Hdf5File file(path, Hdf5File::Mode::create);
  const std::string group = groupName(p);
  if (p.dim == 1) {
    writeMatrix(file, group + "/M", p.W);
    file.write(group + "/q", p.q);
  } else {
    file.write(group + "/spacedim", std::vector<int>{p.dim});
    file.write(group + "/info/title", p.title);
    file.write(group + "/info/description", p.description);
    file.write(group + "/info/math_info", p.mathInfo);
    file.write(group + "/vectors/mu", p.mu);
    if (p.dim == 5) file.write(group + "/vectors/mu_r", p.muRolling);
    if (p.global) {
      writeMatrix(file, group + "/M", p.M);
      writeMatrix(file, group + "/H", p.H);
      file.write(group + "/vectors/f", p.f);
      file.write(group + "/vectors/w", p.w);
    } else {
      writeMatrix(file, group + "/W", p.W);
      file.write(group + "/vectors/q", p.q);
    }
  }
  if (solution.r.size() > 0) file.write("/solution/r", solution.r);
  if (solution.u.size() > 0) file.write("/solution/u", solution.u);
  if (solution.v.size() > 0) file.write("/solution/v", solution.v);
  file.flush();
}

FclibProblem condensed(const FclibProblem& p) {
  if (!p.global) return p;
  FclibProblem local = p;
  local.global = false;
  const MassInverse inverse(p.M);
  const Sparse Ht = p.H.transpose();
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd column(p.rows());
  for (int j = 0; j < p.rows(); ++j) {
    const Eigen::VectorXd x = inverse * Eigen::VectorXd(p.H.col(j));
    // Bodies that row j does not move have exact zeros.
    column.setZero();
    for (Eigen::Index k = 0; k < x.size(); ++k)
      if (x[k] != 0.0)
        for (Sparse::InnerIterator e(Ht, k); e; ++e) column[e.row()] += e.value() * x[k];
    for (int i = 0; i < p.rows(); ++i)
      if (column[i] != 0.0) entries.emplace_back(i, j, column[i]);
  }
  local.W.resize(p.rows(), p.rows());
  local.W.setFromTriplets(entries.begin(), entries.end());
  local.q = Ht * (inverse * p.f) + p.w;
  local.M.resize(0, 0), local.H.resize(0, 0);
  local.f.resize(0), local.w.resize(0);
  return local;
}

Eigen::VectorXd velocities(const FclibProblem& p, const Eigen::VectorXd& r) {
  return MassInverse(p.M) * Eigen::VectorXd(p.H * r + p.f);
}

std::unique_ptr<GivenProblem> inclusionProblem(const FclibProblem& p) {
  expects(!p.global, "the problem is condensed");
  std::vector<GivenContact> contacts;
  for (int i = 0; i < p.contacts(); ++i) {
    if (p.dim == 1)
      contacts.push_back({std::make_unique<Unilateral>(), 1});
    else if (p.dim == 5)
      contacts.push_back({std::make_unique<UnilateralRolling>(p.mu[i], p.muRolling[i]), 5});
    else
      contacts.push_back({std::make_unique<UnilateralCoulomb>(0.0, 0.0, p.mu[i]), p.dim});
  }
  return std::make_unique<GivenProblem>(std::move(contacts), p.W, p.q);
}

}  // namespace dynamy
