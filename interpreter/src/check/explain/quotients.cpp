#include "check/explain/quotients.hpp"

#include "check/explain/edits.hpp"

namespace armlet::lang {

void advise_whole_quotient(Checker& checker, Span whole, Span left, Span right,
                           const std::string& value) {
  if (!checker.messages.takes_advice()) return;
  Diagnostic advice = make_diagnostic("W0701", whole, {checker.text_of(whole), value});
  const std::string above = checker.text_of(left);
  const bool is_whole = is_decimal_number(above) && above.find_first_of(".eE") == std::string::npos;
  const std::string written = (is_whole ? above + ".0" : "double(" + above + ')') + " / " +
                              as_operand(checker.text_of(right));
  advice.fix = Fix{.text = "write " + written, .edits = {{whole, written}}};
  checker.report(std::move(advice));
}

}  // namespace armlet::lang
