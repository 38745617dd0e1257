#include <algorithm>
#include <dynamy/located/switching/contact_gaps.hpp>

namespace dynamy {

void ContactGaps::evaluateGammas(const Eigen::VectorXd& u) {
  gammas.resize(contacts.rows());
  contacts.gamma(view(u), view(gammas));
}

int ContactGaps::find(ContactKey key) const {
  const auto at = std::find(contacts.key.begin(), contacts.key.end(), key);
  return at == contacts.key.end() ? -1 : static_cast<int>(at - contacts.key.begin());
}

bool ContactGaps::coincide(int i, int j, double distance) const {
  constexpr double kTurnedGap = 1e-5;
  const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
  const ContactSet& c = contacts;
  if ((c.places.point[a] - c.places.point[b]).squaredNorm() > distance * distance ||
      (c.places.normal[a] - c.places.normal[b]).squaredNorm() > kTurnedGap * kTurnedGap)
    return false;
  const int segments = c.segment0[a + 1] - c.segment0[a];
  if (c.segment0[b + 1] - c.segment0[b] != segments) return false;
  for (int k = 0; k < segments; ++k)
    if (c.segment[static_cast<std::size_t>(c.segment0[a] + k)].block !=
        c.segment[static_cast<std::size_t>(c.segment0[b] + k)].block)
      return false;
  return true;
}

bool ContactGaps::take(int i, const ContactGaps& other, int j) {
  const int dim = contacts.dim(i), from = other.row0(j);
  if (other.contacts.dim(j) != dim) return false;
  gammas.segment(row0(i), dim) = other.gammas.segment(from, dim);
  std::copy_n(other.contacts.position.begin() + from, dim, contacts.position.begin() + row0(i));
  contacts.features.presence[static_cast<std::size_t>(i)] = other.presence(j);
  return true;
}

}  // namespace dynamy
