#include <dynamy/system/body_carrier.hpp>
#include <dynamy/system/own_coordinates.hpp>
#include <dynamy/system/topology.hpp>

namespace dynamy {

OwnCoordinates::OwnCoordinates(const Topology& topology, std::string_view name,
                               const Element& asking) {
  handle_ = topology.system(name, asking, &body_);
  system_ = topology.systems()[static_cast<std::size_t>(handle_.index)];
  nq_ = handle_.nq, nu_ = handle_.nu;
  if (body_ < 0) return;
  carrier_ = system_->abilities().carrier;
  system_ = &carrier_->carriedBody(body_);
  nq_ = system_->blocks().nq, nu_ = system_->blocks().nu;
  qu_.resize(static_cast<std::size_t>(nq_ + nu_));
  jacobian_.resize(static_cast<std::size_t>(nu_ * (handle_.nu + 1)));
}

Vec OwnCoordinates::own(const Kinematics& k, int first, int count) const {
  carrier_->ownState(body_, k.q(handle_), k.u(handle_), {qu_.data(), nq_}, {qu_.data() + nq_, nu_});
  return {qu_.data() + first, count};
}

ConstVec OwnCoordinates::q(const Kinematics& k) const {
  if (body_ < 0) return k.q(handle_);
  const Vec own = this->own(k, 0, nq_);
  return {own.data(), own.size()};
}

ConstVec OwnCoordinates::u(const Kinematics& k) const {
  if (body_ < 0) return k.u(handle_);
  const Vec own = this->own(k, nq_, nu_);
  return {own.data(), own.size()};
}

Block OwnCoordinates::room(Block direct) const {
  if (body_ < 0) return direct;
  rows_.assign(static_cast<std::size_t>(direct.rows() * nu_), 0.0);
  added_.assign(static_cast<std::size_t>(direct.rows()), 0.0);
  return {rows_.data(), direct.rows(), nu_};
}

const double* OwnCoordinates::carry(const Kinematics& k, Block direct) const {
  if (body_ < 0) return nullptr;
  const Block J(jacobian_.data(), nu_, handle_.nu);
  const Vec beta(jacobian_.data() + nu_ * handle_.nu, nu_);
  carrier_->ownVelocities(body_, k.q(handle_), k.u(handle_), J, beta);
  const ConstBlock W(rows_.data(), direct.rows(), nu_);
  direct += W.lazyProduct(J);
  Vec(added_.data(), direct.rows()) = W.lazyProduct(beta);
  return added_.data();
}

}  // namespace dynamy
