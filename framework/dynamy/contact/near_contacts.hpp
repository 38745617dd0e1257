/// PathReach: how far frames move on a path, at most. NearContacts: the contacts that can close on
/// it, as ranges of keys.
#pragma once
#include <dynamy/contact/contact_set.hpp>
#include <dynamy/system/kinematics.hpp>
#include <span>
#include <vector>

namespace dynamy {

class PathReach {
 public:
  /// Begins with no motion. `time`: length of the path [s]; `margin`: added to every way [m].
  void begin(const Kinematics& k, double time, double margin);
  /// The path passes `k`: notes the speeds there.
  void pass(const Kinematics& k);
  /// Multiplies all speeds by `factor`: between the noted places they may be higher.
  void widen(double factor);
  /// True: nothing moves faster or for a longer time than in `other`.
  bool within(const PathReach& other) const;

  /// Bound of the way of a point at the distance `arm` [m] from the origin of frame f [m].
  double way(FrameHandle f, double arm) const {
    const Speeds& s = speeds_[static_cast<std::size_t>(f.index)];
    return margin_ + time_ * (s.v + (s.Omega > 0.0 ? s.Omega * arm : 0.0));
  }

 private:
  struct Speeds {
    double v = 0.0;      // of the origin [m/s]
    double Omega = 0.0;  // [rad/s]
  };
  std::vector<Speeds> speeds_;  // per frame
  double time_ = 0.0, margin_ = 0.0;
};

class NearContacts {
 public:
  void clear() { ranges_.clear(), some_ = false; }
  /// Adds the contacts `first` … `end` − 1 of an element.
  void add(int element, std::uint64_t first, std::uint64_t end) {
    ranges_.push_back({contactKey(element, first), contactKey(element, end)});
    some_ = true;
  }
  /// Adds all contacts of an element that cannot tell which of them are near.
  void addAll(int element) {
    ranges_.push_back({contactKey(element, 0), contactKey(element + 1, 0)});
  }
  /// Orders what was added; to be called before the functions below.
  void order();
  /// True: there are contacts of elements that can tell which of theirs are near.
  bool some() const { return some_; }
  bool has(ContactKey key) const;
  /// Of `keys`, ascending, the near ones.
  void select(std::span<const ContactKey> keys, std::vector<ContactKey>& out) const;
  /// Calls f(first) for the first number of each range of an element.
  template <class F>
  void forEach(int element, F&& f) const {
    for (auto r = startOf(element); r != ranges_.end() && r->first < contactKey(element + 1, 0);
         ++r)
      f(contactNumber(r->first));
  }

 private:
  struct Range {
    ContactKey first, end;
  };
  std::vector<Range>::const_iterator startOf(int element) const;
  std::vector<Range> ranges_;
  bool some_ = false;
};

}  // namespace dynamy
