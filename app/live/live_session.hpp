/// LiveSession: what passes between the run and the page that shows it.
///
/// The page asks for the growth of the recorded files and sends commands; the run takes the commands
/// between two steps and publishes its state. The files are the queue between both: a slow page
/// delays no step, and a page that is loaded again reads everything from their beginning. Rejected:
/// a channel that pushes pictures, which needs a bounded queue and drops some of them.
#pragma once
#include <dynamy/io/run_files/run_folder.hpp>

#include <array>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <future>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "live/loopback_server.hpp"

namespace dynamy::app {

/// A command of the page, and the promise of its answer: "" or why it was refused.
struct LiveCommand {
  std::string what, name;
  std::vector<double> values;
  std::promise<std::string> answer;
};

/// The state of the run as the page shows it.
struct LiveState {
  std::string phase = "waiting";  ///< waiting, running, paused, ended
  double t = 0.0;                 ///< [s]
  double pace = 1.0;              ///< of simulated over wall time; 0: as fast as it can
  long steps = 0, actions = 0;
  std::map<std::string, double> parameters, inputs;
  std::string end;  ///< how the run ended
};

class LiveSession {
 public:
  /// `page`: the page as HTML. Both outlive the session.
  LiveSession(const RunFolder& folder, const std::string& page) : folder_(folder), page_(page) {}
  /// Answers the page; called by several threads.
  WebAnswer answer(const WebRequest& request);

  // For the run.
  /// Waits for a command, at most this long; null: none came.
  std::unique_ptr<LiveCommand> next(std::chrono::duration<double> wait);
  void publish(LiveState state);
  /// True: the page asked for something within the last `seconds`.
  bool isWatched(double seconds) const;
  /// True: the page has said that it got everything of a run that has ended.
  bool isDone() const;
  /// No command is taken any more; those that wait are refused.
  void close();

 private:
  using Clock = std::chrono::steady_clock;
  WebAnswer feed(std::string_view query);
  WebAnswer order(std::string_view body);
  std::string stateText() const;
  const RunFolder& folder_;
  const std::string& page_;
  mutable std::mutex guard_;  // of what follows
  std::condition_variable commanded_, changed_;
  std::deque<std::unique_ptr<LiveCommand>> commands_;
  LiveState state_;
  unsigned long number_ = 1;  // of the state and of the files' growth
  Clock::time_point asked_{};
  bool closed_ = false, done_ = false;
};

}  // namespace dynamy::app
