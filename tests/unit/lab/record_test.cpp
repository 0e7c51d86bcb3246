#include "runs/record.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace armlet;
using namespace armlet::lab;

TEST_CASE("rows: long lists grow ever more slowly, and never lose what is to be kept") {
  Rows rows(1);
  constexpr std::size_t kAdded = 2'000'000;
  std::size_t seen = 0;
  bool grows = true;
  for (std::size_t i = 0; i < kAdded; ++i) {
    const double value = static_cast<double>(i);
    rows.add({&value, 1}, i % 100'000 == 77);
    grows = grows && rows.count() >= seen;
    seen = rows.count();
  }
  CHECK(grows);
  // 60,000, then as many for every doubling.
  CHECK(rows.count() <= Rows::kMost * 7);
  CHECK(rows.rows(Rows::kMost - 1, 1)[0] == doctest::Approx(Rows::kMost - 1));
  double before = -1.0;
  std::size_t kept = 0;
  for (const double each : rows.rows(0, rows.count())) {
    grows = grows && each > before;
    before = each;
    kept += std::fmod(each, 100'000.0) == 77.0 ? 1 : 0;
  }
  CHECK(grows);
  CHECK(kept == kAdded / 100'000);
}
