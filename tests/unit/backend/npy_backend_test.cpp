#include "armlet/backend/npy_backend.hpp"

#include <doctest/doctest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <sstream>

#include "armlet/core/random.hpp"
#include "run.hpp"

using namespace armlet;

namespace {

// A file as the NumPy Reference describes version 1.0 (numpy.lib.format): 6 magic bytes, 2 of the
// version, the length of the header text in 2 bytes, that text, which ends with a line end, and the
// rows.
struct NpyFile {
  std::string header;
  std::string rows;
};

NpyFile read_npy(const std::string& bytes) {
  REQUIRE(bytes.size() > 10);
  CHECK(bytes.substr(0, 8) == std::string("\x93NUMPY\x01\x00", 8));
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  const std::size_t length = byte(8) + 256U * byte(9);
  CHECK((10 + length) % 64 == 0);
  REQUIRE(bytes.size() >= 10 + length);
  CHECK(bytes[10 + length - 1] == '\n');
  return {bytes.substr(10, length), bytes.substr(10 + length)};
}

// The header without the blanks that fill it up.
std::string literal(const NpyFile& file) {
  return file.header.substr(0, file.header.find_last_not_of(" \n") + 1);
}

double number_at(const NpyFile& file, std::size_t index) {
  std::uint64_t bits = 0;
  for (std::size_t i = 8; i-- > 0;)
    bits = bits << 8 | static_cast<unsigned char>(file.rows.at(8 * index + i));
  return std::bit_cast<double>(bits);
}

}  // namespace

TEST_CASE("a run is an array with a row for every sample of a robot") {
  std::ostringstream out;
  const std::unique_ptr<Backend> backend = make_npy_backend(out);
  play_short_run(*backend);
  CHECK(backend->error().empty());
  const NpyFile file = read_npy(out.str());
  CHECK(literal(file) ==
        "{'descr': [('t', '<f8'), ('robot', '<i8'), ('p', '<f8', (3,)), ('r', '<f8', (4,)), "
        "('q', '<f8', (2,)), ('qd', '<f8', (2,)), ('qdd', '<f8', (2,))], 'fortran_order': False, "
        "'shape': (1,), }");
  REQUIRE(file.rows.size() == 8 * 15);
  const std::array expected{0.01, 0.0, 1.0,  2.0,       3.0, 1.0,    0.0, 0.0,
                            0.0,  0.1, -0.0, 1.0 / 3.0, 2.5, -1e-20, 4.0};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    CAPTURE(i);
    CHECK(std::bit_cast<std::uint64_t>(number_at(file, i)) ==
          std::bit_cast<std::uint64_t>(expected[i]));
  }
}

TEST_CASE("the header keeps its length whatever the number of rows; the rows hold the run's bits") {
  Random random(1);
  std::size_t length = 0;
  for (const int rows : {0, 1, 9, 10, 12345}) {
    CAPTURE(rows);
    std::ostringstream out;
    const std::unique_ptr<Backend> backend = make_npy_backend(out);
    backend->on(BeginRun{.run = {.robots = {{"arm", {{JointUnit::kRadian}}}}, .objects = {}}});
    std::vector<double> told;
    for (int k = 0; k < rows; ++k) {
      const std::array q{random.uniform(-9, 9)}, qd{random.uniform(-9, 9)},
          qdd{random.uniform(-9, 9)};
      for (const auto& values : {q, qd, qdd}) told.push_back(values[0]);
      backend->on(JointSample{.t_ns = k * 10'000'000LL, .q = q, .qd = qd, .qdd = qdd});
    }
    backend->on(EndRun{});
    const NpyFile file = read_npy(out.str());
    if (length == 0) length = file.header.size();
    CHECK(file.header.size() == length);
    CHECK(literal(file).ends_with("'shape': (" + std::to_string(rows) + ",), }"));
    REQUIRE(file.rows.size() == 8U * 12 * static_cast<std::size_t>(rows));
    bool same = true;
    for (std::size_t k = 0; k < told.size(); ++k)
      same = same && number_at(file, k / 3 * 12 + 9 + k % 3) == told[k];
    CHECK(same);
  }
}

TEST_CASE("a robot with fewer joints leaves its last numbers NaN; one with more is an error") {
  std::ostringstream out;
  const std::unique_ptr<Backend> backend = make_npy_backend(out);
  backend->on(BeginRun{.run = {.robots = {{"arm", {{JointUnit::kRadian}, {JointUnit::kMetre}}},
                                          {"left", {{JointUnit::kRadian}}}},
                               .objects = {}}});
  const std::array q{1.0, 2.0, 3.0};
  const std::span<const double> one(q.data(), 1);
  backend->on(JointSample{.robot = 1, .q = one, .qd = one, .qdd = one});
  backend->on(RobotAdded{.t_ns = 5, .robot = {"wide", std::vector<JointInfo>(3)}});
  backend->on(JointSample{.t_ns = 5, .robot = 2, .q = q, .qd = q, .qdd = q});
  backend->on(EndRun{.t_ns = 5});
  const NpyFile file = read_npy(out.str());
  REQUIRE(file.rows.size() == 8 * 15);
  CHECK(number_at(file, 9) == 1.0);
  CHECK(std::isnan(number_at(file, 10)));
  CHECK(backend->error() ==
        "The table was begun for robots of 2 joints; \"wide\" has 3. Declare it before the first "
        "motion.");
}
