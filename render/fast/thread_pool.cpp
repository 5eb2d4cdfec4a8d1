#include "render/fast/thread_pool.h"

namespace lumaknot::fast {
namespace {

/// Waits until `value` is no longer `old`: spins for a few microseconds, since the steps of a frame
/// follow each other closely, then sleeps.
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

ThreadPool::ThreadPool(int size) : parts_(std::size_t(size)) {
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

ThreadPool::~ThreadPool() {
  leaving_ = true;
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void ThreadPool::work(int worker) {
  for (int k = 0; k < size(); ++k) {
    Part& part = parts_[std::size_t((worker + k) % size())];
    const auto next = [&part] { return part.next.fetch_add(1, std::memory_order_relaxed); };
    for (int i = next(); i < part.end; i = next()) (*task_)(i, worker);
  }
}

void ThreadPool::run(int count, const std::function<void(int, int)>& task) {
  task_ = &task;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const auto begin = [&](std::size_t part) {
      return int(std::int64_t(count) * std::int64_t(part) / size());
    };
    parts_[i].next.store(begin(i), std::memory_order_relaxed);
    parts_[i].end = begin(i + 1);
  }
  idle_.store(0, std::memory_order_relaxed);
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  work(0);
  const auto idle = [this] { return idle_.load(std::memory_order_acquire); };
  for (int seen = idle(); seen < size() - 1; seen = idle()) wait_while(idle_, seen);
}

}  // namespace lumaknot::fast
