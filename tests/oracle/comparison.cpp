#include "comparison.hpp"

#include <exception>
#include <utility>
#include <vector>

#include "driver/pipeline.hpp"
#include "driver/vocabulary.hpp"
#include "evaluator.hpp"
#include "lower/lower.hpp"

namespace armlet::oracle {

namespace {

const std::string kGaveUp = "the oracle gave up: ";

// The checked program, compiled a second time. The first program cannot be used afterwards.
std::shared_ptr<const Program> compiled_again(const Program& first, lang::LowerOptions options) {
  auto& from = const_cast<Program::Code&>(first.compiled());
  lang::CheckedProgram to;
  to.sources = from.sources;
  to.arena = std::move(from.arena);
  to.types = std::move(from.types);
  to.facts = std::move(from.facts);
  to.constants = std::move(from.constants);
  to.module = from.module;
  to.names = std::move(from.names);
  to.what_takes_time = from.what_takes_time;
  to.messages = from.messages;
  to.language = from.language;
  lang::Lowered lowered = lang::lower(std::move(to), options);
  if (lowered.too_large) return nullptr;
  return std::make_shared<const Program>(std::move(lowered.program));
}

std::string ending(const SourceSet& sources, const std::string& code, const std::string& message,
                   Span where) {
  const Position at = where.empty() ? Position{0, 0} : sources.position(where);
  return code + " " + message + " at " + std::to_string(at.line) + ":" + std::to_string(at.column) +
         "\n";
}

// What else the machine says about a failure; optimising must not change that either.
std::string details(const Diagnostic& error) {
  std::string out =
      error.mark.label + "|" + error.why + "|" + (error.fix ? error.fix->text : "") + "|";
  if (!error.when) return out;
  out += error.when->note;
  for (const std::string& call : error.when->calls) out += "|" + call;
  return out;
}

std::string run_oracle(const std::shared_ptr<const Program>& program) {
  try {
    const Outcome outcome = Evaluator(program, nullptr, kLimits.call_depth).run();
    if (!outcome.failure) return outcome.output;
    const Failure& failure = *outcome.failure;
    return outcome.output +
           ending(program->sources(), failure.code, failure.message, failure.where);
  } catch (const std::exception& e) {
    return kGaveUp + e.what() + "\n";
  }
}

}  // namespace

std::string run_machine(const std::shared_ptr<const Program>& program, const RunLimits& limits,
                        std::string* more) {
  std::string out;
  VmOptions options;
  options.limits = limits;
  options.output = [&](std::string_view text) { out += text; };
  Vm vm(program, std::move(options));
  const RunResult result = vm.run();
  if (result.error) {
    out += ending(program->sources(), result.error->code, result.error->message,
                  result.error->mark.span);
    if (more != nullptr) *more += details(*result.error);
  }
  if (more != nullptr) *more += "|" + std::to_string(result.steps) + " steps";
  return out;
}

namespace {

// The output of the whole program. With few steps and calls it has to end at the same position too.
std::string run_twice(const std::shared_ptr<const Program>& program, std::uint64_t few,
                      std::string& more) {
  std::string out = run_machine(program, kLimits, &more);
  more += "\n" + run_machine(program, {.steps = few, .call_depth = 5}, &more);
  return out;
}

}  // namespace

std::string Report::text() const {
  if (!not_compiled.empty()) return "not compiled: " + not_compiled;
  std::string out = "---- oracle\n" + oracle;
  out += plain == oracle ? "" : "---- machine, not optimised\n" + plain;
  out += optimised == oracle ? "" : "---- machine, optimised\n" + optimised;
  if (plain_details == optimised_details) return out;
  return out + "---- not optimised: " + plain_details +
         "\n---- optimised:     " + optimised_details + "\n";
}

Report compare(const Engine& engine, const std::string& program) {
  Report report;
  const Compilation first =
      lang::compile_text(engine.registry(), program, "program.rbt", {}, {.optimise = false});
  if (first.program == nullptr) {
    for (const Diagnostic& d : first.diagnostics) {
      if (d.severity != Severity::kError) continue;
      if (d.code == "E0305") break;  // sizes that the text happens to show: both refuse them
      report.not_compiled =
          ending(*first.sources, d.code, d.message, d.mark.span) +
          std::string((*first.sources)[0].line(first.sources->position(d.mark.span).line)) + "\n";
      break;
    }
    return report;
  }
  report.oracle = run_oracle(first.program);
  const std::uint64_t few = 5 + program.size() % 40;
  report.plain = run_twice(first.program, few, report.plain_details);
  report.optimised =
      run_twice(compiled_again(*first.program, {.optimise = true}), few, report.optimised_details);
  return report;
}

// ---- reducing

namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

// The line that closes what line `at` opens; `at` itself if it opens nothing.
std::size_t closing_line(const std::vector<std::string>& lines, std::size_t at) {
  int open = 0;
  for (std::size_t i = at; i < lines.size(); ++i) {
    for (const char c : lines[i]) open += c == '{' ? 1 : c == '}' ? -1 : 0;
    if (open <= 0) return i;
  }
  return at;
}

std::vector<std::string> without(const std::vector<std::string>& lines, std::size_t first,
                                 std::size_t last) {
  std::vector<std::string> out(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(first));
  out.insert(out.end(), lines.begin() + static_cast<std::ptrdiff_t>(last) + 1, lines.end());
  return out;
}

// One line, or a block, or only the lines around a block, fewer.
bool shorten(const Engine& engine, std::vector<std::string>& lines) {
  const auto still_disagree = [&](const std::vector<std::string>& tried) {
    const Report report = compare(engine, joined(tried));
    // Without some line a loop may have no end.
    const bool has_end = !report.oracle.starts_with(kGaveUp);
    return report.not_compiled.empty() && has_end && !report.agrees();
  };
  for (std::size_t at = lines.size(); at-- > 0;) {
    const std::size_t last = closing_line(lines, at);
    std::vector<std::vector<std::string>> tries = {without(lines, at, last)};
    if (last > at) tries.push_back(without(without(lines, last, last), at, at));
    for (std::vector<std::string>& tried : tries) {
      if (!still_disagree(tried)) continue;
      lines = std::move(tried);
      return true;
    }
  }
  return false;
}

}  // namespace

std::string reduce(const Engine& engine, std::string program) {
  std::vector<std::string> lines = lines_of(program);
  while (shorten(engine, lines)) {
  }
  return joined(lines);
}

}  // namespace armlet::oracle
