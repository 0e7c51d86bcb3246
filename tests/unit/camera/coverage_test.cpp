#include "camera/raster/coverage.hpp"

#include <doctest/doctest.h>

#include <vector>

#include "armlet/core/random.hpp"

using namespace armlet;
using namespace armlet::raster;

namespace {

// How often each sample is covered.
struct Counts {
  SampleGrid grid;
  std::vector<int> of;
  explicit Counts(const SampleGrid& g)
      : grid(g), of(static_cast<std::size_t>(g.columns) * static_cast<std::size_t>(g.rows)) {}

  int& at(int column, int row) { return of[static_cast<std::size_t>(row * grid.columns + column)]; }
  void add(const FixedTriangle& t, int by) {
    cover(t, grid, 0, grid.rows, [&](int row, int first, int last) {
      for (int column = first; column < last; ++column) at(column, row) += by;
    });
  }
};

// The rule of edges in another form: by the signs of three products.
bool covers(const FixedTriangle& t, std::int64_t x, std::int64_t y) {
  const std::int64_t area = t.doubled_area();
  if (area == 0) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t from = area > 0 ? i : (i + 1) % 3, to = area > 0 ? (i + 1) % 3 : i;
    const std::int64_t dx = t.x[to] - t.x[from], dy = t.y[to] - t.y[from];
    const std::int64_t e = dx * (y - t.y[from]) - dy * (x - t.x[from]);
    const bool is_top_or_left = dy < 0 || (dy == 0 && dx > 0);
    if (e < 0 || (e == 0 && !is_top_or_left)) return false;
  }
  return true;
}

FixedTriangle random_triangle(Random& random, int size, bool on_samples) {
  FixedTriangle t;
  for (std::size_t k = 0; k < 3; ++k) {
    t.x[k] = static_cast<std::int32_t>(random.uniform(-0.2, 1.2) * size * kOne);
    t.y[k] = static_cast<std::int32_t>(random.uniform(-0.2, 1.2) * size * kOne);
    if (on_samples) {  // edges through many samples
      t.x[k] = t.x[k] / kOne * kOne;
      t.y[k] = t.y[k] / kOne * kOne;
    }
  }
  return t;
}

}  // namespace

TEST_CASE("spans hold the samples that lie right of all edges, by the rule for samples on edges") {
  Random random(5);
  for (int n = 0; n < 3000; ++n) {
    const int samples = n % 2 == 0 ? 1 : 4;
    const SampleGrid grid = SampleGrid::of_picture(n % 3, -(n % 5), 20, 16, samples);
    const FixedTriangle t = random_triangle(random, 20, n % 3 == 0);
    Counts counts(grid);
    counts.add(t, 1);
    int wrong = 0;
    for (int row = 0; row < grid.rows; ++row) {
      for (int column = 0; column < grid.columns; ++column) {
        const bool inside = covers(t, grid.x + column * grid.step, grid.y + row * grid.step);
        wrong += counts.at(column, row) == (inside ? 1 : 0) ? 0 : 1;
      }
    }
    REQUIRE(wrong == 0);
  }
}

TEST_CASE("rows of a triangle are the same whatever band they are drawn in") {
  Random random(6);
  for (int n = 0; n < 500; ++n) {
    const SampleGrid grid = SampleGrid::of_picture(0, 0, 30, 30, 4);
    const FixedTriangle t = random_triangle(random, 30, false);
    Counts whole(grid), parts(grid);
    whole.add(t, 1);
    for (int begin = 0; begin < grid.rows; begin += 7) {
      cover(t, grid, begin, std::min(begin + 7, grid.rows), [&](int row, int first, int last) {
        for (int column = first; column < last; ++column) ++parts.at(column, row);
      });
    }
    REQUIRE(whole.of == parts.of);
  }
}

TEST_CASE("triangles side by side cover every sample once") {
  Random random(7);
  constexpr std::size_t kSide = 12;
  for (int n = 0; n < 100; ++n) {
    const SampleGrid grid = SampleGrid::of_picture(0, 0, 40, 40, n % 2 == 0 ? 1 : 4);
    // A net of points over the picture and beyond it, each moved a little.
    std::vector<std::int32_t> x(kSide * kSide), y(kSide * kSide);
    for (std::size_t i = 0; i < kSide * kSide; ++i) {
      const double step = 44.0 / (kSide - 1);
      const bool border =
          i % kSide == 0 || i % kSide == kSide - 1 || i / kSide == 0 || i / kSide == kSide - 1;
      const double shift = border ? 0.0 : 0.45 * step;
      x[i] = to_fixed(static_cast<double>(i % kSide) * step - 2.0 + random.uniform(-shift, shift));
      y[i] = to_fixed(static_cast<double>(i / kSide) * step - 2.0 + random.uniform(-shift, shift));
      if (n % 4 == 3 && !border) {  // onto samples
        x[i] = x[i] / kOne * kOne;
        y[i] = y[i] / kOne * kOne;
      }
    }
    Counts counts(grid);
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
      const FixedTriangle t{{x[a], x[b], x[c]}, {y[a], y[b], y[c]}};
      counts.add(t, t.doubled_area() > 0 ? 1 : -1);  // moved points may reverse a triangle
    };
    for (std::size_t row = 0; row + 1 < kSide; ++row) {
      for (std::size_t column = 0; column + 1 < kSide; ++column) {
        const std::size_t a = row * kSide + column, b = a + 1, c = b + kSide, d = a + kSide;
        if (random.below(2) == 0) {
          add(a, b, c);
          add(a, c, d);
        } else {
          add(a, b, d);
          add(b, c, d);
        }
      }
    }
    REQUIRE(std::all_of(counts.of.begin(), counts.of.end(), [](int count) { return count == 1; }));
  }
}

TEST_CASE("front faces of a closed surface cover each sample as often as back faces") {
  Random random(8);
  for (int n = 0; n < 200; ++n) {
    const SampleGrid grid = SampleGrid::of_picture(0, 0, 24, 24, 4);
    // An octahedron with random corners: closed, however it is crumpled.
    std::array<std::int32_t, 6> x, y;
    for (std::size_t i = 0; i < 6; ++i) {
      x[i] = static_cast<std::int32_t>(random.uniform(-4.0, 28.0) * kOne);
      y[i] = static_cast<std::int32_t>(random.uniform(-4.0, 28.0) * kOne);
    }
    Counts signed_counts(grid);
    for (std::size_t k = 0; k < 4; ++k) {
      for (const std::size_t pole : {std::size_t{4}, std::size_t{5}}) {
        const std::size_t a = pole == 4 ? k : (k + 1) % 4, b = pole == 4 ? (k + 1) % 4 : k;
        const FixedTriangle t{{x[a], x[b], x[pole]}, {y[a], y[b], y[pole]}};
        signed_counts.add(t, t.doubled_area() > 0 ? 1 : -1);
      }
    }
    REQUIRE(std::all_of(signed_counts.of.begin(), signed_counts.of.end(),
                        [](int count) { return count == 0; }));
  }
}

TEST_CASE("coordinates are rounded to the nearest 256th of a pixel and kept within the guard") {
  CHECK(to_fixed(1.0) == 256);
  CHECK(to_fixed(-0.5) == -128);
  CHECK(to_fixed(-1.0 / 1024) == 0);
  CHECK(to_fixed(-3.0 / 1024) == -1);
  CHECK(to_fixed(1e30) == to_fixed(kGuardHigh));
  CHECK(to_fixed(-1e30) == to_fixed(kGuardLow));
}
