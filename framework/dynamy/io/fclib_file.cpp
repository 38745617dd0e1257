#include <Eigen/SparseLU>
#include <dynamy/contact/rolling_friction.hpp>
#include <dynamy/contact/standard_laws.hpp>
#include <dynamy/core/error.hpp>
#include <dynamy/io/fclib_file.hpp>
#include <dynamy/io/hdf5_file.hpp>

namespace dynamy {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// Triplets (nz ≥ 0), compressed columns (−1) or rows (−2); repeated entries are summed.
Sparse readMatrix(const Hdf5File& file, const std::string& place) {
  const int m = file.integer(place + "/m"), n = file.integer(place + "/n"),
            nz = file.integer(place + "/nz");
  const std::vector<int> p = file.integers(place + "/p"), i = file.integers(place + "/i");
  const Eigen::VectorXd x = file.numbers(place + "/x");
  if (m < 0 || n < 0) file.fail(place, "has a negative size");
  if (nz < -2) file.fail(place + "/nz", "is not a storage: -1 columns, -2 rows, else triplets");
  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&](int row, int column, std::size_t k) {
    if (row < 0 || row >= m || column < 0 || column >= n)
      file.fail(place, "entry " + std::to_string(k) + " lies outside of the matrix");
    entries.emplace_back(row, column, x[static_cast<Eigen::Index>(k)]);
  };
  const auto size = std::min(i.size(), static_cast<std::size_t>(x.size()));
  if (nz >= 0) {
    if (static_cast<std::size_t>(nz) > std::min(size, p.size()))
      file.fail(place + "/nz", "counts more entries than there are");
    for (std::size_t k = 0; k < static_cast<std::size_t>(nz); ++k) add(i[k], p[k], k);
  } else {
    const int outer = nz == -1 ? n : m;
    if (p.size() < static_cast<std::size_t>(outer) + 1) file.fail(place + "/p", "is too short");
    for (int j = 0; j < outer; ++j)
      for (int k = p[j]; k < p[j + 1]; ++k) {
        if (k < 0 || static_cast<std::size_t>(k) >= size)
          file.fail(place + "/p", "points beyond the entries");
        nz == -1 ? add(i[k], j, static_cast<std::size_t>(k))
                 : add(j, i[k], static_cast<std::size_t>(k));
      }
  }
  Sparse out(m, n);
  out.setFromTriplets(entries.begin(), entries.end());
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

/// Sizes of a problem of the friction kind, whose matrices are read.
void checkSizes(const Hdf5File& file, const FclibProblem& p, const std::string& group) {
  const Eigen::Index rows = p.rows();
  if (rows % p.dim != 0) file.fail(group, "the rows are no multiple of spacedim");
  expectSize(file, group + "/vectors/mu", p.mu.size(), rows / p.dim);
  if (p.dim == 5) expectSize(file, group + "/vectors/mu_r", p.muRolling.size(), rows / p.dim);
  if ((p.mu.array() < 0.0).any()) file.fail(group + "/vectors/mu", "is negative");
  if (p.global) {
    expectSize(file, group + "/M/m", p.M.rows(), p.M.cols());
    expectSize(file, group + "/H/m", p.H.rows(), p.M.rows());
    expectSize(file, group + "/H/n", p.H.cols(), rows);
    expectSize(file, group + "/vectors/f", p.f.size(), p.M.rows());
  } else {
    expectSize(file, group + "/W/m", p.W.rows(), rows);
    expectSize(file, group + "/W/n", p.W.cols(), rows);
  }
}

/// M⁻¹ of a global problem.
class MassInverse {
 public:
  explicit MassInverse(const Sparse& M) {
    solver_.compute(M);
    if (solver_.info() != Eigen::Success)
      throw ModelError("the mass matrix M of the global problem is singular");
  }
  Eigen::VectorXd operator*(const Eigen::VectorXd& x) const { return solver_.solve(x); }

 private:
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
    p.W = readMatrix(file, "/lcp/M");
    p.q = file.numbers("/lcp/q");
    expectSize(file, "/lcp/M/m", p.W.rows(), p.q.size());
    expectSize(file, "/lcp/M/n", p.W.cols(), p.q.size());
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
    p.M = readMatrix(file, group + "/M");
    p.H = readMatrix(file, group + "/H");
    p.f = file.numbers(group + "/vectors/f");
    p.w = file.numbers(group + "/vectors/w");
  } else {
    p.W = readMatrix(file, group + "/W");
    p.q = file.numbers(group + "/vectors/q");
  }
  checkSizes(file, p, group);
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
    // Bodies that contact j does not move have exact zeros.
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
