/// ContactSink: where a NonSmoothElement emits its contacts.
///
///   if (auto rows = sink.add(id, g, law, 3)) {  // false while open: g is recorded, W not needed
///     rows.segment(frame)… ; rows.chi(0) = …;
///   }
#pragma once
#include <algorithm>
#include <dynamy/contact/near_contacts.hpp>
#include <dynamy/system/kinematics.hpp>

namespace dynamy {

/// A block of the mass matrix of an evaluation: its number, its first velocity, their number.
struct BlockPlace {
  int number = -1, u0 = 0, nu = 0;
};

/// Writable rows of one closed contact; false if the contact is open.
class ContactRows {
 public:
  ContactRows() = default;
  ContactRows(ContactSet& set, int index, bool bias, const SystemSubset* some = nullptr)
      : set_(&set), some_(some), index_(index), bias_(bias) {}
  explicit operator bool() const { return set_ != nullptr; }
  int dim() const { return set_->dim(index_); }
  bool wantsBias() const { return bias_; }
  /// The dim × nu entries of Wᵀ that belong to the mass block of a frame, or of a system of one
  /// block, zeroed at the first call for this block. Add to them, never assign: two bodies of a
  /// contact may share a block.
  Block segment(const Frame& frame) {
    return segment(BlockPlace{frame.block, frame.u0, frame.nu()});
  }
  Block segment(const SystemHandle& system) {
    const SystemHandle& own = ownHandle(some_, system);
    return segment(BlockPlace{own.block0, own.u0, own.blockNu});
  }
  Block segment(const BlockPlace& block);
  double& chi(int row) {
    return set_->chi[static_cast<std::size_t>(set_->row0[static_cast<std::size_t>(index_)] + row)];
  }
  double& bias(int row) {
    return set_->bias[static_cast<std::size_t>(set_->row0[static_cast<std::size_t>(index_)] + row)];
  }
  /// Signed position error of a joint's row [m]. The sink itself sets it to g in the normal row,
  /// and in a contact with a single row.
  double& position(int row) {
    return set_
        ->position[static_cast<std::size_t>(set_->row0[static_cast<std::size_t>(index_)] + row)];
  }
  /// Sets the factor ≥ 0 on the set of a law with scales(), e.g. of a reservoir that is switched
  /// or varies.
  void scale(double factor) { set_->scale[static_cast<std::size_t>(index_)] = factor; }
  /// For the replay: sets the point of contact [m], the normal and, if known, the directions of the
  /// tangential rows; all components in I.
  void place(const Vec3& point, const Vec3& normal, const Vec3& t1 = Vec3::Zero(),
             const Vec3& t2 = Vec3::Zero());

