#include <algorithm>
#include <dynamy/core/workers.hpp>
#include <exception>

namespace dynamy {
namespace {

/// Number of times a waiting thread looks for work before it sleeps: sweeps follow each other
/// within microseconds.
constexpr int kLooksForWork = 2000;

/// Waits until `value` is not `old` any more.
template <class T>
void await(const std::atomic<T>& value, T old) {
  for (int i = 0; i < kLooksForWork; ++i)
    if (value.load(std::memory_order_acquire) != old) return;
  value.wait(old, std::memory_order_acquire);
}

}  // namespace

Workers::Workers(int threads) {
  try {
    threads_.reserve(static_cast<std::size_t>(std::max(threads - 1, 0)));
    for (int i = 1; i < threads; ++i) threads_.emplace_back([this] { work(); });
  } catch (const std::exception&) {  // no more threads available: those that exist do the work
  }
}

Workers::~Workers() {
  end_.store(true);
  task_.fetch_add(1);
  task_.notify_all();
  for (std::thread& t : threads_) t.join();
}

void Workers::take() {
  for (int part = next_.fetch_add(1); part < parts_; part = next_.fetch_add(1)) call_(job_, part);
}

namespace {

/// A job whose first exception is kept for the caller: an exception that leaves a thread would end
/// the program. Parts that no thread has begun are then skipped.
struct Guarded {
  void (*call)(void*, int);
  void* job;
  std::atomic<bool> failed{false};
  std::exception_ptr fault = nullptr;

  void operator()(int part) {
    if (failed.load(std::memory_order_relaxed)) return;
    try {
      call(job, part);
    } catch (...) {
      if (!failed.exchange(true)) fault = std::current_exception();
    }
  }
};

}  // namespace

void Workers::share(int parts, void* job) {
  Guarded guarded{call_, job};
  call_ = [](void* what, int part) { (*static_cast<Guarded*>(what))(part); };
  parts_ = parts, job_ = &guarded;
  if (threads_.empty() || parts < 2) {
    for (int part = 0; part < parts; ++part) call_(job_, part);
  } else {
    next_.store(0);
    busy_.store(static_cast<int>(threads_.size()));
    task_.fetch_add(1, std::memory_order_release);
    task_.notify_all();
    take();
    for (int busy = busy_.load(); busy > 0; busy = busy_.load()) await(busy_, busy);
  }
  job_ = nullptr;
  if (guarded.fault) std::rethrow_exception(guarded.fault);
}

void Workers::work() {
  for (unsigned seen = 0;; ++seen) {
    await(task_, seen);
    if (end_.load()) return;
    take();
    if (busy_.fetch_sub(1) == 1) busy_.notify_all();
  }
}

}  // namespace dynamy
