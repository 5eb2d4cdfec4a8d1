/// A pool of persistent threads.
#pragma once

#include <atomic>
#include <functional>
#include <thread>
#include <vector>

namespace lumaknot::fast {

/// Threads that wait for work between frames, so that a frame starts no threads and allocates
/// nothing.
class ThreadPool {
 public:
  /// `size` >= 1, the caller's thread included.
  explicit ThreadPool(int size);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  int size() const { return int(parts_.size()); }

  /// Calls task(i, worker) once for each i in [0, count), 0 <= worker < size(). Each worker takes
  /// an equal part of them, in ascending order, and then helps with others': so from frame to frame
  /// most of its data are in its own cache. Returns when all are done. `task` must not throw.
  void run(int count, const std::function<void(int, int)>& task);

 private:
  void work(int worker);

  /// What is left of a worker's part, in a cache line of its own.
  struct alignas(64) Part {
    std::atomic<int> next{0};
    int end = 0;
  };

  const std::function<void(int, int)>* task_ = nullptr;
  std::vector<Part> parts_;  ///< one per worker
  std::atomic<int> idle_{0}, round_{0};
  bool leaving_ = false;
  std::vector<std::thread> threads_;  // last: they use the members above
};

}  // namespace lumaknot::fast
