/// Workers: threads that share parts of a task; what they compute does not depend on their number.
///
///   run(parts, job):  job(0) … job(parts − 1), each once, in any order, on any thread
///
/// The parts depend on the problem, never on the number of threads, and each part writes only its
/// own results: any number of threads gives the same bits. A thread per task was rejected: a sweep
/// over 20 000 contacts takes a millisecond, starting a thread a tenth of that.
#pragma once
#include <atomic>
#include <thread>
#include <vector>

namespace dynamy {

class Workers {
 public:
  /// Up to `threads` ≥ 1 threads, the caller's included; fewer if the operating system refuses.
  explicit Workers(int threads);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;
  int threads() const { return static_cast<int>(threads_.size()) + 1; }

  /// Returns when all parts are done. If a part throws, parts not begun are skipped, and run()
  /// throws the same exception. `job` must not call run().
  template <class Job>
  void run(int parts, Job&& job) {
    call_ = [](void* what, int part) { (*static_cast<std::remove_reference_t<Job>*>(what))(part); };
    share(parts, const_cast<void*>(static_cast<const void*>(&job)));
  }

 private:
  void share(int parts, void* job);
  void work();
  void take();
  std::vector<std::thread> threads_;
  void (*call_)(void*, int) = nullptr;
  void* job_ = nullptr;
  int parts_ = 0;
  std::atomic<int> next_{0};       // the first part that nobody has taken
  std::atomic<int> busy_{0};       // threads that have not seen the end of the task
  std::atomic<unsigned> task_{0};  // counts tasks
  std::atomic<bool> end_{false};
};

}  // namespace dynamy
