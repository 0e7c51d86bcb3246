// A program entered piece by piece prints what it prints as one text.

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "library.hpp"
#include "random/program.hpp"

using namespace armlet;
using armlet::oracle::RandomProgram;

namespace {

struct Shown {
  std::string printed;
  std::string error;
  bool operator==(const Shown&) const = default;
};

constexpr RunLimits kLimits{.steps = 20'000, .call_depth = 60};

Shown whole(const std::string& text) {
  Shown shown;
  const Compilation made = library_engine().compile(text, "program");
  REQUIRE(made.program != nullptr);
  VmOptions options;
  options.limits = kLimits;
  options.output = [&](std::string_view part) {
    shown.printed += part;
    return std::string();
  };
  const RunResult result = Vm(made.program, options).run();
  if (result.error) shown.error = result.error->code;
  return shown;
}

// Where the prompt would take entries.
std::vector<std::string> pieces_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  std::vector<std::string> pieces;
  std::string piece;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    piece += lines[i] + '\n';
    const bool is_last = i + 1 == lines.size();
    if (is_complete(piece, is_last ? "" : lines[i + 1]) || is_last)
      pieces.push_back(std::exchange(piece, {}));
  }
  return pieces;
}

struct Entered {
  Shown shown;
  int entries = 0;
};

// A piece that names what is declared further down is entered together with that.
Entered entered(const std::string& text) {
  Entered out;
  VmOptions options;
  options.limits = kLimits;
  options.output = [&](std::string_view part) {
    out.shown.printed += part;
    return std::string();
  };
  std::unique_ptr<Vm> vm;
  CompileOptions how{.is_entry = true};
  std::string entry;
  std::string above;  // so that lines have the same numbers
  for (const std::string& piece : pieces_of(text)) {
    entry += piece;
    const Compilation made = library_engine().compile(above + entry, "entry", how);
    if (made.program == nullptr) continue;
    above.append(static_cast<std::size_t>(std::ranges::count(entry, '\n')), '\n');
    entry.clear();
    ++out.entries;
    how.after = made.program;
    if (vm == nullptr) {
      vm = std::make_unique<Vm>(made.program, options);
    } else {
      vm->begin(made.program);
    }
    const RunResult result = vm->run();
    if (!result.error) continue;
    out.shown.error = result.error->code;
    return out;
  }
  CHECK(entry.empty());
  return out;
}

// What is watched runs at the end of an entry, and the time of a whole text does not stand still.
bool watches(const std::string& text) {
  return text.find("when (") != std::string::npos || text.find("every (") != std::string::npos;
}

}  // namespace

TEST_CASE("a program entered piece by piece prints what it prints as one text") {
  int compared = 0;
  int entries = 0;
  int failed = 0;
  for (std::uint64_t number = 1; number <= 600; ++number) {
    const std::string text = RandomProgram(number).text();
    if (watches(text)) continue;
    const Shown expected = whole(text);
    const Entered found = entered(text);
    CAPTURE(text);
    REQUIRE(found.shown.error == expected.error);
    REQUIRE(found.shown.printed == expected.printed);
    ++compared;
    entries += found.entries;
    failed += expected.error.empty() ? 0 : 1;
  }
  MESSAGE(compared << " programs in " << entries << " entries, " << failed << " of them failing");
  CHECK(compared > 200);
  CHECK(entries > 3 * compared);
}
