// Parser and checker: any text ends as a program or with messages.

#include "target.hpp"

using namespace armlet;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Session session(library_engine(), fuzz::small_session());
  const bool good = session.compile(fuzz::text_of(data, size), "fuzz.rbt");
  fuzz::demand(good == (session.program() != nullptr), "a good text has a program");
  fuzz::demand(good || !session.problems().empty(), "a text that is refused gets a message");
  fuzz::show_all(session);
  return 0;
}
