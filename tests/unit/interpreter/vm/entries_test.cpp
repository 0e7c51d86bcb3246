// Entries of a session: each compiled in the scope of those before it, and run by the same machine.

#include <doctest/doctest.h>

#include <string>
#include <utility>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/engine.hpp"
#include "armlet/interpreter/render.hpp"
#include "vm/state/state.hpp"

using namespace armlet;

namespace {

// Submits entry after entry, as a prompt does.
class Entries {
 public:
  explicit Entries(const Engine& engine) : engine_(engine) {}

  // What the entry printed, and what it shows; or the codes of its messages.
  std::string operator()(const std::string& text) {
    printed_.clear();
    advice_.clear();
    CompileOptions options;
    options.is_entry = true;
    options.after = newest_;
    const Compilation made = engine_.compile(text, "[" + std::to_string(++count_) + "]", options);
    for (const Diagnostic& d : made.diagnostics) {
      why_ = d.why;
      if (d.severity == Severity::kError) return d.code + ": " + d.message;
      advice_ += d.code + ": " + d.message;
    }
    if (vm_ == nullptr) {
      VmOptions vm_options;
      vm_options.output = [this](std::string_view part) { printed_ += part; };
      vm_ = std::make_unique<Vm>(made.program, std::move(vm_options));
    } else {
      vm_->begin(made.program);
    }
    const RunResult result = vm_->run();
    if (result.error) return printed_ + result.error->code + ": " + result.error->message;
    newest_ = made.program;
    std::string out = printed_;
    if (const auto shown = vm_->shown())
      out += (shown->name.empty() ? "" : shown->name + " = ") + shown->text + "  " + shown->type;
    return out;
  }

  [[nodiscard]] const std::string& advice() const { return advice_; }
  // Of the last message.
  [[nodiscard]] const std::string& why() const { return why_; }
  [[nodiscard]] Vm& vm() { return *vm_; }
  [[nodiscard]] const std::shared_ptr<const Program>& newest() const { return newest_; }

 private:
  const Engine& engine_;
  std::shared_ptr<const Program> newest_;
  std::unique_ptr<Vm> vm_;
  std::string printed_;
  std::string advice_;
  std::string why_;
  int count_ = 0;
};

}  // namespace

TEST_CASE("an entry sees the variables, functions and types of those before it") {
  const Engine engine;
  Entries enter(engine);
  CHECK(enter("let a = 20mm") == "a = 20 mm  length");
  CHECK(enter("var n = 1; fn twice(x: double) -> double { return 2 * x }").empty());
  CHECK(enter("n = n + 1").empty());
  CHECK(enter("print(n)") == "2\n");
  CHECK(enter("twice(4)") == "8.0  double");
  CHECK(enter("ans + 1") == "9.0  double");
  CHECK(enter("ans + 1;").empty());
  CHECK(enter("ans") == "10.0  double");
  CHECK(enter("struct Part { w: length; n: int }").empty());
  CHECK(enter("let p = Part(w: a, n: 3)") == "p = Part(w: 20 mm, n: 3)  Part");
  CHECK(enter("p.w + a") == "40 mm  length");
  CHECK(enter("enum Side { left, right }").empty());
  CHECK(enter("Side.right") == "Side.right  Side");
  CHECK(enter("\"text\"") == "\"text\"  string");
  CHECK(enter("fn same(x) { return x }").empty());
  CHECK(enter("same(3)") == "3  int");
  CHECK(enter("same(\"x\")") == "\"x\"  string");
  CHECK(enter("same(3)") == "3  int");
}

TEST_CASE("a name may be declared again") {
  const Engine engine;
  Entries enter(engine);
  CHECK(enter("let x = 1") == "x = 1  int");
  CHECK(enter("let x = x + 1.5") == "x = 2.5  double");
  CHECK(enter("fn f(n: int) -> int { return n + 1 }").empty());
  CHECK(enter("fn g(n: int) -> int { return 10 * f(n) }").empty());
  CHECK(enter("g(1)") == "20  int");
  CHECK(enter("fn f(n: int) -> int { return n + 2 }").empty());
  CHECK(enter.advice().empty());
  CHECK(enter("g(1)") == "30  int");
  CHECK(enter("fn f(n: double) -> double { return n }").empty());
  CHECK(enter.advice() == "W0719: `f` is declared again, and `g` goes on with the earlier one");
  CHECK(enter("g(1)") == "30  int");
  CHECK(enter("f(1)") == "1.0  double");
  CHECK(enter("var speed = 3").empty() == false);
  CHECK(enter("fn go() -> int { return speed }").empty());
  CHECK(enter("speed = 4").empty());
  CHECK(enter("go()") == "4  int");
  CHECK(enter("var speed = 9;").empty());
  CHECK(enter.advice() ==
        "W0719: `speed` is declared again, and `go` goes on with the earlier one");
  CHECK(enter("go()") == "4  int");
  CHECK(enter("speed") == "9  int");
  CHECK(enter("let f = 5") == "f = 5  int");
  CHECK(enter("f") == "5  int");
}

