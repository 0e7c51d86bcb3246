// Formatter: a text that can be read means the same afterwards, and laying it out again changes
// nothing.

#include "armlet/interpreter/format.hpp"
#include "target.hpp"

using namespace armlet;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Formatted once = format_program(Source("fuzz.rbt", fuzz::text_of(data, size)));
  fuzz::demand(once.text.has_value() || !once.problems.empty(),
               "a text that is refused gets a message");
  if (!once.text) return 0;
  fuzz::demand(!once.changed_meaning, "the layout changes nothing else");
  const Formatted twice = format_program(Source("fuzz.rbt", *once.text));
  fuzz::demand(twice.text == once.text, "laying out twice changes nothing");
  return 0;
}
