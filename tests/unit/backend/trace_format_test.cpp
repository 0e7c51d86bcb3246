#include "armlet/backend/trace_format.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "run.hpp"

using namespace armlet;

TEST_CASE("every format has an ending of its own, says what it holds and writes a run") {
  std::set<std::string> written;
  for (const TraceFormat& format : trace_formats()) {
    CAPTURE(format.ending);
    CHECK(format.ending.starts_with('.'));
    CHECK_FALSE(format.holds.empty());
    CHECK(trace_endings().find(format.ending) != std::string::npos);
    CHECK(trace_format_of("run" + std::string(format.ending)) == &format);
    std::ostringstream out;
    const auto backend = format.make(out);
    play_short_run(*backend);
    CHECK(backend->error().empty());
    CHECK(written.insert(out.str()).second);
  }
}

TEST_CASE("a format that cannot write says so, once") {
  for (const TraceFormat& format : trace_formats()) {
    CAPTURE(format.ending);
    std::ofstream full("/dev/full");
    const auto backend = format.make(full);
    play_short_run(*backend);
    CHECK(backend->error() == "The trace could not be written; is the disk full?");
  }
}

TEST_CASE("the same run is written as the same bytes") {
  for (const TraceFormat& format : trace_formats()) {
    CAPTURE(format.ending);
    std::ostringstream first, second;
    play_short_run(*format.make(first));
    play_short_run(*format.make(second));
    CHECK(first.str() == second.str());
  }
}

TEST_CASE("a name with another ending has no format") {
  for (const char* name : {"", "csv", "run", "run.csv.txt", "run.CSV", "run.json"})
    CHECK(trace_format_of(name) == nullptr);
}
