#include "vm/failures/failures.hpp"

#include <cxxabi.h>

#include <algorithm>
#include <exception>
#include <new>

#include "armlet/core/checkpoint.hpp"
#include "armlet/interpreter/messages/catalog.hpp"
#include "program/properties.hpp"
#include "vm/failures/counted.hpp"
#include "vm/failures/leaving.hpp"
#include "vm/heap/format_value.hpp"
#include "vm/state/interpret.hpp"

namespace armlet::lang {
namespace {

// The text of the running instruction in backquotes, or `otherwise` if it is long.
std::string running_text(const VmState& state, const char* otherwise) {
  constexpr std::size_t kLong = 40;
  const CodeSpan* at = code_span(state);
  const std::string text = at == nullptr ? "" : source_text(state, at->span);
  if (text.empty() || text.size() > kLong || text.find('\n') != std::string::npos) return otherwise;
  return "`" + text + "`";
}

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  for (std::size_t end = 0; end != std::string_view::npos;
       text.remove_prefix(std::min(end + 1, text.size()))) {
    end = text.find('\n');
    lines.emplace_back(text.substr(0, end));
  }
  return lines;
}

void set_fault(VmState& state, Diagnostic diagnostic, std::string kind, Reach reach) {
  state.fault = std::make_shared<Fault>();
  state.fault->diagnostic = std::move(diagnostic);
  state.fault->kind = std::move(kind);
  state.fault->reach = reach;
  // A failure in deeply nested calls takes long, so stop requests are checked at the next step.
  state.steps.book(state.is_leaving ? kFailureStepsLeaving : 0);
}

// From here on only finally blocks run, with a limit of steps for all of them together, also if
// they are in several tasks.
void begin_leaving(VmState& state) {
  state.fault->reach = state.is_leaving ? Reach::kNothing : Reach::kFinally;
  state.fault->is_leaving = true;
  if (state.is_leaving) return;
  state.is_leaving = true;
  state.steps.settle();
  state.steps.since_pause = 0;
  state.steps.limit = std::min(state.steps.limit, kLeavingSteps);
}

}  // namespace

// ---- where ----------------------------------------------------------------------------------

const Frame* innermost(const Task& task) {
  const Frame* frame = task.stack.top;
  while (frame > task.stack.frames && frame->is_host()) --frame;
  return frame->is_host() ? nullptr : frame;
}
const Frame* innermost(const VmState& state) {
  return state.running == nullptr ? nullptr : innermost(*state.running);
}

const CodeSpan* code_span(const Frame& frame) {
  const std::vector<CodeSpan>& spans = frame.callee->function->spans;
  const auto after = std::ranges::upper_bound(spans, frame.at(), {}, &CodeSpan::pc);
  return after == spans.begin() ? nullptr : &*(after - 1);
}

const CodeSpan* code_span(const VmState& state) {
  const Frame* frame = innermost(state);
  return frame == nullptr ? nullptr : code_span(*frame);
}

std::string source_text(const VmState& state, Span span) {
  return span.empty() ? std::string() : std::string(state.programs.newest->sources->slice(span));
}

std::string line_name(const VmState& state, Span span) {
  const CompiledProgram& program = *state.programs.newest;
  const SourceSet& sources = *program.sources;
  std::string out = "line " + std::to_string(line_of(state, span));
  const bool is_of_entry = program.entry.is_one && span.source == sources.first();
  if (sources.size() == 1 || is_of_entry) return out;
  const std::string& file = sources[span.source].name();
  return out + " of " + file.substr(file.find_last_of('/') + 1);
}

std::string task_name(const Task& task) {
  return task.origin.function == nullptr ? std::string() : std::string(task.origin.function->name);
}

int task_line(const VmState& state, const Task& task) {
  const Frame* frame = innermost(task);
  const CodeSpan* at = frame == nullptr ? nullptr : code_span(*frame);
  return at == nullptr ? 0 : line_of(state, at->span);
}

// ---- raising --------------------------------------------------------------------------------

Diagnostic start_failure(const VmState& state, const Headline& headline) {
  const CodeSpan* at = code_span(state);
  return make_diagnostic(headline, at == nullptr ? Span{} : at->span);
}

bool raise(VmState& state, Diagnostic diagnostic) {
  if (!diagnostic.when) diagnostic.when = circumstances(state);
  std::string kind(messages_of(state).kind_of(diagnostic.code));
  set_fault(state, std::move(diagnostic), std::move(kind), Reach::kHandlers);
  return false;
}

