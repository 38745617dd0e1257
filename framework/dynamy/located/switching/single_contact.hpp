/// SingleContact: a look at one contact on a path that evaluates those frames alone on which it
/// depends.
#pragma once
#include <dynamy/located/phase/phase_point.hpp>
#include <dynamy/located/switching/contact_gaps.hpp>
#include <span>

namespace dynamy {

class SingleContact {
 public:
  void prepare(const SystemParts& parts);
  /// Evaluates the one contact that is requested by key at θ of the path. Of x, only what the
  /// contact depends on is set. False: its element cannot tell what this is.
  bool look(const QuinticPath& path, double theta, State& x, ContactRequest request);
  /// Asks the element of the contact that was requested by key, at k.
  void report(const SystemParts& parts, const Kinematics& k, const ContactRequest& request);
  /// Gives gap, presence and γ at the velocities u to contact i of `gaps`. False: the contact that
  /// was asked for is not reported, or has other rows.
  bool giveTo(ContactGaps& gaps, int i, const Eigen::VectorXd& u);

  /// Work of the searches of the last look, in evaluations of one velocity.
  double searched() const { return found_.contacts.features.searched; }

 private:
  const SystemParts* parts_ = nullptr;
  Kinematics kinematics_;  // of these frames
  std::vector<FrameHandle> frames_;
  std::vector<char> only_;
  ContactGaps found_;
};

}  // namespace dynamy
