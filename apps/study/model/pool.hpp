#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace study {

/// A pool of objects, each used by one thread at a time.
template <class T>
class Pool {
 public:
  /// Lends an object, and makes one with `make` if all are lent. An object is
  /// not returned if its user throws.
  template <class Make, class Use>
  auto with_one(const Make& make, const Use& use) {
    std::unique_ptr<T> one = take();
    if (!one) one = std::make_unique<T>(make());
    auto result = use(*one);
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(one));
    return result;
  }

 private:
  std::unique_ptr<T> take() {
    const std::lock_guard lock(mutex_);
    if (idle_.empty()) return {};
    std::unique_ptr<T> one = std::move(idle_.back());
    idle_.pop_back();
    return one;
  }

  std::mutex mutex_;
  std::vector<std::unique_ptr<T>> idle_;
};

}  // namespace study
