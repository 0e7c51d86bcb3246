// Compiler and machine: programs that the bytes generate pass the checker and end within their
// limits.

#include <cstdio>

#include "armlet/interpreter/render.hpp"
#include "random/program.hpp"
#include "target.hpp"

using namespace armlet;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::size_t at = 0;
  oracle::RandomProgram program([&]() -> std::uint64_t { return at < size ? data[at++] : 0U; });
  Session session(library_engine(), fuzz::small_session());
  const bool good = session.compile(program.text(), "fuzz.rbt");
  fuzz::show_all(session);
  if (!good) {
    std::fprintf(stderr, "%s\n", program.text().c_str());
    for (const Problem& problem : session.problems())
      std::fprintf(stderr, "%s\n", render_text(problem.diagnostic, *problem.sources).c_str());
  }
  fuzz::demand(good, "a generated program passes the checker");
  const RunResult result = session.run();
  fuzz::demand(result.status != Progress::kCancelled,
               "a program that does not wait is not stopped");
  return 0;
}
