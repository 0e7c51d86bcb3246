// Logs of sessions as files: docs/logs.md.

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <span>
#include <utility>

#include "armlet/backend/event.hpp"
#include "armlet/core/hash.hpp"
#include "armlet/stdlib/session_log.hpp"
#include "host/log_values.hpp"

namespace armlet {
namespace {

constexpr std::string_view kMagic = "armlet-log";
constexpr int kFormat = 2;
constexpr std::size_t kSumSize = 24;  // "sum 16\n", 16 digits, "\n"

std::string header() { return fmt::format("{} {} {}\n", kMagic, kFormat, ARMLET_VERSION); }

std::string sum_of(std::string_view bytes) {
  Fnv1a hash;
  hash.add_bytes(bytes);
  return fmt::format("sum 16\n{:016x}\n", hash.value());
}

// ---- writing

// A record: its kind and the sizes of its fields in a line, then the fields.
void append_record(std::string& out, std::string_view kind,
                   std::initializer_list<std::string> fields) {
  out += kind;
  for (const std::string& field : fields) out += fmt::format(" {}", field.size());
  out += '\n';
  for (const std::string& field : fields) out += field;
  out += '\n';
}

std::string text_of(const Value& value) {
  std::string out;
  log::append_value(out, value);
  return out;
}

void append_input(std::string& out, const Input& input) {
  const std::string t = std::to_string(input.at.t_ns);
  const std::string steps = std::to_string(input.at.steps);
  std::visit(
      Overload{[&](const SetSignal& each) {
                 const bool* on = std::get_if<bool>(&each.value);
                 const Value value = on != nullptr ? Value(*on) : Value(std::get<1>(each.value));
                 append_record(out, "signal", {t, steps, each.name, text_of(value)});
               },
               [&](const SetGlobal& each) {
                 append_record(out, "set", {t, steps, each.name, text_of(each.value)});
               },
               [&](const CallFunction& each) {
                 const Value arguments(Value::List(each.arguments));
                 append_record(out, "call", {t, steps, each.name, text_of(arguments)});
               },
               [&](const PressButton& each) {
                 append_record(out, "press", {t, steps, each.name});
               },
               [&](const MoveJoints& each) {
                 append_record(out, "joints", {t, steps, each.robot, text_of(Value(each.q))});
               }},
      input.what);
}

void append_entry(std::string& out, const LoggedEntry& entry) {
  if (entry.kind == EntryKind::kCall) {
    append_record(out, "run", {entry.name, text_of(Value(Value::List(entry.arguments)))});
  } else {
    append_record(out, entry.kind == EntryKind::kProgram ? "program" : "entry",
                  {entry.name, entry.text});
  }
  for (const LoggedImport& each : entry.imports) {
    if (each.given.text)
      append_record(out, "import", {each.path, each.from, each.given.name, *each.given.text});
  }
  for (const Input& each : entry.inputs) append_input(out, each);
  for (const Reply& each : entry.replies) {
    if (each.error) {
      append_record(out, "refusal", {each.question, each.error->code, each.error->message});
    } else {
      append_record(out, "reply", {each.question, each.text});
    }
  }
  for (const Cancellation& each : entry.cancelled)
    append_record(out, "cancel",
                  {std::to_string(each.at.t_ns), std::to_string(each.at.steps),
                   std::to_string(each.refusals)});
  for (const std::int64_t each : entry.stopped_ns)
    append_record(out, "stop", {std::to_string(each)});
  append_record(out, "end", {std::to_string(entry.end.t_ns), std::to_string(entry.end.steps)});
}

std::string write(const SessionLog& log) {
  std::string out = header();
  append_record(out, "robot", {log.robot});
  for (const std::string& each : log.planners) append_record(out, "planner", {each});
  for (const std::string& each : log.frames) append_record(out, "frames", {each});
  if (log.world) append_record(out, "world", {log.world->name, log.world->text});
  if (log.default_world)
    append_record(out, "default-world", {log.default_world->name, log.default_world->text});
  const RunLimits& limits = log.limits;
  append_record(out, "limits",
                {std::to_string(limits.steps), std::to_string(limits.heap_bytes),
                 std::to_string(limits.call_depth), std::to_string(limits.output_bytes),
                 std::to_string(limits.time_ns)});
  append_record(out, "open", {log.open ? "yes" : "no"});
  if (log.laboratory) append_record(out, "laboratory", {"yes"});
  for (const LoggedEntry& each : log.entries) append_entry(out, each);
  for (const RunMark& each : log.marks)
    append_record(out, "mark", {std::to_string(each.t_ns), fmt::format("{:016x}", each.hash)});
  return out + sum_of(out);
}

// ---- reading

class Reader {
 public:
  explicit Reader(std::string_view bytes) : all_(bytes), rest_(bytes) {}