 private:
  ContactSet* set_ = nullptr;
  const SystemSubset* some_ = nullptr;
  int index_ = 0;
  bool bias_ = false;
};

/// What one evaluation of the contacts requests from the elements.
struct ContactRequest {
  double gTol = 0.0;  ///< closed: g ≤ gTol [m]
  bool bias = false;  ///< fill the bias γ̇ − Wᵀu̇
  std::span<const ContactKey> frozen =
      {};                ///< refresh: exactly these contacts count as closed, for any gap
  bool refresh = false;  ///< use `frozen`
  bool alone = false;    ///< with refresh: contacts that are not in `frozen` need not be reported
  /// With refresh: contacts that come and go with the touching features are reported as pairs of
  /// features, with their presence. Exactly the pairs in `frozen` are reported, wherever they are.
  bool follow = false;
  /// With follow: pairs of features that may touch within this time are noted [s]; below 0: none.
  double ahead = -1.0;
  /// With follow: a circle whose lowest point is less than this below its middle lies flat [m].
  double flat = 0.0;
  /// With follow: contacts in `frozen` that are not there are reported as open, with a presence
  /// below zero and without rows.
  bool absent = false;
  /// With follow: contacts outside of these need not be reported; null: all are.
  const NearContacts* near = nullptr;
};

class ContactSink {
 public:
  /// The lowest point of a circle counts from this part of ContactRequest::flat on.
  static constexpr double kLowest = 0.5;
  /// `some`: the view that asks; null: all systems take part.
  ContactSink(ContactSet& set, const ContactRequest& request, const SystemSubset* some = nullptr)
      : set_(&set), request_(request), some_(some) {}
  /// Reports contact `id` (< 2^40, unique within the element, the same over time) with gap g [m]
  /// and `geometric` rows, of which the law uses law.dim(geometric). A contact whose law is not
  /// unilateral is always closed; its g is the norm of the position error of the joint.
  ContactRows add(std::uint64_t id, double g, const SetValuedForceLaw& law, int geometric);
  /// Set by the framework before each element.
  void element(int index) { element_ = index; }
  const ContactRequest& request() const { return request_; }
  // For pairs of features that are followed one by one:
  /// Calls f(id) for the first contact of each range of the element's near contacts.
  template <class F>
  void forNear(F&& f) const {
    request_.near->forEach(element_, f);
  }
  /// Keys of the element's contacts `first` … `end` − 1 that are requested by key.
  std::span<const ContactKey> asked(std::uint64_t first, std::uint64_t end) const;
  /// A sink for contacts of the same element, which are put into `set`.
  ContactSink into(ContactSet& set, const ContactRequest& request) const {
    ContactSink out(set, request, some_);
    out.element_ = element_;
    return out;
  }
  /// Reports contact i of `from`, which such a sink has filled.
  void add(const ContactSet& from, int i, int geometric);
  /// Sets the presence of the contact that was added last [m].
  void presence(double value) { set_->features.presence.back() = value; }
  /// The same for the lowest point of a circle, which is `lift` below its middle [m].
  void circle(double lift) {
    presence(lift - kLowest * request_.flat), set_->features.circle.back() = 1;
  }
  void note(std::uint64_t id) { set_->features.noted.push_back(contactKey(element_, id)); }
  /// Counts the work of a pair whose gap takes a search, in evaluations of one velocity.
  void searched(double work) { set_->features.searched += work; }
  /// Reports two bodies whose contacts come and go; overlap(): the depth of their overlap [m], `id`:
  /// the least number that a contact of theirs may have, `jumps`: their contacts jump.
  void comesAndGoes() { set_->features.comeAndGo = true; }
  /// Reports two bodies that may meet and part again within the time that is looked ahead, since their
  /// gap is known to a small distance only.
  void unseen() { set_->features.unseen = true; }
  void overlap(double depth, std::uint64_t id, bool jumps) {
    FollowedFeatures& f = set_->features;
    if (depth > f.overlap) f.overlap = depth, f.deepest = contactKey(element_, id);
    if (jumps && depth > f.jumpingOverlap)
      f.jumpingOverlap = depth, f.jumping = contactKey(element_, id);
  }
  /// True: contacts are requested by key, and contact `id` of this element is not among them.
  bool leftOut(std::uint64_t id) const {
    return request_.refresh && !std::binary_search(request_.frozen.begin(), request_.frozen.end(),
                                                   contactKey(element_, id));
  }

 private:
  ContactSet* set_;
  ContactRequest request_;
  const SystemSubset* some_;
  int element_ = 0;
};

/// Point contact between frames A (body 1) and B (body 2) at the points with lever arms rhoA_I,
/// rhoB_I: rows n, t1, t2 (as many as rows.dim()) of the velocity of B's point relative to A's.
/// Fills segments, χ and, if requested, the bias without the change of the directions, whose terms
/// the element adds. A frame without a block contributes
/// to χ only.
void pointContact(ContactRows& rows, const Frame& A, const Vec3& rhoA_I, const Frame& B,
                  const Vec3& rhoB_I, const Vec3& n, const Vec3& t1, const Vec3& t2);
/// Adds to segments and χ of `row` the component of the relative velocity of two points along
/// `direction` (sign +1 for B, −1 for A).
void addPointRow(Block W, int row, const Frame& frame, const Vec3& rho_I, const Vec3& direction,
                 double sign);

}  // namespace dynamy
