/// The main solvers of Siconos on the same condensed problems, measured and judged by the same code
/// as ours, so that both tables can be laid side by side.
///
///   bench_siconos [--limit S] [--loop S] [--levels 1e-4,1e-8,1e-12] [--only NAME,NAME]
///   FILE|FOLDER…
///
/// Options are Siconos' defaults except the iteration cap, which is lifted, and the tolerance.
/// Each solver gets the storage it likes best: 3 × 3 blocks for Gauss–Seidel and the fixed points,
/// compressed columns for Newton and ADMM, 2 × 2 blocks or dense in the plane. Building the matrix
/// and the options is not timed. Rejected: the reader of Siconos itself, which not every package of
/// it has.
#include <FrictionContactProblem.h>
#include <Friction_cst.h>
#include <NonSmoothDrivers.h>
#include <NumericsMatrix.h>
#include <NumericsSparseMatrix.h>
#include <SolverOptions.h>
#include <SparseBlockMatrix.h>

#include <cstdlib>
#include <iostream>
#include <map>

#include "solvers/measure.hpp"

namespace {

using namespace dynamy;
using namespace dynamy::bench;

enum class Storage { blocks, columns, dense };

/// One solver of Siconos with what differs from its defaults.
struct SiconosSolver {
  const char* name;
  int dim;
  int id;
  Storage storage;
  int localSolver = 0;  ///< replaces the solver of one contact; 0: default
  int parameter = -1;   ///< index of an integer option, and its value
  int value = 0;
};

constexpr SiconosSolver kSolvers[] = {
    {"NSGS", 3, SICONOS_FRICTION_3D_NSGS, Storage::blocks},
    {"NSGS:quartic", 3, SICONOS_FRICTION_3D_NSGS, Storage::blocks,
     SICONOS_FRICTION_3D_ONECONTACT_QUARTIC},
    {"NSGS:projection", 3, SICONOS_FRICTION_3D_NSGS, Storage::blocks,
     SICONOS_FRICTION_3D_ONECONTACT_ProjectionOnConeWithLocalIteration},
    {"NSGS:lightfull", 3, SICONOS_FRICTION_3D_NSGS, Storage::blocks, 0,
     SICONOS_FRICTION_3D_IPARAM_ERROR_EVALUATION,
     SICONOS_FRICTION_3D_NSGS_ERROR_EVALUATION_LIGHT_WITH_FULL_FINAL},
    {"NSN_AC", 3, SICONOS_FRICTION_3D_NSN_AC, Storage::columns},
    {"NSN_AC:hybrid", 3, SICONOS_FRICTION_3D_NSN_AC, Storage::columns, 0,
     SICONOS_FRICTION_3D_NSN_HYBRID_STRATEGY, SICONOS_FRICTION_3D_NSN_HYBRID_STRATEGY_VI_EG_NSN},
    {"NSN_FB", 3, SICONOS_FRICTION_3D_NSN_FB, Storage::columns},
    {"NSN_NM", 3, SICONOS_FRICTION_3D_NSN_NM, Storage::columns},
    {"PROX", 3, SICONOS_FRICTION_3D_PROX, Storage::columns},
    {"ADMM", 3, SICONOS_FRICTION_3D_ADMM, Storage::columns},
    {"VI_EG", 3, SICONOS_FRICTION_3D_VI_EG, Storage::blocks},
    {"DSFP", 3, SICONOS_FRICTION_3D_DSFP, Storage::blocks},
    {"2D_NSGS", 2, SICONOS_FRICTION_2D_NSGS, Storage::blocks},
    {"2D_CPG", 2, SICONOS_FRICTION_2D_CPG, Storage::dense},
    {"2D_LEMKE", 2, SICONOS_FRICTION_2D_LEMKE, Storage::dense},
    {"2D_ENUM", 2, SICONOS_FRICTION_2D_ENUM, Storage::dense},
};

double* allocated(const double* from, Eigen::Index n) {
  auto* out = static_cast<double*>(std::malloc(static_cast<std::size_t>(n) * sizeof(double)));
  std::copy_n(from, n, out);
  return out;
}

template <class T>
T* allocatedArray(const std::vector<T>& from) {
  auto* out = static_cast<T*>(std::malloc(from.size() * sizeof(T)));
  std::copy(from.begin(), from.end(), out);
  return out;
}

/// Rows of dim × dim blocks; the matrix is square. The process is a child that ends soon, so that
/// nothing here is given back.
SparseBlockStructuredMatrix* blockMatrix(const FclibProblem& p) {
  const int d = p.dim, n = p.contacts();
  std::vector<std::map<int, double*>> rows(static_cast<std::size_t>(n));
  const auto block = [&rows, d](int i, int j) {
    double*& b = rows[static_cast<std::size_t>(i)][j];
    if (b == nullptr) b = static_cast<double*>(std::calloc(static_cast<std::size_t>(d * d), 8));
    return b;
  };
  for (int i = 0; i < n; ++i) block(i, i);
  for (int j = 0; j < p.W.outerSize(); ++j)
    for (Eigen::SparseMatrix<double>::InnerIterator it(p.W, j); it; ++it)
      if (it.value() != 0.0) {
        const int i = static_cast<int>(it.row());
        block(i / d, j / d)[i % d + d * (j % d)] += it.value();
      }
  std::vector<double*> blocks;
  std::vector<std::size_t> starts = {0}, columns;
  std::vector<unsigned> sizes;
  for (int i = 0; i < n; ++i) {
    for (const auto& [j, b] : rows[static_cast<std::size_t>(i)]) {
      blocks.push_back(b);
      columns.push_back(static_cast<std::size_t>(j));
    }
    starts.push_back(columns.size());
    sizes.push_back(static_cast<unsigned>(d * (i + 1)));
  }
  SparseBlockStructuredMatrix* m = SBM_new();
  m->nbblocks = static_cast<unsigned>(blocks.size());
  m->block = allocatedArray(blocks);
  m->blocknumber0 = m->blocknumber1 = static_cast<unsigned>(n);
  m->blocksize0 = allocatedArray(sizes);
  m->blocksize1 = allocatedArray(sizes);
  m->filled1 = starts.size();
  m->filled2 = columns.size();
  m->index1_data = allocatedArray(starts);
  m->index2_data = allocatedArray(columns);
  return m;
}

NumericsMatrix* matrixOf(const FclibProblem& p, Storage storage) {
  const int n = p.rows();
  if (storage == Storage::blocks) return NM_create_from_data(NM_SPARSE_BLOCK, n, n, blockMatrix(p));
  if (storage == Storage::dense) {
    const Eigen::MatrixXd W(p.W);
    return NM_create_from_data(NM_DENSE, n, n, allocated(W.data(), W.size()));
  }
  NumericsMatrix* m = NM_create(NM_SPARSE, n, n);
  NM_triplet_alloc(m, static_cast<CS_INT>(p.W.nonZeros()));
  m->matrix2->origin = NSM_TRIPLET;
  for (int j = 0; j < p.W.outerSize(); ++j)
    for (Eigen::SparseMatrix<double>::InnerIterator it(p.W, j); it; ++it)
      if (it.value() != 0.0) NM_entry(m, static_cast<int>(it.row()), j, it.value());
  NM_csc(m);
  return m;
}

class SiconosCandidate final : public Candidate {
 public:
  SiconosCandidate(const SiconosSolver& solver, const FclibProblem& local)
      : solver_(solver), local_(local), u_(local.rows()) {}

