#include "live/live_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>

#include "live/driven_run.hpp"
#include "live/live_page.hpp"
#include "live/live_session.hpp"
#include "run/endings.hpp"
#include "run/run_text.hpp"

namespace dynamy::app {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr Seconds kSlice{0.05};       ///< longest wait without a look at signals of the system
constexpr Seconds kPicture{0.03};     ///< wall time between two writes of the recorded files
constexpr double kUnwatched = 5.0;    ///< the run waits if no page has asked for so long [s]
constexpr double kFarewell = 3.0;     ///< a page that has gone does not get the end of the run [s]
constexpr double kFirstPage = 600.0;  ///< a run that nobody looks at ends after so long [s]

/// The pace at which the whole run takes a few seconds, as the replay chooses it.
double firstPace(double until) {
  double pace = 1.0;
  for (const double p : {0.5, 0.2, 0.1, 0.05, 0.02, 0.01})
    if (until / pace < 4.0) pace = p;
  return pace;
}

/// The loop of a live run: commands, pace, steps.
class LiveLoop {
 public:
  LiveLoop(DrivenRun& run, LiveSession& session) : run_(run), session_(session) {
    state_.pace = firstPace(run.choice().until);
    state_.parameters = run.parameters(), state_.inputs = run.inputs();
    tell();
  }
  /// Runs to the end. Returns the signal that ended it, or 0.
  int runToEnd();
  /// Publishes that the run has ended, and waits until the page knows.
  void farewell(const std::string& how);

 private:
  void tell();
  void show(bool anyway);
  Seconds ahead() const;
  void anchor() { wallAt_ = Clock::now(), tAt_ = run_.t(); }
  bool obey(LiveCommand& command);
  std::string carryOut(const LiveCommand& command);
  std::string grab(const LiveCommand& command);
  std::string setPace(const LiveCommand& command);

  DrivenRun& run_;
  LiveSession& session_;
  LiveState state_;
  Clock::time_point wallAt_{}, shownAt_{};
  double tAt_ = 0.0;
  bool paused_ = false, ended_ = false;
};

void LiveLoop::tell() {
  state_.t = run_.t(), state_.steps = run_.steps(), state_.actions = run_.actions();
  session_.publish(state_);
}

/// Writes what is recorded, and tells the page.
void LiveLoop::show(bool anyway) {
  const Clock::time_point now = Clock::now();
  if (!anyway && now - shownAt_ < kPicture) return;
  shownAt_ = now;
  run_.flush();
  tell();
}

/// Wall time until the run may go on at its pace.
Seconds LiveLoop::ahead() const {
  if (!(state_.pace > 0.0)) return Seconds(0.0);
  return Seconds((run_.t() - tAt_) / state_.pace) - (Clock::now() - wallAt_);
}

int LiveLoop::runToEnd() {
  const EndingSignals signals;
  const Clock::time_point begun = Clock::now();
  bool seen = false;
  anchor();
  while (!ended_) {
    if (signals.requested()) {
      run_.apply({});  // the end
      run_.step();
      return EndingSignals::signal();
    }
    const bool watched = session_.isWatched(kUnwatched);
    seen = seen || watched;
    if (!seen && Clock::now() - begun > Seconds(kFirstPage)) run_.apply({}), ended_ = true;
    const char* phase = !watched ? "waiting" : paused_ ? "paused" : "running";
    if (state_.phase != phase) state_.phase = phase, anchor(), show(true);
    const bool goes = watched && !paused_;
    // A run that is slower than its pace does not hurry afterwards.
    Seconds wait = goes ? ahead() : kSlice;
    if (wait < -kSlice) anchor();
    if (wait > kPicture) show(false);
    wait = std::clamp(wait, Seconds(0.0), kSlice);
    if (const auto command = session_.next(wait)) {
      if (obey(*command)) show(true);
      continue;
    }
    if (!goes || ahead() > Seconds(0.0)) continue;
    if (!run_.step()) ended_ = true;
    show(false);
  }
  run_.step();  // takes none: the run is at its end, which observers see now
  return 0;
}

/// True: the state has changed.
bool LiveLoop::obey(LiveCommand& command) {
  const std::string refused = carryOut(command);
  if (refused.empty() && (command.what == "set" || command.what == "input"))
    state_.parameters = run_.parameters(), state_.inputs = run_.inputs();
  command.answer.set_value(refused);
  return refused.empty();
}

std::string LiveLoop::carryOut(const LiveCommand& c) {
  const auto numbers = [&](std::size_t n) { return c.values.size() == n; };
  const auto act = [&](Action::What what) {
    Action a;
    a.what = what, a.name = c.name, a.values = c.values;
    return run_.apply(std::move(a));
  };
  if (c.what == "pause") return paused_ = true, "";
  if (c.what == "go") return paused_ = false, anchor(), "";
  if (c.what == "step") return paused_ = true, ended_ = !run_.step(), "";
  if (c.what == "pace") return setPace(c);
  if (c.what == "set" && numbers(1)) return act(Action::What::set);
  if (c.what == "input" && numbers(1)) return act(Action::What::input);
  if (c.what == "grab" && numbers(8)) return grab(c);
  if (c.what == "move" && numbers(3)) return act(Action::What::move);
  if (c.what == "release" && numbers(0)) return act(Action::What::release);
  if (c.what == "end" && numbers(0)) return ended_ = true, act(Action::What::end);
  return "there is no command \"" + c.what + "\" with " + std::to_string(c.values.size()) +
         " numbers";
}

/// Numbers: frame of the scene, point in its axes, target, strength.
std::string LiveLoop::grab(const LiveCommand& c) {
  const std::vector<double>& x = c.values;
  if (!(x[0] >= 0.0 && x[0] < 1e9) || !(x[7] > 0.0 && x[7] <= 1e4))
    return "the frame or the strength is out of range";
  auto action = run_.grab(static_cast<int>(x[0]), {x[1], x[2], x[3]}, {x[4], x[5], x[6]}, x[7]);
  return action ? run_.apply(std::move(*action)) : "this body does not move";
}

std::string LiveLoop::setPace(const LiveCommand& c) {
  if (c.values.size() != 1 || !(c.values[0] >= 0.0)) return "the pace is a number, 0 or above";
  state_.pace = c.values[0], anchor();
  return {};
}

void LiveLoop::farewell(const std::string& how) {
  session_.close();
  state_.phase = "ended", state_.end = how;
  tell();
  while (!session_.isDone() && session_.isWatched(kFarewell))
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
}

}  // namespace

int runLive(Program& program, const RunChoice& choice, const std::filesystem::path& folder,
            const RunShow& show, bool browser) {
  program.load();
  addHands(program.registry);
  DrivenRun run(program, choice, folder);
  run.start(show);
  const std::string page = livePage(run);
  LiveSession session(run.folder(), page);
  LoopbackServer server([&](const WebRequest& request) { return session.answer(request); });
  const LiveDoor door(run.folder(), server.address());
  if (!show.quiet) fmt::print("{}", headText(run.model(), run.choice()));
  fmt::print(" live    {}\n", server.address());
  std::fflush(stdout);
  if (browser && !door.open())
    fmt::print(stderr, "dynamy: no browser was found; open this address by hand\n");
  LiveLoop loop(run, session);
  const int signal = loop.runToEnd();
  const int status = run.conclude(show, signal);
  loop.farewell(stateText(run.report()));
  return status;
}

}  // namespace dynamy::app