bool raise(VmState& state, const Failure& failure) {
  raise(state, diagnostic_of(state, failure));
  if (!failure.kind.empty()) state.fault->kind = failure.kind;
  state.fault->detail = failure.detail;
  return false;
}

namespace {

// The name of the native function that the task calls, in backquotes: "`grasp`".
std::string native_name(const Task& task) {
  const Frame* frame = innermost(task);
  if (frame == nullptr || frame->pc == frame->callee->code) return "a function of the host";
  const Instr& call = frame->pc[-1];
  const std::uint16_t operands[] = {call.a, call.b, call.c};
  for (std::size_t i = 0; i < 3; ++i) {
    if (operand_of(call.op, i) == 'n')
      return '`' + std::string(frame->callee->program->natives[operands[i]]->name) + '`';
  }
  return "a function of the host";
}

// The text of the current exception; empty if a kernel threw it because of a stop, since the
// failure is then set already.
std::string thrown_words() {
  try {
    throw;
  } catch (const Stopped&) {
    return {};
#ifdef __GLIBCXX__  // the thread is being ended
  } catch (const abi::__forced_unwind&) {
    throw;
#endif
  } catch (const std::bad_alloc&) {
    return "there is not enough memory";
  } catch (const std::exception& error) {
    const std::string words = error.what();
    return words.empty() ? "it says nothing" : words;
  } catch (...) {
    return "it threw what is no std::exception";
  }
}

}  // namespace

void raise_thrown(VmState& state, Task& task) {
  const std::string words = thrown_words();
  state.pending.reset();
  state.running = &task;
  if (!words.empty() || state.fault == nullptr)
    raise(state, "R0626", {native_name(task) + " failed: " + words});
}

bool require_failure(VmState& state) {
  if (state.fault != nullptr) return false;
  return raise(state, "R0626", {native_name(*state.running) + " failed and did not say why"});
}

// "1024 MB", "100 bytes".
static std::string bytes_text(std::uint64_t bytes) {
  constexpr std::uint64_t kMega = 1024 * 1024;
  return bytes >= kMega ? std::to_string(bytes / kMega) + " MB" : std::to_string(bytes) + " bytes";
}

bool raise_out_of_memory(VmState& state) {
  const Heap& heap = state.heap;
  if (!heap.was_refused())
    return raise(state, "R0628", {bytes_text(state.options.limits.heap_bytes)});
  Diagnostic failure = start_failure(state, "R0628", {bytes_text(heap.reserved())});
  failure.why = "the host gives no more; the limit of this program is " +
                bytes_text(state.options.limits.heap_bytes);
  return raise(state, std::move(failure));
}

bool raise_out_of_output(VmState& state) {
  Diagnostic failure = start_failure(
      state, "R0626",
      {"the program printed more than " + bytes_text(state.options.limits.output_bytes)});
  failure.why = "this is the limit for the output of a program here";
  failure.fix = Fix{"print less, for example not in every pass of a loop", {}, Confidence::kMaybe};
  return raise(state, std::move(failure));
}

bool raise_out_of_steps(VmState& state) {
  if (state.host.has_asked_to_stop) return raise_cancelled(state);
  raise(state, "R0622", {std::to_string(state.steps.limit)});
  begin_leaving(state);
  return false;
}

bool raise_cancelled(VmState& state) {
  raise(state, "R0629");
  begin_leaving(state);
  state.fault->cancelled = state.host.has_asked_to_stop = true;
  return false;
}

bool raise_overflow(VmState& state) {
  return raise(state, "R0610", {running_text(state, "this calculation")});
}

bool raise_division_by_zero(VmState& state) {
  return raise(state, "R0611", {running_text(state, "this")});
}

bool raise_endless_range(VmState& state) {
  Diagnostic failure = start_failure(state, "R0609", {"", "", ""});
  failure.message = "range with a step of 0 never ends";
  return raise(state, std::move(failure));
}

