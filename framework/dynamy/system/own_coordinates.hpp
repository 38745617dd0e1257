/// OwnCoordinates: q and u of a system that a model names, or of a body that another system carries
/// (theory 39.7). Elements that are written for the coordinates of one system work on both.
#pragma once
#include <dynamy/system/kinematics.hpp>
#include <string_view>
#include <vector>

namespace dynamy {

class BodyCarrier;

class OwnCoordinates {
 public:
  OwnCoordinates() = default;
  /// Throws ModelError with the nearest known name. To be called in connect().
  OwnCoordinates(const Topology& topology, std::string_view name, const Element& asking);

  /// What has these coordinates: their names and number.
  const PartialMechanicalSystem& system() const { return *system_; }
  /// The system that moves: the carrier of a body that is carried.
  const SystemHandle& handle() const { return handle_; }
  int nq() const { return nq_; }
  int nu() const { return nu_; }
  ConstVec q(const Kinematics& k) const;
  ConstVec u(const Kinematics& k) const;
  /// Where to write rows W of own velocities for the rows `direct` of the system that moves: zeroed
  /// room of their number × nu, or `direct` itself where no body is carried.
  Block room(Block direct) const;
  /// Adds what was written into room() to `direct`, as W J. Returns W β, the bias that comes with
  /// it, one number a row; null: it is zero.
  const double* carry(const Kinematics& k, Block direct) const;

 private:
  const PartialMechanicalSystem* system_ = nullptr;
  SystemHandle handle_;
  const BodyCarrier* carrier_ = nullptr;
  int body_ = -1;  // of the carrier; −1: the system itself
  int nq_ = 0, nu_ = 0;
  Vec own(const Kinematics& k, int first, int count) const;
  // Scratch: own q and u; J and β; W; W β.
  mutable std::vector<double> qu_, jacobian_, rows_, added_;
};

}  // namespace dynamy
