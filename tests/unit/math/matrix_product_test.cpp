#include "armlet/math/matrix_product.hpp"

#include <doctest/doctest.h>

#include <vector>

#include "armlet/core/random.hpp"

using namespace armlet;

namespace {

std::vector<double> random_values(Random& random, std::size_t count) {
  std::vector<double> values(count);
  for (double& x : values) x = random.uniform(-10, 10);
  return values;
}

// The sum as the header promises it.
double element(const std::vector<double>& a, const std::vector<double>& b, std::size_t i,
               std::size_t j, std::size_t inner, std::size_t cols) {
  double sum = 0.0;
  for (std::size_t k = 0; k < inner; ++k) sum += a[i * inner + k] * b[k * cols + j];
  return sum;
}

void check_product(Random& random, std::size_t rows, std::size_t inner, std::size_t cols) {
  CAPTURE(rows);
  CAPTURE(inner);
  CAPTURE(cols);
  const auto a = random_values(random, rows * inner);
  const auto b = random_values(random, inner * cols);
  std::vector<double> c(rows * cols, -1.0);
  multiply(a.data(), b.data(), c.data(), rows, inner, cols);
  std::size_t different = 0;
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < cols; ++j) {
      different += c[i * cols + j] != element(a, b, i, j, inner, cols) ? 1 : 0;
    }
  }
  CHECK(different == 0);
}

}  // namespace

TEST_CASE("a product has the bits of sums in order, for every size and margin") {
  Random random(1);
  for (std::size_t n = 0; n <= 17; ++n) check_product(random, n, n, n);
  for (int i = 0; i < 200; ++i)
    check_product(random, random.below(24), random.below(24), random.below(24));
  check_product(random, 37, 600, 41);  // deeper than one strip
}

TEST_CASE("a matrix times a vector has the bits of sums in order") {
  Random random(2);
  for (std::size_t rows = 0; rows < 12; ++rows) {
    const std::size_t cols = random.below(20);
    const auto a = random_values(random, rows * cols);
    const auto x = random_values(random, cols);
    std::vector<double> y(rows, -1.0);
    multiply_vector(a.data(), x.data(), y.data(), rows, cols);
    for (std::size_t i = 0; i < rows; ++i) CHECK(y[i] == element(a, x, i, 0, cols, 1));
  }
}

TEST_CASE("what is infinite or undefined in a factor shows in the product") {
  const double a[4] = {0.0, 1.0, 2.0, 3.0};
  const double b[4] = {1.0 / 0.0, 1.0, 1.0, 1.0};
  double c[4];
  multiply(a, b, c, 2, 2, 2);
  CHECK(c[0] != c[0]);  // 0 * inf
  CHECK(c[2] > 1e300);
  CHECK(c[1] == 1.0);
}