  SessionLog read() {
    rest_.remove_prefix(header().size());
    rest_.remove_suffix(kSumSize);
    while (!rest_.empty()) read_record();
    if (log_.entries.empty() || !has_limits_) refuse("a log with limits and an entry");
    return std::move(log_);
  }

 private:
  using Fields = std::span<const std::string_view>;
  struct Kind {
    std::string_view name;
    std::size_t fields;
    void (Reader::*take)(Fields);
  };

  [[noreturn]] void refuse(std::string_view expected) const {
    throw ArgumentError(fmt::format("byte {} of the log is not as it was written: expected {}",
                                    all_.size() - kSumSize - rest_.size(), expected));
  }

  void read_record() {
    const std::size_t line_end = rest_.find('\n');
    if (line_end == std::string_view::npos) refuse("a record");
    std::string_view line = rest_.substr(0, line_end);
    const std::string_view name = line.substr(0, line.find(' '));
    const auto kind = std::ranges::find(kKinds, name, &Kind::name);
    if (kind == std::end(kKinds)) refuse("a known kind of record");
    line.remove_prefix(name.size());
    std::vector<std::size_t> sizes;
    while (!line.empty() && sizes.size() < kind->fields) {
      line.remove_prefix(1);
      const std::string_view digits = line.substr(0, line.find(' '));
      sizes.push_back(number<std::size_t>(digits));
      line.remove_prefix(digits.size());
    }
    if (!line.empty() || sizes.size() != kind->fields) refuse("the sizes of the fields");
    std::string_view body = rest_.substr(line_end + 1);
    std::vector<std::string_view> fields;
    for (const std::size_t size : sizes) {
      if (size > body.size()) refuse("fields that end before the log");
      fields.push_back(body.substr(0, size));
      body.remove_prefix(size);
    }
    if (!body.starts_with('\n')) refuse("the end of the record");
    (this->*kind->take)(fields);
    rest_ = body.substr(1);
  }

  template <class T>
  T number(std::string_view digits, int base = 10) const {
    T out{};
    const auto [stop, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), out, base);
    if (error != std::errc() || stop != digits.data() + digits.size() || digits.empty())
      refuse("a number");
    return out;
  }
  [[nodiscard]] std::int64_t time(std::string_view digits) const {
    const auto t_ns = number<std::int64_t>(digits);
    if (t_ns < 0 || t_ns > kEndOfTime_ns) refuse("a time from 0 to 100 years");
    return t_ns;
  }
  [[nodiscard]] Instant place(Fields fields) const {
    return {time(fields[0]), number<std::uint64_t>(fields[1])};
  }
  [[nodiscard]] Value value(std::string_view text) const {
    log::ValueReader reader(text);
    Value out = reader.read();
    if (!reader.is_at_end()) refuse("the end of a value");
    return out;
  }
  [[nodiscard]] Value::List arguments(std::string_view text) const {
    const Value read = value(text);
    const auto* list = read.get_if<Value::List>();
    if (list == nullptr) refuse("a list of arguments");
    return *list;
  }
  LoggedEntry& entry() {
    if (log_.entries.empty()) refuse("an entry first");
    return log_.entries.back();
  }

