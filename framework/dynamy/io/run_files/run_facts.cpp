#include <fmt/format.h>
#include <dynamy/core/version.hpp>
#include <dynamy/io/run_files/run_facts.hpp>
#include <dynamy/io/run_files/run_recording.hpp>
#include <dynamy/simulation/report/run_watch.hpp>

namespace dynamy {
namespace {

using Given = std::vector<std::pair<std::string, std::string>>;

void write(JsonWriter& json, const char* name, const Worst& w) {
  json.key(name).beginObject().member("value", w.value);
  if (w.value > 0.0) json.member("contact", w.name).member("t", w.t);
  json.endObject();
}

void write(JsonWriter& json, const Unsolved& u) {
  json.key("unsolved").beginObject().member("step", u.step).member("t", u.t);
  json.member("status", u.status).member("residual", u.residual);
  json.member("iterations", u.iterations).member("contact", u.contact).member("tried", u.tried);
  json.member("findings", u.findings).endObject();
}

void write(JsonWriter& json, const EnergyReport& e) {
  json.key("energy").beginObject();
  json.member("start", e.start()).member("end", e.end());
  json.member("kineticStart", e.kineticStart).member("potentialStart", e.potentialStart);
  json.member("kineticEnd", e.kineticEnd).member("potentialEnd", e.potentialEnd);
  json.member("nonPotential", e.nonPotential).member("friction", e.friction);
  json.member("normal", e.normal).member("joints", e.joints).member("boundaries", e.boundaries);
  json.member("discretisation", e.discretisation).member("imbalance", e.imbalance);
  json.member("largestGain", e.largestGain).member("largestGainTime", e.largestGainTime);
  json.endObject();
}

void write(JsonWriter& json, const std::vector<CheckResult>& checks) {
  json.key("checks").beginArray();
  for (const CheckResult& c : checks) {
    json.beginObject().member("signal", c.signal).member("measure", c.measure);
    if (!c.over.empty()) json.member("over", c.over);
    json.member("got", c.got).member("low", c.low).member("high", c.high);
    json.member("expected", c.expected).member("pass", c.pass);
    if (!c.note.empty()) json.member("note", c.note);
    json.endObject();
  }
  json.endArray();
}

void write(JsonWriter& json, const char* name, const StartReport::Part& p) {
  json.key(name).beginObject().member("off", p.off).member("left", p.left);
  json.member("joints", p.joints).member("joint", p.joint).endObject();
}

void write(JsonWriter& json, const StartReport& s) {
  json.key("start").beginObject();
  write(json, "positions", s.positions);
  write(json, "velocities", s.velocities);
  json.member("share", s.velocities.share).member("kineticBefore", s.kineticBefore);
  json.member("kineticAfter", s.kineticAfter).endObject();
}

void writeSettings(JsonWriter& json, const Model& model, const Given& set) {
  json.key("settings").beginObject();
  json.member("until", model.simulation.until).member("step", model.simulation.step);
  json.member("tolerance", model.simulation.tolerance);
  json.member("integrator", model.scheme().type()).member("solver", model.solver().type());
  json.member("impactLaw", model.impactLaw().type());
  json.member("gTol", gTolOf(model));
  json.member("every", model.record.every);
  const Composition& c = model.composed;
  json.key("coordinates").beginObject().member("joints", c.coordinates).member("of", c.joints);
  json.member("velocities", c.velocitiesAfter).member("inBodies", c.velocitiesBefore);
  json.member("rowsSaved", c.rowsSaved).member("flat", c.flat).member("plane", c.plane).endObject();
  json.key("set").beginObject();
  for (const auto& [name, value] : set) json.member(name, value);
  json.endObject().endObject();
}

void writeSleep(JsonWriter& json, const SleepReport& s) {
  json.key("sleep").beginObject().member("asleep", s.asleep).member("most", s.most);
  json.member("slept", s.slept).member("woken", s.woken).member("saved", s.saved);
  json.member("all", s.all).member("energy", s.energy).member("reason", s.reason).endObject();
}

void write(JsonWriter& json, const LocatedReport& r) {
  json.member("switchesLocated", r.switches).member("islands", r.islands);
  json.member("accumulationEnd", r.accumulationEnd);
  json.member("accumulationsPassed", r.accumulations).member("undecided", r.undecided);
}

void write(JsonWriter& json, const SteppingReport& r) {
  json.key("stepping").beginObject().member("periods", r.periods).member("stalls", r.stalls);
  json.member("impatient", r.impatient).member("steps", r.steps).member("systems", r.systems);
  json.member("time", r.time).member("longest", r.longest);
  json.member("error", r.error).member("total", r.total);
  json.member("firstTime", r.first.t).member("firstContact", r.first.name).endObject();
}

}  // namespace

std::string hashText(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

void writeRunFacts(JsonWriter& json, const Model& model, const RunReport& r,
                   const std::vector<CheckResult>& checks, const std::string& state,
                   const Given& set) {
  json.member("state", state);
  if (!r.reason.empty()) json.member("reason", r.reason);
  json.member("dynamy", versionString()).member("title", model.title);
  json.member("model", model.file.name);
  writeSettings(json, model, set);
  const Topology& t = model.topology();
  json.key("sizes").beginObject().member("systems", model.systems().size());
  json.member("q", t.nq()).member("u", t.nu()).member("blocks", t.blocks());
  json.member("contactElements", model.contacts().size());
  json.member("contactsMax", r.contacts.most).endObject();
  json.member("t", r.t).member("steps", r.steps).member("rejected", r.rejected);
  json.member("divided", r.passing.divided).member("finest", r.passing.finest);
  json.member("parted", r.passing.parted)
      .member("left", r.passing.left)
      .member("bounded", r.passing.bounded)
      .member("damped", r.trust.damped)
      .member("dampedLoss", r.trust.dampedLoss)
      .member("slowed", r.trust.slowed.steps);
  json.member("simpler", r.simpler.steps);
  json.member("evaluations", r.cost.evaluations).member("impacts", r.contacts.impacts);
  json.member("switches", r.contacts.switches);
  write(json, r.located);
  json.key("effort").beginObject();
  json.member("smooth", r.cost.effort.smooth).member("rejected", r.cost.effort.rejected);
  json.member("switches", r.cost.effort.switches).member("events", r.cost.effort.events);
  json.member("stepping", r.cost.effort.stepping);
  json.member("looks", r.cost.effort.looks).member("gaps", r.cost.effort.gaps).endObject();
  write(json, r.stepping);
  writeSleep(json, r.cost.sleep);
  json.member("repairedImpacts", r.contacts.repairedImpacts);
  write(json, "energyGain", r.contacts.energyGain);
  json.key("solver").beginObject().member("solves", r.solver.solves);
  json.member("iterations", r.solver.iterations)
      .member("iterationsMean", r.solver.iterationsMean());
  json.member("iterationsMax", r.solver.iterationsMax).member("unconverged", r.solver.unconverged);
  write(json, "worstResidual", r.solver.residual);
  if (r.solver.unsolved.step > 0) write(json, r.solver.unsolved);
  json.endObject();
  write(json, "penetration", r.gaps.penetration);
  write(json, "solvedOverlap", r.gaps.solvedOverlap);
  write(json, "jointError", r.gaps.jointError);
  write(json, r.start);
  json.member("cpu_s", r.cost.cpu).member("wall_s", r.cost.wall);
  write(json, r.energy);
  json.key("figures").beginObject();
  for (const RunFigure& f : runFigures()) json.member(f.name, f.value(r));
  json.endObject();
  writeWarnings(json, r.warnings);
  write(json, checks);
  json.key("signals").beginArray();
  for (const SignalName& s : recordedSignals(model))
    json.beginObject().member("name", s.name).member("unit", s.unit).endObject();
  json.endArray();
  json.member("hash", hashText(r.hash));
}

}  // namespace dynamy
