#pragma once
// Rows of numbers over time.

#include <cstddef>
#include <span>
#include <vector>

namespace armlet::lab {

// Rows of numbers over time, `columns` each. Long lists are thinned: of each further kMost rows,
// half as many are kept as of those before.
class Rows {
 public:
  static constexpr std::size_t kMost = 60'000;

  explicit Rows(std::size_t columns) : columns_(columns) {}

  // `is_kept`: the row is kept in any case.
  void add(std::span<const double> row, bool is_kept = false);

  [[nodiscard]] std::size_t columns() const { return columns_; }
  [[nodiscard]] std::size_t count() const { return values_.size() / columns_; }
  [[nodiscard]] std::span<const double> rows(std::size_t first, std::size_t count) const {
    return {values_.data() + first * columns_, count * columns_};
  }
  [[nodiscard]] std::size_t bytes() const { return values_.size() * sizeof(double); }

 private:
  std::size_t columns_;
  std::size_t stride_ = 1;
  std::size_t skipped_ = 0;
  std::vector<double> values_;
};

}  // namespace armlet::lab