  void take_robot(Fields fields) { log_.robot = fields[0]; }
  void take_planner(Fields fields) { log_.planners.emplace_back(fields[0]); }
  void take_frames(Fields fields) { log_.frames.emplace_back(fields[0]); }
  void take_world(Fields fields) {
    log_.world = WorldText{std::string(fields[0]), std::string(fields[1])};
  }
  void take_default_world(Fields fields) {
    log_.default_world = WorldText{std::string(fields[0]), std::string(fields[1])};
  }
  void take_limits(Fields fields) {
    RunLimits& limits = log_.limits;
    limits.steps = number<std::uint64_t>(fields[0]);
    limits.heap_bytes = number<std::uint64_t>(fields[1]);
    limits.call_depth = number<std::uint32_t>(fields[2]);
    limits.output_bytes = number<std::uint64_t>(fields[3]);
    limits.time_ns = time(fields[4]);
    if (limits.heap_bytes > std::uint64_t{1} << 40U || limits.call_depth > 10'000'000)
      refuse("limits that a machine has room for");
    has_limits_ = true;
  }
  void take_open(Fields fields) {
    if (fields[0] != "yes" && fields[0] != "no") refuse("yes or no");
    log_.open = fields[0] == "yes";
  }
  void take_laboratory(Fields fields) {
    if (fields[0] != "yes") refuse("yes");
    log_.laboratory = true;
  }
  LoggedEntry& begin(EntryKind kind, std::string_view name) {
    LoggedEntry& entry = log_.entries.emplace_back();
    entry.kind = kind;
    entry.name = name;
    return entry;
  }
  void take_program(Fields fields) { begin(EntryKind::kProgram, fields[0]).text = fields[1]; }
  void take_entry(Fields fields) { begin(EntryKind::kEntry, fields[0]).text = fields[1]; }
  void take_run(Fields fields) {
    begin(EntryKind::kCall, fields[0]).arguments = arguments(fields[1]);
  }
  void take_import(Fields fields) {
    LoggedImport import{std::string(fields[0]), std::string(fields[1]), {}};
    import.given.name = fields[2];
    import.given.text = fields[3];
    entry().imports.push_back(std::move(import));
  }
  void take_signal(Fields fields) {
    const Value given = value(fields[3]);
    const bool* on = given.get_if<bool>();
    const auto* level = given.get_if<Value::Number>();
    if (on == nullptr && level == nullptr) refuse("a truth value or a number");
    const SignalValue signal = on != nullptr ? SignalValue(*on) : SignalValue(level->si);
    entry().inputs.push_back({place(fields), SetSignal{std::string(fields[2]), signal}});
  }
  void take_set(Fields fields) {
    entry().inputs.push_back({place(fields), SetGlobal{std::string(fields[2]), value(fields[3])}});
  }
  void take_call(Fields fields) {
    entry().inputs.push_back(
        {place(fields), CallFunction{std::string(fields[2]), arguments(fields[3])}});
  }
  void take_press(Fields fields) {
    entry().inputs.push_back({place(fields), PressButton{std::string(fields[2])}});
  }
  void take_joints(Fields fields) {
    const Value given = value(fields[3]);
    MoveJoints moved{std::string(fields[2]), {}};
    const auto* list = given.get_if<Value::List>();
    if (list == nullptr) refuse("a list of joint values");
    for (const Value& each : *list) {
      const auto* number = each.get_if<Value::Number>();
      if (number == nullptr) refuse("a joint value");
      moved.q.push_back(number->si);
    }
    entry().inputs.push_back({place(fields), std::move(moved)});
  }
  void take_reply(Fields fields) {
    entry().replies.push_back({std::string(fields[0]), std::string(fields[1])});
  }
  void take_refusal(Fields fields) {
    Reply reply{.question = std::string(fields[0]), .text = {}};
    reply.error = Error{std::string(fields[1]), std::string(fields[2])};
    entry().replies.push_back(std::move(reply));
  }
  void take_cancel(Fields fields) {
    entry().cancelled.push_back({place(fields), number<std::uint32_t>(fields[2])});
  }
  void take_stop(Fields fields) { entry().stopped_ns.push_back(time(fields[0])); }
  void take_end(Fields fields) { entry().end = place(fields); }
  void take_mark(Fields fields) {
    log_.marks.push_back({time(fields[0]), number<std::uint64_t>(fields[1], 16)});
  }

