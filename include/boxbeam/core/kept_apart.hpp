#pragma once

#include <memory>
#include <utility>

namespace boxbeam {

/// A value that may be there, like std::optional, but on the heap: for what is large, and moved
/// about more often than it is looked at.
template <class T>
class KeptApart {
 public:
  KeptApart() = default;
  KeptApart(T value) : value_(std::make_unique<T>(std::move(value))) {}
  KeptApart(const KeptApart& other)
      : value_(other.value_ ? std::make_unique<T>(*other.value_) : nullptr) {}
  KeptApart(KeptApart&&) noexcept = default;
  KeptApart& operator=(const KeptApart& other) {
    value_ = other.value_ ? std::make_unique<T>(*other.value_) : nullptr;
    return *this;
  }
  KeptApart& operator=(KeptApart&&) noexcept = default;
  ~KeptApart() = default;

  T& emplace() {
    value_ = std::make_unique<T>();
    return *value_;
  }

  bool has_value() const { return value_ != nullptr; }
  explicit operator bool() const { return has_value(); }
  T& operator*() { return *value_; }
  const T& operator*() const { return *value_; }
  T* operator->() { return value_.get(); }
  const T* operator->() const { return value_.get(); }

 private:
  std::unique_ptr<T> value_;
};

}  // namespace boxbeam
