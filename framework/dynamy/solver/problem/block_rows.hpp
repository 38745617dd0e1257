/// BlockRows: G by rows of blocks, one block per pair of coupled contacts.
///
///   y_i = Σ_j G_ij x_j,   G_ij: dim_i × dim_j, row after row, columns j ascending
///
/// Rejected: rows of single numbers. Contacts are blocks of 1 to 3 rows, so that an index per block
/// saves most of the memory traffic and the inner loops are unrolled.
#pragma once
#include <cstddef>
#include <vector>

namespace dynamy {

struct BlockRows {
  std::vector<int> first;              ///< row i has blocks first[i] … first[i + 1] − 1
  std::vector<int> column;             ///< contact j of a block
  std::vector<std::ptrdiff_t> value0;  ///< where the numbers of a block begin
  std::vector<double> value;

  void clear() { first.assign(1, 0), column.clear(), value0.clear(), value.clear(); }
  /// Position of block (i, j), or −1.
  int find(int i, int j) const;
  /// y_i = Σ_j G_ij x_j with row0[i] = first row of contact i; `out` has dim_i entries.
  void multiplyRow(int i, const int* row0, const double* x, double* out) const;
  /// The product of multiplyRow() with absolute values of all numbers.
  void multiplyRowAbsolute(int i, const int* row0, const double* x, double* out) const;
};

}  // namespace dynamy
