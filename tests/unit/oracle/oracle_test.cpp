// The machine and the oracle do the same.

#include <doctest/doctest.h>

#include <cstdint>
#include <cstdlib>
#include <string>

#include "comparison.hpp"
#include "library.hpp"
#include "random/program.hpp"

using namespace armlet;
using namespace armlet::oracle;

namespace {

// ARMLET_ORACLE=first,last compares other programs than the usual ones.
std::uint64_t number_from(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

}  // namespace

TEST_CASE("10,000 random programs print and fail alike in the oracle and on the machine") {
  const std::uint64_t first = number_from("ARMLET_FIRST", 1);
  const std::uint64_t last = number_from("ARMLET_LAST", 10'000);
  int wrong = 0;
  for (std::uint64_t number = first; number <= last && wrong < 5; ++number) {
    const std::string program = RandomProgram(number).text();
    if (std::getenv("ARMLET_PRINT")) {
      std::puts(program.c_str());
      continue;
    }
    const Report report = compare(library_engine(), program);
    if (report.agrees()) continue;
    if (!report.not_compiled.empty() && std::getenv("ARMLET_SHORT")) {
      MESSAGE(number << " " << report.not_compiled);
      continue;
    }
    ++wrong;
    const std::string reduced =
        report.not_compiled.empty() ? reduce(library_engine(), program) : program;
    FAIL_CHECK("program " << number << "\n"
                          << reduced << compare(library_engine(), reduced).text());
  }
}
