// Positions where only a few things can stand: they are offered, and nothing else is.

#include <doctest/doctest.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "../editor_support.hpp"

using namespace armlet;
using namespace armlet::editor_test;

namespace {

const std::string kDeclarations =
    "enum State { Idle, Done }\nstruct Pallet { rows: int }\nlet reach: length = 200mm\n"
    "let turn = 30deg\nvar state = State.Idle\nvar stock = {\"bolt\": 3, \"nut\": 5}\n"
    "var velocity = 2m/s\nrobot arm = robots.scara()\n";

// A program with a bar where somebody writes.
struct Written {
  explicit Written(std::string_view with_bar, bool declares = true)
      : text((declares ? kDeclarations : "") + std::string(with_bar)) {
    const std::size_t bar = text.find('|');
    REQUIRE(bar != std::string::npos);
    text.erase(bar, 1);
    at = static_cast<std::uint32_t>(bar);
    list = analysis_of(text)->completion(at);
  }
  [[nodiscard]] std::vector<std::string> texts() const {
    std::vector<std::string> out;
    for (const Completion& item : list.items) out.push_back(item.text);
    return out;
  }
  [[nodiscard]] bool has(std::string_view item) const { return offers(list, item); }
  [[nodiscard]] std::string with(std::string_view item) const {
    std::string out = text;
    return out.replace(list.replaced.begin, list.replaced.end - list.replaced.begin, item);
  }

  std::string text;
  std::uint32_t at = 0;
  Completions list;
};

// Errors that are marked where an item was put in.
std::vector<std::string> refusals(const Written& written, const Completion& item) {
  const std::string text = written.with(item.text);
  const std::uint32_t end =
      written.list.replaced.begin + static_cast<std::uint32_t>(item.text.size());
  std::vector<std::string> out;
  for (const Diagnostic& each : analysis_of(text)->diagnostics()) {
    const Span mark = each.mark.span;
    if (each.severity == Severity::kError && mark.begin < end + 1 &&
        written.list.replaced.begin <= mark.end)
      out.push_back(item.text + ": " + each.code + ' ' + each.message);
  }
  return out;
}

}  // namespace

TEST_CASE("where only a few things can stand nothing is offered that the check refuses") {
  for (const char* place : {
           "let x: |\n",
           "var x: St|\n",
           "fn f(a: |) {\n    print(a)\n}\n",
           "fn f(a: int, b: |) => 1\n",
           "struct Box { a: |; b: int }\n",
           "fn f(x: fn(int) -> |) => 1\n",
           "let x = 85|\n",
           "let x = 85m|\n",
           "let x = 1.5e3|\n",
           "let x = 100mm/|s\n",
           "print(f\"{reach: |}\")\n",
           "print(f\"{reach:.1f |}\")\n",
           "print(f\"{turn:8.2f |}\")\n",
           "print(f\"{velocity: |}\")\n",
           "print(f\"{reach + 20mm: |}\")\n",
           "switch (state) {\n    case |: print(1)\n}\n",
           "try { arm.home() } catch (e) {\n    switch (e.kind) {\n        case |: print(1)\n    "
           "}\n}\n",
           "try { arm.home() } catch (e) {\n    if (e.kind == \"|\") { print(1) }\n}\n",
           "print(stock[\"|\"])\n",
           "with (track: \"|\") { arm.moveJ(arm.home()) }\n",
           "with (torques: \"|\") { arm.moveJ(arm.home()) }\n",
           "with (collisions: \"|\") { arm.moveJ(arm.home()) }\n",
       }) {
    CAPTURE(place);
    const Written written(place);
    CHECK(written.list.items.size() >= 1);
    for (const Completion& item : written.list.items) {
      for (const std::string& refusal : refusals(written, item)) {
        // A struct of another file, a function type and a list are written on.
        if (item.text == "fn" || item.kind == NameKind::kModule) continue;
        FAIL_CHECK(refusal);
      }
    }
  }
}

TEST_CASE("types are offered where types stand, and no values") {
  const Written written("let x: |\n");
  for (const char* type : {"length", "int", "double", "string", "State", "Pallet", "posC", "angle"})
    CHECK_MESSAGE(written.has(type), type);
  for (const char* other : {"reach", "sin", "moveJ", "for", "let", "state", "void"})
    CHECK_FALSE_MESSAGE(written.has(other), other);
  CHECK(Written("fn f() -> |\n").has("void"));
  CHECK(Written("fn f(a: len|").has("length"));
  CHECK(Written("let k: force/|\n").has("length"));
}

