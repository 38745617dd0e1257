/// PairRules: which shapes can touch each other, and how. Made once when a model is built.
///
/// Equal shapes form a group, and the rule is found once per pair of groups, so that 100 000 grains
/// cost no more memory than themselves: a matrix over shapes was rejected.
#pragma once
#include <dynamy/law/pair_laws.hpp>
#include <dynamy_elements/contacts/kernels/pair_report.hpp>
#include <dynamy_elements/contacts/kernels/pair_table.hpp>
#include <dynamy_elements/contacts/search/shape_set.hpp>

namespace dynamy {

/// Two shapes that can touch, A the one of the higher kind (half space before box before ball);
/// among equal kinds A has the smaller index.
struct TouchingPair {
  const PairRule* rule = nullptr;
  const TouchingShape *A = nullptr, *B = nullptr;
  std::uint64_t id = 0;      ///< number of its first contact
  std::size_t i = 0, j = 0;  ///< indices of the shapes, i < j
  explicit operator bool() const { return rule != nullptr; }
};

class PairRules {
 public:
  /// Finds the rules of all shapes of `shapes`, which is borrowed and gets the planes of motion of
  /// all pairs. Throws ModelError naming every pair of materials without a rule or with two, and
  /// every pair of shapes whose contact is not implemented.
  void find(ShapeSet& shapes, const Topology& topology, const StartKinematics& start,
            PairLaws& laws, const PairTable& kernels);

  /// The pair of the shapes i, j in any order; false: they never touch.
  TouchingPair pair(int i, int j) const;
  /// Do the shapes i and j touch as bodies in space?
  bool touchInSpace(std::size_t i, std::size_t j) const {
    const int rule = of(i, j);
    return rule >= 0 && rules_[static_cast<std::size_t>(rule)].plane == 0;
  }
  /// Name of contact number `id`; empty: there is no such contact.
  std::string contactName(std::uint64_t id) const;
  /// Name of the pair of contact `id`, without the feature.
  std::string pairName(std::uint64_t id) const;
  /// How many pairs of shapes can touch.
  std::int64_t count() const { return count_; }
  /// All pairs (i, j), if they are few enough for signals of single contacts.
  const std::vector<std::pair<int, int>>& few() const { return few_; }
  /// Most contacts of one pair. Contact f of the shapes i < j has number (i n + j) features() + f.
  std::uint64_t features() const { return features_; }

 private:
  TouchingPair named(std::uint64_t id, std::string& name) const;
  friend class RuleSearch;
  /// Index into `rules_` of the shapes i and j, −1: they never touch.
  int of(std::size_t i, std::size_t j) const {
    return table_[static_cast<std::size_t>(group_[i]) * groups_ +
                  static_cast<std::size_t>(group_[j])];
  }
  void checkNumbers() const;
  void listFew();

  const ShapeSet* shapes_ = nullptr;
  std::vector<int> group_;  ///< per shape
  std::size_t groups_ = 0;
  std::vector<int> table_;  ///< groups × groups: index into `rules_`, −1: never
  std::vector<PairRule> rules_;
  std::vector<std::pair<int, int>> few_;
  std::int64_t count_ = 0;
  std::uint64_t features_ = 1;
};

}  // namespace dynamy
