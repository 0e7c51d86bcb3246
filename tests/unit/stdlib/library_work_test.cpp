// Every function of the library, with large arguments: what it does counts as steps, it looks at
// the stop request while it works, and nothing is left behind when it is cancelled.

#include <doctest/doctest.h>

#include <ctime>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "armlet/interpreter/work.hpp"
#include "armlet/stdlib/host.hpp"
#include "armlet/vision/opencv.hpp"
#include "driver/vocabulary.hpp"
#include "library.hpp"
#include "sanitized.hpp"
#include "vm/state/state.hpp"

using namespace armlet;

namespace {

constexpr std::uint64_t kItems = kSanitized ? 20'000 : 200'000;  // of every large argument

// Time of the processor for this thread, which other programs do not lengthen.
double milliseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

// What happened between begin() and end() of a program.
struct Watch {
  bool on = false;
  double last = 0.0;
  double longest = 0.0;  // ms between two looks
  std::uint64_t looks = 0;
  std::uint64_t cancel_at = UINT64_MAX;
  std::uint64_t steps = 0;

  void look() {
    if (!on) return;
    const double now = milliseconds();
    longest = std::max(longest, now - last);
    last = now;
    ++looks;
  }
};
Watch watch;

std::uint64_t steps_of(Vm& vm) {
  const lang::StepMeter& meter = vm.state().steps;
  return meter.total + static_cast<std::uint64_t>(meter.chunk - meter.left);
}
Signal begin(Vm& vm, Slot*) {
  watch.steps = steps_of(vm);
  watch.last = milliseconds();
  watch.on = true;
  return give_nothing();
}
Signal end(Vm& vm, Slot*) {
  watch.look();
  watch.on = false;
  watch.steps = steps_of(vm) - watch.steps;
  return give_nothing();
}
const NativeFunction kMarks[] = {
    {"beginWatch", "()", "Begins to watch.", "beginWatch()", begin},
    {"endWatch", "()", "Ends to watch.", "endWatch()", end},
};

const Engine& watched_engine() {
  static const Engine engine = [] {
    Engine made;
    install(made);
    made.add_functions(kMarks, "Marks");
    return made;
  }();
  return engine;
}

std::shared_ptr<const Program> compiled(const std::string& text) {
  Host host({.robot = make_robot("scara")});
  CompileOptions options;
  options.host = &host;
  return watched_engine().compile(text, "work.rbt", options).program;
}

struct Run {
  RunResult result;
  Watch seen;
  std::uint64_t left = 0;  // bytes that nobody released
};

Run run(const std::shared_ptr<const Program>& program, std::uint64_t cancel_at) {
  Host host({.robot = make_robot("scara")});
  VmOptions options;
  options.limits.steps = 50'000'000;
  options.limits.heap_bytes = 256U << 20U;
  options.timeline = &host;
  options.host = &host;
  options.output = [](std::string_view) {};
  Vm vm(program, std::move(options));
  watch = {};
  watch.cancel_at = cancel_at;
  vm.state().host.on_look = [&vm] {
    watch.look();
    if (watch.on && watch.looks == watch.cancel_at) vm.cancel();
  };
  Run run;
  run.result = vm.run();
  run.seen = watch;
  vm.state().clear();
  run.left = vm.state().heap.used();
  return run;
}

// ---- calls ------------------------------------------------------------------------------------

// Large arguments by the type of a parameter, and what declares them.
struct Large {
  const char* value;
  const char* declared;
};
const std::map<std::string, Large> kLarge = {
    {"D[]", {"xs", "let xs = linspace(0.5, 0.9, N)"}},
    {"E[]", {"xs", "let xs = linspace(0.5, 0.9, N)"}},
    {"T[]", {"xs", "let xs = linspace(0.5, 0.9, N)"}},
    {"U[]", {"xs", "let xs = linspace(0.5, 0.9, N)"}},
    {"double[]", {"xs", "let xs = linspace(0.5, 0.9, N)"}},
    {"int[]", {"ks", "let ks = range(N)"}},
    {"string", {"s", "var s = \"abcdefgh,\"\nwhile (s.length < N) { s += s }"}},
    {"string[]", {"ts", "let ts = map(range(N), fn(i) => \"item\")"}},
    {"double[][]", {"rs", "let rs = map(range(N / 4), fn(i) => [0.1, 0.2, 0.3, 0.4])"}},
    {"D[][]", {"rs3", "let rs3 = map(range(N / 4), fn(i) => [0.1, 0.2, 0.3])"}},
    {"int[][]", {"krs", "let krs = map(range(N / 4), fn(i) => [1, 2, 3, 4])"}},
    {"matrix", {"m", "let m = ones(400, N / 400)"}},
    {"matrix[]", {"ms", "let m = ones(400, N / 400)\nlet ms = [m, m, m]"}},
};
const std::map<std::string, const char*> kSmall = {
    {"D", "0.5"},
    {"E", "0.5"},
    {"T", "0.95"},  // in none of the lists
    {"double", "0.5"},
    {"int", "3"},
    {"bool", "true"},
    {"posJ", "home()"},
    {"posC", "here()"},
    {"fn(T) -> U", "fn(x) => x"},
    {"fn(T) -> bool", "fn(x) => x < 0.0"},
    {"fn(U, T) -> U", "fn(a, b) => a + b"},
};

struct Parameter {
  std::string name;
  std::string type;
  bool needed = true;
};

// The parameters of "(a: D[], f: fn(T) -> U, n: int = 1) -> D".
std::vector<Parameter> parameters(std::string_view signature) {
  std::vector<Parameter> out;
  int depth = 0;
  std::size_t begin = 1;
  for (std::size_t i = 0; i < signature.size(); ++i) {
    depth += signature[i] == '(' || signature[i] == '{' ? 1 : 0;
    depth -= signature[i] == ')' || signature[i] == '}' ? 1 : 0;
    const bool ends = depth == 0 || (depth == 1 && signature[i] == ',');
    if (!ends) continue;
    std::string_view text = signature.substr(begin, i - begin);
    while (text.starts_with(' ')) text.remove_prefix(1);
    const std::size_t colon = text.find(": ");
    if (colon != std::string_view::npos) {
      Parameter p{std::string(text.substr(0, colon)), std::string(text.substr(colon + 2))};
      const std::size_t equals = p.type.find(" = ");
      if (equals != std::string::npos || p.type.ends_with('?')) p.needed = false;
      out.push_back(p);
    }
    begin = i + 1;
    if (depth == 0) break;
  }
  return out;
}

// Calls that say more than the types of the parameters, by name: the largest that is legal, as far
// as it takes no longer than a test may.
const std::multimap<std::string, std::string> kCalls = {
    {"range", "let r = range(N)"},
    {"all", "let xs = linspace(0.5, 0.9, N)\nlet r = all(xs, fn(x) => x > 0.0)"},
    {"linspace", "let r = linspace(0.0, 1.0, N)"},
    {"zeros", "let r = zeros(N)"},
    {"zeros", "let r = zeros(400, N / 400)"},
    {"ones", "let r = ones(N)"},
    {"ones", "let r = ones(400, N / 400)"},
    {"eye", "let r = eye(400)"},
    {"svd", "let r = svd(eye(100) + ones(100, 100))"},
    {"pinv", "let r = pinv(eye(100) + ones(100, 100))"},
    {"rank", "let r = rank(eye(100) + ones(100, 100))"},
    {"operator^", "let r = eye(200) ^ 1000000000"},
    {"operator*", "let r = ones(300, 300) * ones(300, 300)"},
    {"operator\\", "let r = (eye(200) + ones(200, 200)) \\ ones(200, 200)"},
    {"polyfit", "let r = polyfit(linspace(0.0, 1.0, N / 10), linspace(0.0, 1.0, N / 10), 50)"},
    {"ode", "let r = ode(fn(t, y) => [-y[0]], [1.0], 0s, 1s, step: 1s / N)"},
    {"minimise", "let r = minimise(fn(v) => sum(v .* v), ones(60))"},
    {"split",
     "let s = join(map(range(N / 10), fn(i) => \"abc\"), \",\")\nbeginWatch()\nlet r = "
     "s.split(\",\")"},
    {"replace",
     "let s = join(map(range(N / 10), fn(i) => \"abc\"), \",\")\nbeginWatch()\nlet r = "
     "s.replace(\",\", \"; \")"},
    {"trajectory",
     "let r = trajectory(\"Spline3\", map(range(1000), fn(i) => home() + [0.1 * sin(0.1 * i), 0.0, "
     "0.0, 0.0]))"},
    {"trajectory",
     "let r = trajectory(\"Fastest\", map(range(50), fn(i) => home() + [0.1 * sin(0.5 * i), 0.1 * "
     "cos(0.7 * i), 0.0, 0.0]))"},
    {"sort", "let r = sort(map(range(N / 4), fn(i) => -i), by: fn(x) => x % 1000)"},
    {"print", "print(map(range(N / 4), fn(i) => 0.1 * i))"},
};

// Takes the same time whatever the size of its arguments, or looks only at a beginning of them.
const std::set<std::string, std::less<>> kShort = {
    "all",  // ends at the first element; called to the end below
    "diag",
    // The name is compared with few others.
    "insertObj",
    "signal",
    "setSignal",
    "number",
    "setNumber",
    "matrix.rows",
    "matrix.cols",
    "figure",
    "table.length",
};

std::string replaced(std::string text) {
  const std::string count = std::to_string(kItems);
  for (std::size_t at = text.find('N'); at != std::string::npos; at = text.find('N', at + 1)) {
    const auto is_letter = [&](std::size_t i) {
      return i < text.size() && (std::isalnum(static_cast<unsigned char>(text[i])) != 0);
    };
    if (is_letter(at + 1) || (at > 0 && is_letter(at - 1))) continue;
    text.replace(at, 1, count);
  }
  return text;
}

// The call of a function as programs write it; empty if that takes more than values in brackets.
std::string call_of(const NativeFunction& f, const std::vector<std::string>& values) {
  const std::string name(f.name);
  if (name.starts_with("operator")) {
    const std::string sign = name.substr(8);
    if (values.size() == 1) return sign + values[0];
    return values.size() == 2 ? values[0] + ' ' + sign + ' ' + values[1] : "";
  }
  if (name.find_first_of("{}[]") != std::string::npos) return {};
  std::string arguments;
  const bool is_member = name.find('.') != std::string::npos;
  for (std::size_t i = is_member ? 1 : 0; i < values.size(); ++i)
    arguments += (arguments.empty() ? "" : ", ") + values[i];
  if (!is_member) return name + '(' + arguments + ')';
  if (values.empty()) return {};
  const std::string member = values[0] + name.substr(name.find('.'));
  return values.size() == 1 ? member : member + '(' + arguments + ')';
}

struct Case {
  std::string name;
  std::string text;
  bool is_large = false;  // its work grows with kItems
};

// The example as a program; a value alone is no statement.
std::shared_ptr<const Program> example_of(const NativeFunction& f, std::string& text) {
  const std::string example(f.example);
  for (const std::string& body :
       {example, "let r = " + example, "print(" + example + ")", "robot one { " + example + " }",
        "robot arm = robots.scara()\ncamera eye { on: arm }\nlab one { " + example + " }"}) {
    text = "beginWatch()\n" + body + "\nendWatch()";
    if (auto program = compiled(text)) return program;
  }
  return nullptr;
}

// A call with large arguments; nothing if the function takes none.
std::vector<Case> large_calls(const NativeFunction& f) {
  std::set<std::string> declared;
  std::vector<std::string> values;
  for (const Parameter& p : parameters(f.signature)) {
    if (!p.needed) break;
    if (const auto large = kLarge.find(p.type); large != kLarge.end()) {
      values.emplace_back(large->second.value);
      declared.insert(large->second.declared);
    } else if (const auto small = kSmall.find(p.type); small != kSmall.end()) {
      values.emplace_back(small->second);
    } else {
      return {};
    }
  }
  const std::string call = call_of(f, values);
  if (declared.empty() || call.empty()) return {};
  std::string text;
  for (const std::string& declaration : declared) text += declaration + '\n';
  const bool gives = f.signature.find("->") != std::string_view::npos;
  text += "beginWatch()\n" + (gives ? "let r = " + call : call) + "\nendWatch()";
  return {{std::string(f.name) + ' ' + std::string(f.signature), replaced(text),
           !kShort.contains(std::string(f.name))}};
}

std::vector<Case> cases() {
  std::vector<Case> out;
  std::set<std::string> seen;
  for (const lang::Chapter& chapter : watched_engine().registry().chapters()) {
    if (chapter.title == "Marks") continue;
    for (const NativeFunction& f : chapter.functions) {
      const std::string name(f.name);
      const std::string title = name + ' ' + std::string(f.signature);
      std::string example;
      if (example_of(f, example) != nullptr) out.push_back({title, example});
      for (Case& large : large_calls(f)) out.push_back(std::move(large));
      if (!seen.insert(name).second) continue;
      const auto [first, last] = kCalls.equal_range(name);
      for (auto call = first; call != last; ++call)
        out.push_back({title, replaced("beginWatch()\n" + call->second + "\nendWatch()"), true});
    }
  }
  return out;
}

}  // namespace

