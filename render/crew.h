/// Threads that stay.
#pragma once

#include <atomic>
#include <functional>
#include <thread>
#include <vector>

namespace lumaknot {

/// Threads that wait for work between frames, so that a frame starts none and allocates nothing.
class Crew {
 public:
  /// `size` >= 1, the caller's thread included.
  explicit Crew(int size);
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  int size() const { return int(threads_.size()) + 1; }

  /// Calls task(i, worker) once for each i in [0, count), i in rising order to whoever is free;
  /// 0 <= worker < size(). Returns when all are done. `task` must not throw.
  void run(int count, const std::function<void(int, int)>& task);

 private:
  void work(int worker);

  const std::function<void(int, int)>* task_ = nullptr;
  int count_ = 0;
  std::atomic<int> next_{0}, idle_{0}, round_{0};
  bool leaving_ = false;
  std::vector<std::thread> threads_;  // last: they use what is above
};

}  // namespace lumaknot
