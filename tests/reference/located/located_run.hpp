/// LocatedRun: a model file or text run to a tolerance by the program's own loop, with its events.
#pragma once
#include <gtest/gtest.h>

#include <build_paths.hpp>
#include <dynamy/core/declared/parameters.hpp>
#include <dynamy/io/model/model_loader.hpp>
#include <dynamy/io/plugin/plugin_loader.hpp>
#include <dynamy/located/located_dormand_prince.hpp>
#include <dynamy/simulation/report/contact_facts.hpp>
#include <dynamy/simulation/run/simulation.hpp>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace dynamy::reference {

class LocatedRun final : public RecordSink {
 public:
  /// The scheme of a model with a tolerance that names none.
  static std::unique_ptr<OneStep> byDefault() { return withClocks("islands"); }
  static std::unique_ptr<OneStep> withPatience(const std::string& factor) {
    return std::make_unique<LocatedDormandPrince>(
        Parameters::of<LocatedDormandPrince>("LocatedDormandPrince", "", {{"patience", factor}}));
  }
  static std::unique_ptr<OneStep> withClocks(const std::string& clocks) {
    return std::make_unique<LocatedDormandPrince>(
        Parameters::of<LocatedDormandPrince>("LocatedDormandPrince", "", {{"clocks", clocks}}));
  }
  /// `what`: a name in models/, or a text that begins with '<'.
  LocatedRun(const std::string& what, double tolerance, double until, const Overrides& set = {},
             const std::function<void(Registry&)>& types = {},
             std::unique_ptr<OneStep> scheme = byDefault())
      : plugins_({DYNAMY_BINARY_DIR "/lib/dynamy"}) {
    registerFramework(registry_);
    if (types) types(registry_);
    plugins_.load(kStandardElements, {}, registry_);
    LoadOptions options;
    options.set = set;
    model_ = std::make_unique<Model>(
        what.starts_with('<') ? loadModelText(what, "scene.xml", registry_, plugins_, options)
                              : loadModel(DYNAMY_SOURCE_DIR "/models/" + what + ".xml", registry_,
                                          plugins_, options));
    model_->scheme(std::move(scheme));
    model_->checks.clear();
    SimulationSettings& s = model_->simulation;
    s.until = until, s.step = 0.0, s.tolerance = tolerance;
    model_->record.framesPerSecond = 0.0;
    model_->record.every = until;
    simulation_ = std::make_unique<Simulation>(*model_);
    simulation_->record(*this);
  }
  const RunReport& run() { return simulation_->run(); }

  void row(double, std::span<const double>) override {}
  void frame(FilmInstant at, std::span<const FramePose> poses,
             std::span<const ContactRecord> contacts) override {
    film.push_back({at.t, {poses.begin(), poses.end()}, {contacts.begin(), contacts.end()}});
  }
  /// Records by the present settings of the model: `every` [s], and pictures a second.
  void record(double every, double framesPerSecond) {
    model_->record.every = every, model_->record.framesPerSecond = framesPerSecond;
    simulation_->record(*this);
  }
  void event(const ContactEvent& e) override { events.push_back(e); }

  /// Instants of the impacts of contact `name` [s].
  std::vector<double> impacts(const std::string& name) const {
    std::vector<double> out;
    for (const ContactEvent& e : events)
      if (e.impact && contactName(*model_, e.key) == name) out.push_back(e.t);
    return out;
  }
  /// Instants at which contact `name` changed to `to` [s].
  std::vector<double> changes(const std::string& name, Status to) const {
    std::vector<double> out;
    for (const ContactEvent& e : events)
      if (!e.impact && e.to == to && contactName(*model_, e.key) == name) out.push_back(e.t);
    return out;
  }
  const State& state() const { return simulation_->state(); }
  /// Value of the signal `name` at the present state, of one that q and u of its system determine.
  double signal(const std::string& name) const {
    const NamedSignal* s = model_->signal(name);
    const SystemHandle& h = model_->topology().system(s->system);
    const State& x = state();
    return s->signal.value({.t = x.t, .q = slice(x.q, h.q0, h.nq), .u = slice(x.u, h.u0, h.nu)});
  }
  const RunReport& report() const { return simulation_->report(); }
  Simulation& simulation() { return *simulation_; }
  Model& model() { return *model_; }
  std::vector<ContactEvent> events;
  struct Picture {
    double t;
    std::vector<FramePose> poses;
    std::vector<ContactRecord> contacts;
  };
  std::vector<Picture> film;

 private:
  Registry registry_;
  PluginLoader plugins_;
  std::unique_ptr<Model> model_;
  std::unique_ptr<Simulation> simulation_;
};

/// Expects the same states, energies and numbers of impacts, bit for bit, and the same numbers by
/// which later steps are decided.
inline void expectSameBits(const LocatedRun& a, const LocatedRun& b) {
  EXPECT_EQ(a.state().q, b.state().q);
  EXPECT_EQ(a.state().u, b.state().u);
  ASSERT_EQ(a.state().scheme.size(), b.state().scheme.size());
  EXPECT_EQ(a.state().scheme, b.state().scheme);
  EXPECT_EQ(a.report().contacts.impacts, b.report().contacts.impacts);
  EXPECT_EQ(a.report().energy.discretisation, b.report().energy.discretisation);
}

/// Expects that a run of `model` to 2.5 s which goes on from a checkpoint at 2 s, taken while or
/// after steps were taken in time, ends with the same bits.
inline void expectToGoOnBitForBit(const std::string& model, double tolerance) {
  LocatedRun whole(model, tolerance, 2.5), part(model, tolerance, 2.0),
      resumed(model, tolerance, 2.5);
  whole.run(), part.run();
  ASSERT_GE(part.report().stepping.periods, 1);
  resumed.simulation().resume(part.simulation().checkpoint());
  resumed.run();
  expectSameBits(resumed, whole);
  EXPECT_EQ(resumed.report().stepping.steps, whole.report().stepping.steps);
}

}  // namespace dynamy::reference
