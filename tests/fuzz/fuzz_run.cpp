// Machine and library: a program made of any text ends within its limits.

#include <algorithm>

#include "armlet/interpreter/render.hpp"
#include "target.hpp"

using namespace armlet;

namespace {

constexpr std::size_t kTests = 3;

void finish(const RunResult& result, const Session& session) {
  fuzz::demand((result.status == Progress::kDone) != result.error.has_value(),
               "what does not end well has a message, and only that");
  if (result.error) {
    fuzz::demand(!render_text(*result.error, session.sources()).empty(), "a message has a text");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  SessionOptions options = fuzz::small_session();
  const std::uint64_t most = options.limits.output_bytes;
  std::uint64_t written = 0;
  options.output = [&](std::string_view text) { written += text.size(); };
  Session session(library_engine(), std::move(options));
  if (!session.compile(fuzz::text_of(data, size), "fuzz.rbt")) return 0;
  finish(session.run(), session);
  fuzz::demand(written <= most, "the limit of output holds");
  const std::size_t tests = std::min(session.program()->test_names().size(), kTests);
  for (std::size_t i = 0; i < tests; ++i) finish(session.run_test(i), session);
  return 0;
}
