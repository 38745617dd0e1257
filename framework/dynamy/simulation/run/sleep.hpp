/// Sleep: islands of bodies at rest, which the steps of a run leave out (theory 58).
///
///   awake → asleep    every kSteps steps: slower than `sleep` for kSteps steps, and RestTrial: u := 0
///   asleep → awake    a contact with the island that is closed or presses in an attempted step,
///                     which is then taken again
///
/// While an island sleeps its q and u keep their bits. Steps evaluate and move the systems of awake()
/// alone, which see the others as shapes at rest. Rejected: a body that sleeps by itself, since the
/// forces of its neighbours hold it.
#pragma once
#include <dynamy/simulation/report/run_report.hpp>
#include <dynamy/simulation/run/rest_rules.hpp>
#include <dynamy/simulation/run/rest_trial.hpp>
#include <dynamy/stages/islands.hpp>
#include <utility>

namespace dynamy {

/// What fell asleep or woke, for observers.
struct RestChange {
  std::vector<int> systems;
  std::vector<ContactKey> contacts;  ///< of these systems, ascending
  double energy = 0.0;               ///< taken by u := 0 [J]
  /// Percussions of the contacts at rest, in the rows of the last step; those of others are its own
  /// [N s].
  Eigen::VectorXd Lambda;
};

class Sleep {
 public:
  /// `planned`: another run has chosen the steps, which are repeated; nothing sleeps then.
  explicit Sleep(Model& model, bool planned = false);
  /// The systems that are awake, which a run's system is to be a view of; null: none may sleep.
  const SystemSubset* awake() const { return rules_.any() ? &awake_ : nullptr; }
  /// Called once, with the parts of that system, before the first step.
  void begin(const SystemParts& parts);
  /// Nothing sleeps in a run that this observer sees, if it reads contacts.
  void heed(const Observer& observer) { off_ = off_ || observer.readsContacts(); }
  /// Why nothing sleeps in this run although the model requests it; empty: something may.
  std::string reason() const;

  /// True: nothing is awake that could move or touch anything.
  bool allAsleep() const { return asleep_ > 0 && awake_.systems().empty(); }
  /// After an attempted step of `s` from `before`: wakes the islands that it has touched. True: the
  /// step is to be taken again from `before`, which knows their percussions.
  bool wakes(const MechanicalSystem& s, State& before);
  /// After an accepted step to x of length dt [s]: lets islands fall asleep.
  void settle(MechanicalSystem& s, State& x, double dt, SleepReport& report);
  /// What woke since the last call, and what the last settle() let fall asleep.
  RestChange woken() { return std::exchange(woken_, {}); }
  const RestChange& slept() const { return slept_; }
  void archive(Archive& a);

  /// Steps that a system has to be slow for; islands are looked for as rarely.
  static constexpr int kSteps = 16;

 private:
  static constexpr int kAwake = -1;
  struct HeldContact {
    ContactKey key;
    int island, first, rows;  // first: in forces_
    void archive(Archive& a) { a(key), a(island), a(first), a(rows); }
  };
  int islandOf(int system) const { return island_[static_cast<std::size_t>(system)]; }
  void assign();
  void countSlowSteps(const State& x);
  std::vector<QuietIsland> quietIslands(const MechanicalSystem& s);
  void putToSleep(const MechanicalSystem& s, const std::vector<QuietIsland>& islands, State& x,
                  double dt);
  void holdContacts(const MechanicalSystem& s, double dt);
  int touched(const MechanicalSystem& s, int contact) const;
  void wake(int island, State& before);
  void handOn(int island, RememberedImpulses& to);

  Model& model_;
  RestRules rules_;
  Eigen::VectorXd perUnit_;  // makes velocities of all units speeds [m/s]
  RestTrial trial_;
  Islands islands_;
  SystemParts parts_;
  bool off_ = false;
  SystemSubset awake_{SystemSubset::Outside::resting};
  std::vector<int> island_;  // per system: the first system of its sleeping island, kAwake
  std::vector<int> slow_;    // per system: steps in which it was slow, one after the other
  std::vector<int> systemOfBlock_;
  std::vector<HeldContact> held_;  // by key
  std::vector<double> forces_;     // of these contacts [N]
  long steps_ = 0, asleep_ = 0;    // of all systems; systems that sleep
  RestChange woken_, slept_;
};

}  // namespace dynamy
