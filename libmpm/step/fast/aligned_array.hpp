#pragma once
#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include "libmpm/core/archive.hpp"

namespace mpm::fast {

/// Numbers that start on a cache line, zero at first.
template <class T>
class AlignedArray {
 public:
  AlignedArray() = default;
  explicit AlignedArray(std::size_t size)
      : size_(size), data_(static_cast<T*>(::operator new(size * sizeof(T), line))) {
    std::fill_n(data(), size, T{});
  }
  T* data() { return data_.get(); }
  const T* data() const { return data_.get(); }
  std::size_t size() const { return size_; }
  T& operator[](std::size_t i) { return data_.get()[i]; }
  const T& operator[](std::size_t i) const { return data_.get()[i]; }

 private:
  static constexpr std::align_val_t line{64};
  struct Free {
    void operator()(T* p) const { ::operator delete(p, line); }
  };
  std::size_t size_ = 0;
  std::unique_ptr<T, Free> data_;
};

/// The first n of them.
template <class T>
void carry(AlignedArray<T>& values, std::size_t n, const std::string& name, Archive& a) {
  std::vector<double> column(values.data(), values.data() + (a.loading() ? 0 : n));
  a.numbers(name, column);
  if (!a.loading()) return;
  if (column.size() > values.size()) values = AlignedArray<T>(column.size());
  std::transform(column.begin(), column.end(), values.data(), [](double v) { return static_cast<T>(v); });
}

}  // namespace mpm::fast