TEST_CASE("values of a struct that was declared again keep their type") {
  const Engine engine;
  Entries enter(engine);
  enter("struct Part { w: int }");
  enter("let a = Part(w: 2)\nfn show(p: Part) -> int { return p.w }");
  enter("struct Part { w: int, n: int }");
  CHECK(enter("show(a)") == "2  int");
  CHECK(enter("a.w") == "2  int");
  CHECK(enter("Part(w: 3, n: 4).n") == "4  int");
  CHECK(enter("let c: Part = a").starts_with("E0315"));
  CHECK(enter.why() ==
        "`Part` was declared again, and a value keeps the type that it was made with");
  CHECK(enter("show(Part(w: 3, n: 4))").starts_with("E0313"));
  CHECK(enter("[a, Part(w: 3, n: 4)]").starts_with("E0330"));
  CHECK(enter.why().find("declared again") != std::string::npos);
  enter("enum Side { left, right }");
  enter("let s = Side.left");
  enter("enum Side { up, down }");
  CHECK(enter("let r: Side = s").starts_with("E0315"));
  CHECK(enter.why().find("declared again") != std::string::npos);
  CHECK(enter("s") == "Side.left  Side");
}

TEST_CASE("what does not compile or fails changes nothing") {
  const Engine engine;
  Entries enter(engine);
  enter("var n = 1; var xs = [1, 2, 3]; fn f() -> int { return n }");
  CHECK(enter("n = 2; y = 3").starts_with("E0201"));
  CHECK(enter("n") == "1  int");
  CHECK(enter("n = 7; xs[0] = 9; let z = 4; fn f() -> int { return 100 }\nxs[3] = 1").find("R06") !=
        std::string::npos);
  CHECK(enter("n") == "1  int");
  CHECK(enter("xs") == "[1, 2, 3]  int[]");
  CHECK(enter("f()") == "1  int");
  CHECK(enter("z").starts_with("E0201"));
  CHECK(enter("xs[0] = 5; xs") == "[5, 2, 3]  int[]");
}

TEST_CASE("watches of earlier entries live on") {
  const Engine engine;
  Entries enter(engine);
  CHECK(enter("var beats = 0\nevery (1s) { beats = beats + 1 }").empty());
  CHECK(enter("beats") == "1  int");
  CHECK(enter("wait(3.5s)").empty());
  CHECK(enter("beats") == "4  int");
  CHECK(enter("var seen = 0\nwhen (beats > 5) { seen = beats }").empty());
  CHECK(enter("wait(3s)").empty());
  CHECK(enter("seen") == "6  int");
}

TEST_CASE("a text is complete when its brackets are closed and its last line ends") {
  CHECK(is_complete("let x = 1"));
  CHECK(is_complete("fn f() { return 1 }"));
  CHECK_FALSE(is_complete("fn f() {"));
  CHECK_FALSE(is_complete("let x = [1,"));
  CHECK_FALSE(is_complete("let x = 1 +"));
  // The body comes below.
  for (const char* head :
       {"if (a > 1)", "while (true)", "fn f(x: int) -> int", "void go()", "struct P",
        "double mean(double[] a)", "do { n = 1 }", "test \"t\"", "every (1s)"})
    CHECK_FALSE_MESSAGE(is_complete(head), head);
  for (const char* whole :
       {"double x", "double[] q = {1, 2}", "fn f(x) => 2 * x", "f(1)", "struct P { }",
        "do { n = 1 } while (n < 1)", "n++", "return", "// nothing", "x)"})
    CHECK_MESSAGE(is_complete(whole), whole);
  // The line behind it may belong to it.
  CHECK_FALSE(is_complete("if (a) { }", "else { }"));
  CHECK_FALSE(is_complete("try { f() }", "catch (e) { }"));
  CHECK_FALSE(is_complete("xs", "  .map(f)"));
  CHECK_FALSE(is_complete("let x = 1", "+ 2"));
  CHECK(is_complete("let x = 1;", "+ 2"));
  CHECK(is_complete("let x = 1", "let y = 2"));
  CHECK(is_complete("if (a) { }", "if (b) {"));
  CHECK(is_complete("f(1)", "// else"));
  CHECK(is_complete("f(1)", "\"open"));
}

TEST_CASE("a session of 10,000 entries works, and uses the numbers of its variables again") {
  const Engine engine;
  Entries enter(engine);
  enter("var n = 0");
  for (int i = 1; i < 9998; ++i) enter("n = n + 1; let last = n;");
  CHECK(enter("last") == "9997  int");
  CHECK(enter("n + ans") == "19994  int");
  CHECK(enter.vm().state().globals.values.size() < 10);
  CHECK(enter.vm().state().programs.units.empty());
}

TEST_CASE("an entry follows the newest one that has run to its end, in one machine") {
  const Engine engine;
  Entries enter(engine);
  enter("var n = 1");
  const std::shared_ptr<const Program> first = enter.newest();
  enter("n = 2");
  CompileOptions options;
  options.is_entry = true;
  options.after = first;
  const Compilation old = engine.compile("n = 3", "[x]", options);
  CHECK_THROWS_AS(enter.vm().begin(old.program), ArgumentError);
  CHECK_THROWS_AS(enter.vm().begin(nullptr), ArgumentError);
  const Compilation alone = engine.compile("let n = 3", "file", {});
  CHECK_THROWS_AS(enter.vm().begin(alone.program), ArgumentError);
  CompileOptions behind_file;
  behind_file.after = alone.program;
  CHECK_THROWS_AS((void)engine.compile("n", "[x]", behind_file), ArgumentError);
  CHECK(enter("n") == "2  int");
}
