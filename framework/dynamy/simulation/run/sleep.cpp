#include <algorithm>
#include <cmath>
#include <dynamy/simulation/run/sleep.hpp>
#include <dynamy/stages/error_norm.hpp>

namespace dynamy {
namespace {

/// After a trial in vain an island waits a step longer for each so many contacts: trials of a large
/// heap, which take as long as steps, are rare.
constexpr int kPerStep = 4;

/// True: the problem posed last is that of the contacts in slot 0.
bool isPosed(const MechanicalSystem& s) {
  const ImpactProblem& p = s.problem();
  return p.contacts == &s.slot(0).contacts && p.gammaA.size() == static_cast<std::size_t>(p.rows());
}

/// True: the contact is closed or presses in the last step, or that step does not say.
bool acts(const MechanicalSystem& s, int contact) {
  if (!isPosed(s)) return true;
  const ContactSet& c = s.slot(0).contacts;
  const auto at = static_cast<std::size_t>(contact);
  const int row = c.row0[at];
  return !c.law[at]->unilateral() || c.position[static_cast<std::size_t>(row)] <= s.gTol() ||
         !s.problem().Lambda().segment(row, c.dim(contact)).isZero(0.0);
}

Eigen::VectorXd perUnitOf(const Model& model) {
  Eigen::VectorXd q, u;
  unitScales(model.topology(), model.length(), q, u);
  return model.length() * u.cwiseInverse();
}

RestRules rulesOf(Model& model, bool planned) {
  model.readyScheme();
  return RestRules(model, planned);
}

}  // namespace

Sleep::Sleep(Model& model, bool planned)
    : model_(model),
      rules_(rulesOf(model, planned)),
      perUnit_(rules_.any() ? perUnitOf(model) : Eigen::VectorXd()),
      trial_(perUnit_) {}

std::string Sleep::reason() const {
  if (off_ && rules_.any()) return "an observer reads contacts";
  if (rules_.any() && !model_.scheme().stepsSome())
    return "<" + model_.scheme().type() + "> steps all systems of a model with joints";
  return rules_.reason();
}

void Sleep::begin(const SystemParts& parts) {
  if (!rules_.any()) return;
  parts_ = parts;
  const Topology& topology = *parts.topology;
  island_.assign(topology.systems().size(), kAwake), slow_.assign(island_.size(), 0);
  for (std::size_t i = 0; i < island_.size(); ++i)
    systemOfBlock_.insert(systemOfBlock_.end(),
                          static_cast<std::size_t>(topology.system(static_cast<int>(i)).blocks),
                          static_cast<int>(i));
  assign();
}

void Sleep::assign() {
  asleep_ = std::count_if(island_.begin(), island_.end(), [](int i) { return i != kAwake; });
  std::vector<char> without(island_.size(), 0);
  for (std::size_t i = 0; i < without.size(); ++i)
    without[i] = island_[i] != kAwake || rules_.still(static_cast<int>(i)) ? 1 : 0;
  awake_.assign(*parts_.topology, std::move(without), parts_.forces, parts_.contacts);
}

/// The sleeping island that a contact of an attempted step touches, kAwake: none. Contacts among
/// systems that sleep are those of elements that report all pairs: nothing presses them.
int Sleep::touched(const MechanicalSystem& s, int contact) const {
  const ContactSet& c = s.slot(0).contacts;
  const auto at = static_cast<std::size_t>(contact);
  int island = kAwake, asleep = 0;
  const int first = c.segment0[at], end = c.segment0[at + 1];
  for (int k = first; k < end; ++k) {
    const int block = c.segment[static_cast<std::size_t>(k)].block;
    const int of = islandOf(systemOfBlock_[static_cast<std::size_t>(block)]);
    if (of != kAwake) island = of, ++asleep;
  }
  return island != kAwake && (asleep < end - first || asleep == 1) && acts(s, contact) ? island
                                                                                       : kAwake;
}

bool Sleep::wakes(const MechanicalSystem& s, State& before) {
  if (asleep_ == 0) return false;
  bool any = false;
  for (int i = 0; i < s.slot(0).contacts.size(); ++i) {
    const int island = touched(s, i);
    if (island != kAwake) wake(island, before), any = true;
  }
  if (any) assign(), std::sort(woken_.contacts.begin(), woken_.contacts.end());
  return any;
}

void Sleep::wake(int island, State& before) {
  for (int i = 0; i < static_cast<int>(island_.size()); ++i)
    if (islandOf(i) == island) {
      island_[static_cast<std::size_t>(i)] = kAwake, slow_[static_cast<std::size_t>(i)] = 0;
      woken_.systems.push_back(i);
    }
  handOn(island, before.impulses);
}

/// Moves the percussions of a sleeping island to those that the next step begins with.
void Sleep::handOn(int island, RememberedImpulses& to) {
  if (!(to.dt > 0.0)) to.dt = model_.simulation.step;
  if (to.first.empty()) to.first.push_back(0);
  for (const HeldContact& h : held_) {
    if (h.island != island) continue;
    woken_.contacts.push_back(h.key);
    to.key.push_back(h.key);
    for (int r = 0; r < h.rows; ++r)
      to.Lambda.push_back(to.dt * forces_[static_cast<std::size_t>(h.first + r)]);
    to.first.push_back(static_cast<int>(to.Lambda.size()));
  }
  std::erase_if(held_, [&](const HeldContact& h) { return h.island == island; });
  if (held_.empty()) forces_.clear();
}

void Sleep::settle(MechanicalSystem& s, State& x, double dt, SleepReport& report) {
  slept_ = {};
  if (!rules_.any() || off_) return;
  report.saved += asleep_, report.all += rules_.moving();
  countSlowSteps(x);
  if (++steps_ % kSteps == 0 && model_.scheme().stepsSome()) {
    std::vector<QuietIsland> islands = quietIslands(s);
    trial_.find(s, model_.solver(), x, dt, rules_.still(), islands);
    putToSleep(s, islands, x, dt);
  }
  report.asleep = asleep_, report.most = std::max(report.most, report.asleep);
  report.slept += static_cast<long>(slept_.systems.size());
  report.energy += slept_.energy;
}

void Sleep::countSlowSteps(const State& x) {
  for (const int i : awake_.systems()) {
    if (!rules_.may(i)) continue;
    const SystemHandle& s = parts_.topology->system(i);
    double speed = 0.0;
    for (int k = s.u0; k < s.u0 + s.nu; ++k)
      speed = std::max(speed, std::abs(x.u[k]) * perUnit_[k]);
    int& steps = slow_[static_cast<std::size_t>(i)];
    steps = speed < model_.simulation.sleep ? std::min(steps + 1, kSteps) : std::min(steps, 0);
  }
}

/// The islands that are awake and all of whose systems have been slow long enough.
std::vector<QuietIsland> Sleep::quietIslands(const MechanicalSystem& s) {
  std::vector<QuietIsland> out;
  const std::vector<int>& awake = awake_.systems();
  const auto slow = [&](int i) { return slow_[static_cast<std::size_t>(i)] == kSteps; };
  if (std::none_of(awake.begin(), awake.end(), slow) || !islands_.start(parts_)) return out;
  const ContactSet& c = s.slot(0).contacts;
  if (!isPosed(s)) return out;
  for (int i = 0; i < c.size(); ++i)
    if (acts(s, i)) islands_.join(c, i);
  std::vector<int> place(island_.size(), -1);  // of an island by its number; −2: something moves
  for (const int i : awake) {
    int& at = place[static_cast<std::size_t>(islands_.of(i))];
    if (parts_.topology->system(i).nu > 0 && !(rules_.may(i) && slow(i))) at = -2;
  }
  for (const int i : awake) {
    int& at = place[static_cast<std::size_t>(islands_.of(i))];
    if (at == -2 || parts_.topology->system(i).nu == 0) continue;
    if (at < 0) at = static_cast<int>(out.size()), out.emplace_back();
    out[static_cast<std::size_t>(at)].systems.push_back(i);
  }
  for (int i = 0; i < c.size(); ++i) {
    const int system = islands_.systemOf(c, i);
    const int at = system < 0 ? -1 : place[static_cast<std::size_t>(islands_.of(system))];
    if (at >= 0) ++out[static_cast<std::size_t>(at)].contacts;
  }
  return out;
}

void Sleep::putToSleep(const MechanicalSystem& s, const std::vector<QuietIsland>& islands, State& x,
                       double dt) {
  const MassMatrix& mass = s.slot(0).mass;
  for (const QuietIsland& island : islands)
    for (const int i : island.systems) {
      slow_[static_cast<std::size_t>(i)] = island.rests ? 0 : -island.contacts / kPerStep;
      if (!island.rests) continue;
      island_[static_cast<std::size_t>(i)] = island.systems.front();
      const SystemHandle& h = parts_.topology->system(i);
      for (int b = h.block0; b < h.block0 + h.blocks; ++b) {
        const auto u = x.u.segment(mass.u0(b), mass.nu(b));
        slept_.energy += 0.5 * u.dot(mass.M(b) * u);
      }
      x.u.segment(h.u0, h.nu).setZero();
      slept_.systems.push_back(i);
    }
  if (slept_.systems.empty()) return;
  holdContacts(s, dt);
  assign();
}

/// Keeps the contacts of the systems that have just fallen asleep, with their forces.
void Sleep::holdContacts(const MechanicalSystem& s, double dt) {
  const ContactSet& c = s.slot(0).contacts;
  slept_.Lambda = s.problem().Lambda();
  for (int i = 0; i < c.size(); ++i) {
    const int system = islands_.systemOf(c, i);
    if (system < 0 || islandOf(system) == kAwake) continue;
    const ContactKey key = c.key[static_cast<std::size_t>(i)];
    const int rows = c.dim(i);
    held_.push_back({key, islandOf(system), static_cast<int>(forces_.size()), rows});
    const double* force = trial_.force(key, rows);
    for (int r = 0; r < rows; ++r) {
      forces_.push_back(force ? force[r] : 0.0);
      slept_.Lambda[c.row0[static_cast<std::size_t>(i)] + r] = dt * forces_.back();
    }
    slept_.contacts.push_back(key);
  }
  std::sort(slept_.contacts.begin(), slept_.contacts.end());
}

void Sleep::archive(Archive& a) {
  a.section("sleep");
  const std::size_t systems = island_.size();
  a(island_), a(slow_), a(held_), a(forces_), a(steps_), a(woken_.systems), a(woken_.contacts);
  if (island_.size() != systems || slow_.size() != systems)
    throw ModelError("the checkpoint belongs to another model");
  const auto exists = [&](int i) { return i >= 0 && i < static_cast<int>(systems); };
  const auto known = [&](int i) { return i == kAwake || exists(i); };
  const bool sound =
      std::all_of(island_.begin(), island_.end(), known) &&
      std::all_of(woken_.systems.begin(), woken_.systems.end(), exists) &&
      std::all_of(held_.begin(), held_.end(), [&](const HeldContact& h) {
        return known(h.island) && h.first >= 0 && h.rows >= 0 &&
               static_cast<std::size_t>(h.first) + static_cast<std::size_t>(h.rows) <=
                   forces_.size();
      });
  if (!sound) throw ModelError("the checkpoint holds bodies that sleep in no island");
  if (a.reading() && rules_.any()) assign();
}

}  // namespace dynamy
