#include "render/crew.h"

namespace lumaknot {
namespace {

/// Waits until `value` is no longer `old`: awake for some microseconds, as the steps of a frame
/// follow each other, then asleep.
void wait_while(const std::atomic<int>& value, int old) {
  for (int i = 0; i < 2000; ++i) {
    if (value.load(std::memory_order_acquire) != old) return;
#ifdef __x86_64__
    __builtin_ia32_pause();
#endif
  }
  value.wait(old, std::memory_order_acquire);
}

}  // namespace

Crew::Crew(int size) {
  for (int i = 1; i < size; ++i) {
    threads_.emplace_back([this, i] {
      for (int seen = 0;; ++seen) {
        wait_while(round_, seen);
        if (leaving_) return;
        work(i);
        idle_.fetch_add(1, std::memory_order_acq_rel);
        idle_.notify_one();
      }
    });
  }
}

Crew::~Crew() {
  leaving_ = true;
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void Crew::work(int worker) {
  for (int i; (i = next_.fetch_add(1, std::memory_order_relaxed)) < count_;) (*task_)(i, worker);
}

void Crew::run(int count, const std::function<void(int, int)>& task) {
  task_ = &task;
  count_ = count;
  next_.store(0, std::memory_order_relaxed);
  idle_.store(0, std::memory_order_relaxed);
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  work(0);
  for (int idle; (idle = idle_.load(std::memory_order_acquire)) < size() - 1;) {
    wait_while(idle_, idle);
  }
}

}  // namespace lumaknot