namespace {

bool is_axis(std::string_view what) { return what == "row" || what == "column"; }

// The size of an object as a sentence: "the list has 4 values", "the text is empty", "the matrix
// has 1 row".
std::string size_note(std::string_view what, std::uint64_t size) {
  const std::string name = is_axis(what) ? "matrix" : std::string(what);
  if (size == 0 && !is_axis(what)) return "the " + name + " is empty";
  const std::string unit = what == "text"  ? "character"
                           : is_axis(what) ? std::string(what)
                                           : "value";
  return "the " + name + " has " + std::to_string(size) + ' ' + unit + (size == 1 ? "" : "s");
}

Diagnostic index_failure(const VmState& state, std::int64_t index, std::uint64_t last,
                         std::string_view what) {
  Diagnostic failure =
      start_failure(state, "R0606", {std::to_string(index), "0 to " + std::to_string(last)});
  failure.message.replace(0, 4, what);
  return failure;
}

// The text of the index expression, if it is not just the number.
std::string computed_index(const VmState& state, std::int64_t index, std::string_view what,
                           bool& is_variable) {
  const CodeSpan* at = code_span(state);
  const hir::Expr* written = nullptr;
  if (at != nullptr && at->expr != nullptr) {
    if (at->expr->kind == hir::ExprKind::kElement) {
      const auto& element = at->expr->as<hir::ElementExpr>();
      written = what == "column" ? element.column : element.index;
    }
    if (at->expr->kind == hir::ExprKind::kCharacter)
      written = at->expr->as<hir::CharacterExpr>().index;
  }
  if (written == nullptr) return {};
  is_variable = is_counted(*state.programs.newest->sources, *written);
  const std::string text = source_text(state, written->span);
  return text == std::to_string(index) ? std::string() : text;
}

}  // namespace

// Raises the failure of an index outside of a list. The message has the range of valid indices, or
// says that there are none.
bool raise_index(VmState& state, std::int64_t index, std::uint64_t size, std::string_view what) {
  const std::string last = std::to_string(size - 1);
  const std::string name(what);
  Diagnostic failure = index_failure(state, index, size - 1, what);
  if (size == 0) {
    failure.message =
        is_axis(what) ? "there is no " + name + ' ' + std::to_string(index) + " in this matrix"
        : index == -1 ? "an empty " + name + " has no last value"
                      : "there is no value " + std::to_string(index) + " in an empty " + name;
  }
  const std::string has = size_note(what, size);
  if (index < 0 && size > 0 && what == "list")
    failure.why = "indexes count from 0; the last value of a list is xs.last";
  bool is_variable = false;
  const std::string written = computed_index(state, index, what, is_variable);
  if (written.empty()) {
    if (size != 0 || is_axis(what)) failure.mark.label = has;
    return raise(state, std::move(failure));
  }
  // xs.last of an empty list is compiled as the index -1, which is not in the text.
  const bool is_last = size == 0 && index == -1 && written.ends_with(".last");
  failure.mark.label = is_last ? has : written + " is " + std::to_string(index) + ", " + has;
  if (is_variable && index == static_cast<std::int64_t>(size) && size > 0) {
    const std::string loop = ": for (" + written + " in range(" + std::to_string(size) + "))";
    const std::string where = is_axis(what) ? "the last " + name + " has index " + last
                                            : "the last index of a " + name + " of " +
                                                  std::to_string(size) + " is " + last;
    failure.fix = Fix{where + loop, {}, Confidence::kMaybe};
  }
  return raise(state, std::move(failure));
}

bool raise_end(VmState& state, std::int64_t end, std::uint64_t most, std::uint64_t size,
               std::string_view what) {
  Diagnostic failure = index_failure(state, end, most, what);
  failure.mark.label = size_note(what, size);
  return raise(state, std::move(failure));
}

bool raise_backwards(VmState& state, std::int64_t first, std::int64_t last) {
  Diagnostic failure = start_failure(state, "R0606", {"", ""});
  failure.message = "a part that starts at " + std::to_string(first) + " cannot end before " +
                    std::to_string(last);
  return raise(state, std::move(failure));
}

bool raise_too_deep(VmState& state, const Callee& called, std::uint32_t limit) {
  const std::string& name = called.function->name;
  return raise(state, "R0624", {std::to_string(limit), name.empty() ? "the program" : name});
}

