/// HeldRows: the rows of all held contacts at one state, in the order of the held contacts:
///
///   γ = Wᵀu + χ,   γ̇ = Wᵀu̇ + w̄,   the set of forces of each contact
///
/// A row acts on the velocities of few mass blocks: moved() names them, so that products with W are
/// short.
#pragma once
#include <dynamy/located/phase/force_set.hpp>
#include <dynamy/located/phase/phase_fault.hpp>
#include <dynamy/stages/mechanical_system.hpp>

namespace dynamy {

/// Rows that a motion with constant accelerations keeps at zero:  Rᵀu̇ + r = 0.
struct AccelerationRows {
  Eigen::MatrixXd R;  ///< nu × rows
  Eigen::VectorXd r;  ///< [m/s²]
};

class HeldRows {
 public:
  /// Reads the rows of `held` in the evaluation `e`, with the velocities u. False: `fault` says
  /// why.
  bool read(const std::vector<Held>& held, const Evaluation& e, const Eigen::VectorXd& u,
            PhaseFault& fault);
  /// Finds the sets of forces at the relative velocities read last. False: `fault` says why.
  bool readSets(const std::vector<Held>& held, const Evaluation& e, PhaseFault& fault);
  /// Rows for which the velocities `before` + τ u̇ keep the constraints of `next`, the contacts at
  /// another position:  Wᵀ(before + τ u̇) + χ = 0. False: `fault` says why.
  bool readNext(const std::vector<Held>& held, const ContactSet& next,
                const Eigen::VectorXd& before, double tau, AccelerationRows& out,
                PhaseFault& fault) const;

  /// Rows of held[i]: from row0(i) on, dim(i) of them.
  int row0(std::size_t i) const { return row0_[i]; }
  int dim(std::size_t i) const { return row0_[i + 1] - row0_[i]; }
  int size() const { return row0_.empty() ? 0 : row0_.back(); }
  /// Index of held[i] among the contacts of the evaluation.
  int contact(std::size_t i) const { return index_[i]; }
  /// First row of the slip of held[i]; slipRows(): the number of its rows.
  int slip0(std::size_t i) const { return row0_[i] + sets_[i].normalRows(); }
  int slipRows(std::size_t i) const { return row0_[i + 1] - slip0(i); }
  /// Set of forces of held[i], as of the last readSets().
  const ForceSet& set(std::size_t i) const { return sets_[i]; }

  /// W and w̄ of all rows; M⁻¹W.
  const AccelerationRows& present() const { return present_; }
  const Eigen::MatrixXd& W() const { return present_.R; }
  const Eigen::MatrixXd& MInvW() const { return MInvW_; }
  const Eigen::VectorXd& gamma() const { return gamma_; }
  const Eigen::VectorXd& chi() const { return chi_; }
  /// Positions whose rates are the rows' γ.
  const Eigen::VectorXd& position() const { return position_; }
  /// Velocities u0 … u0 + nu − 1 of a mass block on which a row acts: elsewhere its columns of W and
  /// of M⁻¹W are zero.
  struct Moved {
    int block, u0, nu;
  };
  std::span<const Moved> moved(int row) const {
    const auto first = moved0_.begin() + row;
    return {moved_.data() + first[0], moved_.data() + first[1]};
  }

  /// Wᵀ v of a row.
  double along(int row, const Eigen::VectorXd& v) const {
    double sum = 0.0;
    for (const Moved& p : moved(row))
      sum += W().col(row).segment(p.u0, p.nu).dot(v.segment(p.u0, p.nu));
    return sum;
  }
  /// a ← a + M⁻¹W λ.
  void addForces(const Eigen::VectorXd& lambda, Eigen::VectorXd& a) const {
    for (int row = 0; row < size(); ++row)
      for (const Moved& p : moved(row))
        a.segment(p.u0, p.nu) += lambda[row] * MInvW_.col(row).segment(p.u0, p.nu);
  }

 private:
  void clear(Eigen::Index velocities, int rows);
  std::vector<int> index_, row0_;
  std::vector<ForceSet> sets_;
  AccelerationRows present_;
  Eigen::MatrixXd MInvW_;  // nu × rows
  Eigen::VectorXd gamma_, chi_, position_;
  std::vector<Moved> moved_;
  std::vector<int> moved0_;  // index in moved_ of the first entry of each row, and the end
};

/// The rows that act on each mass block, of those that are kept.
class RowsOfBlocks {
 public:
  void list(const HeldRows& rows, const std::vector<int>& kept);
  /// The group of each kept row: rows that act on one block are in one group.
  void group(std::vector<int>& out) const;
  /// Calls f(k) for each kept[k] that acts on the block.
  template <class F>
  void forEach(int block, F&& f) const {
    for (int at = first_[static_cast<std::size_t>(block)]; at >= 0;
         at = entries_[static_cast<std::size_t>(at)].next)
      f(entries_[static_cast<std::size_t>(at)].k);
  }

 private:
  struct Entry {
    int k, next;  ///< next entry of the same block; −1: none
  };
  std::vector<int> first_;
  std::vector<Entry> entries_;
  std::size_t rows_ = 0;
};

/// Number of rows of the contacts `held`, by their dimensions in the evaluation `e`.
int countRows(const std::vector<Held>& held, const Evaluation& e);

}  // namespace dynamy