  void prepare(double tolerance, int count) override {
    if (matrix_ == nullptr) pose();
    for (SolverOptions* o : options_) solver_options_delete(o);
    options_.clear();
    for (int k = 0; k < count; ++k) options_.push_back(optionsOf(tolerance));
  }

  Said solve(int k, Eigen::VectorXd& r, double) override {
    SolverOptions* options = options_[static_cast<std::size_t>(k)];
    u_.setZero();
    const int info =
        (solver_.dim == 2 ? fc2d_driver : fc3d_driver)(problem_, r.data(), u_.data(), options);
    return {info == 0, options->iparam[SICONOS_IPARAM_ITER_DONE], 0};
  }

  /// Options keep the state of some solvers, whose second run would be another one.
  bool again() const override { return false; }

 private:
  void pose() {
    matrix_ = matrixOf(local_, solver_.storage);
    double* q = allocated(local_.q.data(), local_.q.size());
    double* mu = allocated(local_.mu.data(), local_.mu.size());
    problem_ = frictionContactProblem_new_with_data(local_.dim, local_.contacts(), matrix_, q, mu);
  }

  SolverOptions* optionsOf(double tolerance) const {
    SolverOptions* o = solver_options_create(solver_.id);
    o->iparam[SICONOS_IPARAM_MAX_ITER] = 1000000000;
    o->dparam[SICONOS_DPARAM_TOL] = tolerance;
    if (solver_.localSolver != 0) solver_options_update_internal(o, 0, solver_.localSolver);
    if (solver_.parameter >= 0) o->iparam[solver_.parameter] = solver_.value;
    return o;
  }

  const SiconosSolver& solver_;
  const FclibProblem& local_;
  Eigen::VectorXd u_;
  NumericsMatrix* matrix_ = nullptr;
  FrictionContactProblem* problem_ = nullptr;
  std::vector<SolverOptions*> options_;
};

/// A dense matrix of 2000 rows has 32 MB; enumeration doubles with every row.
bool meant(const SiconosSolver& solver, const FclibProblem& local) {
  constexpr int kDenseRows = 2000, kEnumeratedRows = 24;
  return solver.dim == local.dim &&
         (solver.storage != Storage::dense || local.rows() <= kDenseRows) &&
         (solver.id != SICONOS_FRICTION_2D_ENUM || local.rows() <= kEnumeratedRows);
}

std::vector<Entry> entries() {
  std::vector<Entry> out;
  for (const SiconosSolver& solver : kSolvers)
    out.push_back({solver.name, [&solver](const FclibProblem& local) -> std::unique_ptr<Candidate> {
                     if (!meant(solver, local)) return nullptr;
                     return std::make_unique<SiconosCandidate>(solver, local);
                   }});
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    run(jobOf(argc, argv), "siconos", entries(), std::cout);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