bool raise_expectation(VmState& state, const hir::AssertThrowsStmt& statement,
                       const RecordObj* thrown, const TextObj* kind) {
  const std::string call = source_text(state, statement.call_span);
  if (thrown == nullptr) {
    Diagnostic failure = make_diagnostic("R0608", statement.call_span, {call + " throws"});
    failure.mark.label = "nothing was thrown";
    return raise(state, std::move(failure));
  }
  const auto field = [&](const char* name) {
    const int index = state.records.error->type->record->index_of(name);
    return static_cast<const TextObj*>(thrown->fields()[index].o)->view();
  };
  if (kind == nullptr || kind->view() == field("kind")) return true;
  Diagnostic failure = make_diagnostic(
      "R0608", statement.call_span, {call + " throws kind \"" + std::string(kind->view()) + "\""});
  failure.mark.label = "the kind is \"" + std::string(field("kind")) + "\"";
  failure.why = field("message");
  return raise(state, std::move(failure));
}

// The first line of an explanation is the reason; the others, if there are any, show the values
// more clearly than print does.
bool raise_assertion(VmState& state, const AssertInfo& info, const TextObj* note,
                     const TextObj* explanation, const Slot* base) {
  const hir::AssertStmt& statement = *info.statement;
  Diagnostic failure =
      make_diagnostic("R0608", statement.condition_span, {std::string(statement.text)});
  std::vector<std::string> lines;
  if (explanation != nullptr) lines = lines_of(explanation->view());
  if (!lines.empty()) failure.mark.label = lines[0];
  if (note != nullptr) failure.why = note->view();
  std::size_t widest = 0;
  for (const hir::AssertPart& part : statement.shown) widest = std::max(widest, part.text.size());
  for (std::size_t i = 0; i < statement.shown.size(); ++i) {
    const hir::AssertPart& part = statement.shown[i];
    if (!failure.why.empty()) failure.why += '\n';
    failure.why += part.text;
    failure.why.append(widest - part.text.size(), ' ');
    failure.why += " = ";
    failure.why += i + 1 < lines.size()
                       ? lines[i + 1]
                       : value_text(base[info.registers[i]], *part.variable->type, 1000);
  }
  return raise(state, std::move(failure));
}

// ---- handling -------------------------------------------------------------------------------

void leave_frame(VmState& state, Task& task) {
  const Frame& frame = *task.stack.top;
  const Slot* references = frame.base + frame.callee->references_begin;
  for (unsigned i = 0; i < frame.callee->references; ++i) state.heap.release(references[i].o);
  --task.stack.top;
}

// The cancellation that the innermost finally block around the running instruction will raise at
// its end, if the code of the block begins after `begin`; null if there is none. An error in a
// finally block does not end a cancellation.
static const FaultPtr* cancellation_behind(const Frame& frame, std::uint32_t begin) {
  const FinallyCode* inner = nullptr;
  for (const FinallyCode& code : frame.callee->function->finals) {
    const bool covers = code.begin <= frame.at() && frame.at() < code.end && code.begin > begin;
    if (covers && (inner == nullptr || code.begin > inner->begin)) inner = &code;
  }
  if (inner == nullptr || frame.base[inner->held].o == nullptr) return nullptr;
  const FaultPtr& held = held_fault(frame.base[inner->held].o);
  return held != nullptr && held->reach != Reach::kHandlers ? &held : nullptr;
}

// The handler in this frame; null if there is none. A cancellation may replace state.fault.
static const Handler* handler_in(VmState& state, const Frame& frame) {
  const auto cancel = [&](std::uint32_t begin) {
    if (state.fault->reach != Reach::kHandlers) return false;
    const FaultPtr* held = cancellation_behind(frame, begin);
    if (held == nullptr) return false;
    state.fault = *held;
    return true;
  };
  const std::vector<Handler>& handlers = frame.callee->function->handlers;
  for (std::size_t i = 0; i < handlers.size(); ++i) {
    const Handler& handler = handlers[i];
    const bool covers = handler.begin <= frame.at() && frame.at() < handler.end;
    if (!covers) continue;
    (void)cancel(handler.begin);
    if (handler.is_finally || state.fault->reach == Reach::kHandlers) return &handler;
  }
  (void)cancel(0);
  return nullptr;
}

bool unwind(VmState& state, Task& task) {
  for (; !task.stack.top->is_host(); leave_frame(state, task)) {
    Frame& frame = *task.stack.top;
    if (state.fault->reach == Reach::kNothing) continue;
    if (const Handler* handler = handler_in(state, frame)) {
      frame.pc = frame.callee->code + handler->handler;
      return true;
    }
  }
  if (task.stack.top > task.stack.frames) --task.stack.top;
  return false;
}

}  // namespace armlet::lang