TEST_CASE("behind a number only units are offered") {
  const Written written("let x = 85m|\n");
  CHECK(written.has("mm"));
  CHECK(written.has("m/s"));
  for (const char* other : {"reach", "moveJ", "max", "matrix", "mod"})
    CHECK_FALSE_MESSAGE(written.has(other), other);
  CHECK(written.with("mm").ends_with("let x = 85mm\n"));
  const Written second("let x = 100mm/|\n");
  CHECK(second.has("reach"));  // a division
  const Written third("let x = 100mm/s|\n");
  CHECK(third.with("ms").ends_with("let x = 100mm/ms\n"));
  CHECK(Written("let x = 8|5\n").list.items.empty());
}

TEST_CASE("a format offers the units that can show the value") {
  const Written written("print(f\"{reach:.1f |}\")\n");
  CHECK(written.has("mm"));
  CHECK_FALSE(written.has("deg"));
  CHECK_FALSE(written.has("reach"));
  CHECK(Written("print(f\"{turn: |}\")\n").has("deg"));
  CHECK(Written("print(f\"{velocity: |}\")\n").has("mm/s"));
  CHECK(Written("print(f\"{rea|}\")\n").has("reach"));
}

TEST_CASE("cases are values of what is switched on") {
  const Written written("switch (state) {\n    case |\n}\n");
  CHECK(written.texts() == std::vector<std::string>{"State.Idle", "State.Done"});
  CHECK(Written("switch (state) {\n    case State.Idle, |: print(1)\n}\n").has("State.Done"));
}

TEST_CASE("texts that name something are offered") {
  const Written kind("try { arm.home() } catch (e) {\n    if (e.kind == \"|\n");
  CHECK(kind.has("Collision"));
  CHECK(kind.has("Timeout"));
  const Written own(
      "try { throw error(\"it slipped\", kind: \"slip\") } catch (e) {\n"
      "    if (e.kind != \"|\") { print(1) }\n}\n");
  CHECK(own.has("slip"));
  CHECK(Written("print(stock[\"|\n").texts() == std::vector<std::string>{"bolt", "nut"});
  CHECK(Written("with (track: \"|\n").texts() ==
        std::vector<std::string>{"exact", "slow", "damped"});
  const std::string program = "import \"\"\n";
  SessionOptions options;
  options.load = [](const std::string& path, const std::string&) {
    ImportedText out;
    if (!path.ends_with("grip.rbt")) out.others = {"grip.rbt", "tools/cups.rbt"};
    if (path.ends_with("grip.rbt")) out = {.name = path, .text = "fn hold() => 1\n"};
    return out;
  };
  Session session(library_engine(), options);
  const auto analysis = session.analyse(program, "program.rbt");
  CHECK(offers(analysis->completion(8), "grip.rbt"));
  CHECK(offers(analysis->completion(8), "tools/cups.rbt"));
  const auto whole = session.analyse("import \"grip.rbt\"\n", "program.rbt");
  const auto hover = whole->hover(10);
  REQUIRE(hover.has_value());
  CHECK(hover->help.find("hold") != std::string::npos);
}

TEST_CASE("what stands at such a position is explained") {
  const auto at = [](const std::string& text, std::string_view word) {
    const auto hover =
        analysis_of(kDeclarations + text)
            ->hover(static_cast<std::uint32_t>(kDeclarations.size() + text.find(word) + 1));
    return hover ? hover->text + '\n' + hover->help : std::string();
  };
  CHECK(at("let x: angle = 3deg\n", "angle").find("deg") != std::string::npos);
  CHECK(at("let x: string = \"a\"\n", "string").starts_with("type string"));
  CHECK(at("with (track: \"slow\") { arm.moveJ(arm.home()) }\n", "slow").find("singularity") !=
        std::string::npos);
  CHECK(at("try { arm.home() } catch (e) { if (e.kind == \"Collision\") { print(1) } }\n",
           "Collision")
            .starts_with("kind \"Collision\""));
  CHECK(at("let x = 250mm/s\n", "250") == "speed\n250mm/s = 0.25 m/s");
  CHECK(at("let x = 180deg\n", "180") == "angle\n180deg = 3.14159265358979 rad");
  CHECK(at("let ages = {\"cup\": 3s}\nprint(ages[\"cup\"])\n", "\"cup\"]") ==
        "ages[\"cup\"]: time\n");
  CHECK(at("switch (state) {\n    case State.Done: print(1)\n}\n", "Done").find("State") !=
        std::string::npos);
}

TEST_CASE("where a value has to stand no words of statements and no types are offered") {
  for (const char* place : {"let x = |\n", "print(|)\n", "print(1 + |)\n", "fn f() => |\n"}) {
    CAPTURE(place);
    const Written written(place);
    CHECK(written.has("reach"));
    CHECK(written.has("true"));
    for (const char* other : {"case", "else", "while", "let", "System", "catch"})
      CHECK_FALSE_MESSAGE(written.has(other), other);
  }
}