  static constexpr Kind kKinds[] = {
      {"robot", 1, &Reader::take_robot},
      {"planner", 1, &Reader::take_planner},
      {"frames", 1, &Reader::take_frames},
      {"world", 2, &Reader::take_world},
      {"default-world", 2, &Reader::take_default_world},
      {"limits", 5, &Reader::take_limits},
      {"open", 1, &Reader::take_open},
      {"program", 2, &Reader::take_program},
      {"run", 2, &Reader::take_run},
      {"entry", 2, &Reader::take_entry},
      {"import", 4, &Reader::take_import},
      {"signal", 4, &Reader::take_signal},
      {"set", 4, &Reader::take_set},
      {"call", 4, &Reader::take_call},
      {"reply", 2, &Reader::take_reply},
      {"refusal", 3, &Reader::take_refusal},
      {"cancel", 3, &Reader::take_cancel},
      {"press", 3, &Reader::take_press},
      {"joints", 4, &Reader::take_joints},
      {"laboratory", 1, &Reader::take_laboratory},
      {"stop", 1, &Reader::take_stop},
      {"end", 2, &Reader::take_end},
      {"mark", 2, &Reader::take_mark},
  };

  std::string_view all_;
  std::string_view rest_;
  SessionLog log_;
  bool has_limits_ = false;
};

// The error in the file as a whole; empty if there is none.
std::string fault_of(std::string_view bytes) {
  const std::string_view line = bytes.substr(0, bytes.find('\n'));
  if (!line.starts_with(kMagic))
    return fmt::format("this is no log of a session: it does not begin with `{}`", kMagic);
  const std::string ours = header();
  if (!bytes.starts_with(ours)) {
    if (line.size() > 100 || bytes.size() == line.size())
      return "the log is cut short in its first line";
    return fmt::format(
        "the log begins with `{}`, and this is `{}`: another version may run programs differently",
        line, std::string_view(ours).substr(0, ours.size() - 1));
  }
  if (bytes.size() < ours.size() + kSumSize ||
      !bytes.substr(bytes.size() - kSumSize).starts_with("sum 16\n")) {
    return fmt::format("the log is cut short: after {} bytes there is no sum at its end",
                       bytes.size());
  }
  const std::size_t size = bytes.size() - kSumSize;
  if (bytes.substr(size) != sum_of(bytes.substr(0, size)))
    return "the log was changed after it was written: its sum is another one";
  return {};
}

// Fails for records in another order and for repeated ones, which would be ignored silently.
void demand_as_written(const SessionLog& log, std::string_view bytes) {
  const std::string ours = write(log);
  if (ours == bytes) return;
  const auto [there, here] = std::mismatch(bytes.begin(), bytes.end(), ours.begin(), ours.end());
  throw ArgumentError(
      fmt::format("byte {} of the log is not as this version writes it: its records have another "
                  "order or form, or one of them stands twice",
                  there - bytes.begin()));
}

}  // namespace

Result<std::string> write_log(const SessionLog& log) {
  try {
    return write(log);
  } catch (const ArgumentError& error) {
    return Error{"log", error.what()};
  }
}

Result<SessionLog> read_log(std::string_view bytes) {
  if (const std::string fault = fault_of(bytes); !fault.empty()) return Error{"log", fault};
  try {
    SessionLog log = Reader(bytes).read();
    demand_as_written(log, bytes);
    return log;
  } catch (const ArgumentError& error) {
    return Error{"log", error.what()};
  }
}

}  // namespace armlet
