#include <algorithm>
#include <cmath>
#include <dynamy/core/safe_norm.hpp>
#include <dynamy/solver/problem/given_problem.hpp>

namespace dynamy {
namespace {

/// Blocks of G that are not zero, and all diagonal blocks.
BlockRows blocks(const ContactSet& contacts, const Eigen::SparseMatrix<double, Eigen::RowMajor>& G,
                 const std::vector<int>& contactOfRow) {
  BlockRows out;
  out.clear();
  const int n = contacts.size();
  std::vector<int> seen(n, -1), columns;
  for (int i = 0; i < n; ++i) {
    columns.assign(1, i);
    seen[i] = i;
    const auto each = [&](auto&& visit) {
      for (int r = contacts.row0[i]; r < contacts.row0[i + 1]; ++r)
        for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator e(G, r); e; ++e)
          visit(r - contacts.row0[i], static_cast<int>(e.col()), e.value());
    };
    each([&](int, int col, double) {
      const int j = contactOfRow[col];
      if (seen[j] != i) seen[j] = i, columns.push_back(j);
    });
    std::sort(columns.begin(), columns.end());
    for (const int j : columns) {
      out.column.push_back(j);
      out.value0.push_back(static_cast<std::ptrdiff_t>(out.value.size()));
      out.value.resize(out.value.size() +
                       static_cast<std::size_t>(contacts.dim(i) * contacts.dim(j)));
    }
    out.first.push_back(static_cast<int>(out.column.size()));
    each([&](int r, int col, double value) {
      const int j = contactOfRow[col];
      out.value[out.value0[out.find(i, j)] + r * contacts.dim(j) + col - contacts.row0[j]] += value;
    });
  }
  return out;
}

/// The largest |c_i| of the closing contacts, or of all contacts if none closes.
double velocityScale(const InclusionProblem& p) {
  double closing = 0.0, all = 0.0;
  for (int i = 0; i < p.size(); ++i) {
    const double length = safeNorm(p.c.data() + p.row0(i), p.dim(i));
    all = std::max(all, length);
    if (!p.law(i).unilateral() || p.c[p.row0(i)] < 0.0) closing = std::max(closing, length);
  }
  return closing > 0.0 ? closing : (all > 0.0 ? all : 1.0);
}

}  // namespace

GivenProblem::GivenProblem(std::vector<GivenContact> contacts, const Eigen::SparseMatrix<double>& G,
                           const Eigen::VectorXd& c)
    : owned_(std::move(contacts)) {
  contacts_.clear();
  std::vector<int> contactOfRow;
  for (std::size_t i = 0; i < owned_.size(); ++i) {
    contacts_.key.push_back(contactKey(0, i));
    contacts_.law.push_back(owned_[i].law.get());
    contacts_.element.push_back(0);
    contacts_.row0.push_back(contacts_.row0.back() + owned_[i].dim);
    contacts_.segment0.push_back(0);
    contactOfRow.insert(contactOfRow.end(), owned_[i].dim, static_cast<int>(i));
  }
  expects(c.size() == contacts_.rows() && G.rows() == c.size() && G.cols() == c.size(),
          "G and c have the rows of the contacts");
  for (int k = 0; k < G.outerSize(); ++k)
    for (Eigen::SparseMatrix<double>::InnerIterator e(G, k); e; ++e)
      expects(std::isfinite(e.value()), "G and c hold finite numbers");
  expects(c.allFinite(), "G and c hold finite numbers");
  G_.given(contacts_,
           blocks(contacts_, Eigen::SparseMatrix<double, Eigen::RowMajor>(G), contactOfRow));
  problem_.G = &G_, problem_.contacts = &contacts_;
  problem_.c.assign(c.data(), c.data() + c.size());
  problem_.gammaFree = problem_.c;
  problem_.gammaA = problem_.c;
  problem_.uRef = velocityScale(problem_);
}

}  // namespace dynamy