TEST_CASE("every function of the library counts its work and notices a stop request") {
  constexpr double kMostGap = 50.0;  // ms
  int large = 0;
  int cancelled = 0;
  (void)has_opencv();  // is loaded once, which takes 80 ms
  for (const Case& each : cases()) {
    INFO(each.name << "\n" << each.text);
    const auto program = compiled(each.text);
    if (program == nullptr) continue;  // such as a generic argument that does not fit
    const Run whole = run(program, UINT64_MAX);
    REQUIRE(whole.left == 0);
    if (!kSanitized) CHECK(whole.seen.longest < kMostGap);
    if (each.is_large && whole.result.status == Progress::kDone) {
      ++large;
      CHECK(whole.seen.steps * kWorkPerStep >= kItems / 4);
    }
    if (whole.seen.looks < 2) continue;
    const Run stopped = run(program, 1 + (whole.seen.looks - 1) / 2);
    ++cancelled;
    REQUIRE(stopped.left == 0);
    CHECK(stopped.result.status == Progress::kCancelled);
  }
  CHECK(large > 100);
  CHECK(cancelled > 30);
}

TEST_CASE("every function of the library is called by the test above") {
  int rows = 0;
  for (const lang::Chapter& chapter : watched_engine().registry().chapters()) {
    for (const NativeFunction& f : chapter.functions) {
      if (chapter.title == "Marks") continue;
      CAPTURE(f.name);
      CAPTURE(f.signature);
      ++rows;
      // Its example runs, or begins to. Some functions are there to be explained only.
      std::string example;
      if (!f.example.empty()) CHECK(example_of(f, example) != nullptr);
    }
  }
  CHECK(rows > 300);
}
