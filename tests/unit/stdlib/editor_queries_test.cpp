// What editors ask about the examples, against what the compiler made of them.

#include <doctest/doctest.h>

#include <random>

#include "editor/facts.hpp"
#include "editor_support.hpp"
#include "hir/walk.hpp"
#include "program/program.hpp"

using namespace armlet;
using namespace armlet::editor_test;

namespace {

// Every name of the main text in the typed tree of a compiled program.
class TypedNames {
 public:
  struct Variable {
    Span span;
    Span declared;
    const Type* type;
  };

  explicit TypedNames(const Program& program) : program_(program) {
    for (const lang::hir::Function* function : program.compiled().module.functions) {
      if (function->body != nullptr) walk(*function->body);
    }
  }
  std::vector<Variable> variables;
  std::vector<std::pair<Span, const NativeFunction*>> natives;

 private:
  void walk(const lang::hir::Stmt& stmt) {
    lang::for_each_child(
        stmt, [this](const lang::hir::Expr& e) { walk(e); },
        [this](const lang::hir::Stmt& s) { walk(s); });
  }
  void walk(const lang::hir::Expr& expr) {
    using lang::hir::ExprKind;
    const std::string_view text =
        expr.span.source == 0 ? program_.sources().slice(expr.span) : std::string_view();
    if (expr.kind == ExprKind::kVariable) {
      const auto& variable = *expr.as<lang::hir::VariableExpr>().variable;
      if (text == variable.name && !text.empty())
        variables.push_back({expr.span, variable.declared, variable.type});
    }
    if (expr.kind == ExprKind::kCallNative) {
      const auto& call = expr.as<lang::hir::CallNativeExpr>();
      // What happens at the begin and the end of a block is called by no name.
      if (call.function->event == BlockEvent::kNone && call.site.callee.source == 0 &&
          program_.sources().slice(call.site.callee) == call.function->name)
        natives.emplace_back(call.site.callee, call.function);
    }
    lang::for_each_operand(expr, [this](const lang::hir::Expr& e) { walk(e); });
  }

  const Program& program_;
};

// What a program prints; the message if it fails.
std::string output_of(const std::filesystem::path& path, const std::string& text) {
  std::string out;
  SessionOptions options = options_for(path);
  options.output = [&out](std::string_view piece) {
    out += piece;
    return std::string();
  };
  Session session(library_engine(), std::move(options));
  if (!session.compile(text, path.filename().string())) {
    for (const Problem& problem : session.problems())
      if (problem.diagnostic.severity == Severity::kError)
        return "rejected: " + problem.diagnostic.message;
  }
  const RunResult result = session.run();
  return out + (result.error ? result.error->code : "");
}

std::string edited(std::string text, std::vector<Edit> edits) {
  std::ranges::sort(edits, {}, [](const Edit& e) { return e.span.begin; });
  for (auto edit = edits.rbegin(); edit != edits.rend(); ++edit) {
    if (edit->span.source == 0)
      text.replace(edit->span.begin, edit->span.end - edit->span.begin, edit->text);
  }
  return text;
}

// What an analysis says of the byte that begins every ninth token, or every `step`th, as text.
std::string everything(const Analysis& analysis, std::size_t step = 9) {
  std::string out;
  for (const Diagnostic& diagnostic : analysis.diagnostics())
    out += diagnostic.code + diagnostic.message + std::to_string(diagnostic.mark.span.begin) + '\n';
  for (std::size_t i = 0; i < analysis.facts().tokens.size(); i += step) {
    const lang::Token& token = analysis.facts().tokens[i];
    const auto hover = analysis.hover(token.begin);
    out += hover ? hover->text + hover->help + hover->value : "-";
    const auto place = analysis.definition(token.begin);
    out += place ? std::to_string(place->begin) : "-";
    out += std::to_string(analysis.references(token.begin).size());
    out += std::to_string(analysis.completion(token.begin).items.size()) + '\n';
  }
  return out;
}

}  // namespace

TEST_CASE("names of every example mean what the compiler took them for") {
  std::size_t names = 0;
  for (const auto& path : programs_below("examples")) {
    const std::string text = read(path);
    Session session(library_engine(), options_for(path));
    if (!session.compile(text, path.filename().string())) continue;  // it needs files
    const auto analysis = session.analyse(text, path.filename().string());
    const TypedNames typed(*session.program());
    for (const auto& variable : typed.variables) {
      ++names;
      CAPTURE(path.filename().string());
      CAPTURE(std::string(analysis->sources().slice(variable.span)));
      // A row of a laboratory has two names: the block is found, the row is not.
      if (analysis->sources().slice(variable.span).find('.') != std::string_view::npos) continue;
      const auto declared = analysis->definition(variable.span.begin);
      REQUIRE(declared.has_value());
      CHECK(*declared == variable.declared);
      const auto hover = analysis->hover(variable.span.begin);
      REQUIRE(hover.has_value());
      CHECK(hover->span == variable.span);
    }
    for (const auto& native : typed.natives) {
      const Span callee = native.first;  // clang 14 refuses structured bindings in lambdas
      const auto* function = native.second;
      ++names;
      const auto* use = analysis->facts().native_at(callee.end - 1);
      CAPTURE(path.filename().string());
      CAPTURE(std::string(analysis->sources().slice(callee)));
      if (use == nullptr) {  // print, which the language understands itself
        const auto hover = analysis->hover(callee.end - 1);
        REQUIRE(hover.has_value());
        CHECK(hover->text.starts_with(function->name));
        continue;
      }
      CHECK(use->function->name == function->name);  // assertions are checked twice
    }
  }
  CHECK(names > 1000);
}

TEST_CASE("the messages are those of the compiler, also of broken texts") {
  int asked = 0;
  int same = 0;
  std::mt19937 random(7);
  for (const auto& path : programs_below("examples")) {
    const std::string whole = read(path);
    for (int i = 0; i < 6; ++i) {
      std::string text = whole;
      if (i > 0) text.erase(random() % text.size(), 1 + random() % 6);
      Session session(library_engine(), options_for(path));
      (void)session.compile(text, path.filename().string());
      std::vector<std::string> expected;
      std::vector<std::string> found;
      for (const Problem& problem : session.problems()) expected.push_back(problem.diagnostic.code);
      const auto analysis = session.analyse(text, path.filename().string());
      for (const Diagnostic& diagnostic : analysis->diagnostics()) found.push_back(diagnostic.code);
      // Explanations of habits of other languages try the text, which an analysis does not.
      same += found == expected ? 1 : 0;
      ++asked;
      CHECK(found.empty() == expected.empty());
    }
  }
  CHECK(same >= asked * 95 / 100);
}

TEST_CASE("an example with another name for one thing prints the same") {
  std::mt19937 random(3);
  int renamed = 0;
  for (const auto& path : programs_below("examples")) {
    const std::string text = read(path);
    Session session(library_engine(), options_for(path));
    const auto analysis = session.analyse(text, path.filename().string());
    std::vector<std::uint32_t> places;
    for (const lang::Reference& reference : analysis->facts().names.references) {
      const lang::Symbol& symbol = analysis->facts().names.symbols[reference.symbol];
      if (symbol.declared == reference.name && reference.name.source == 0 &&
          symbol.kind != NameKind::kModule)
        places.push_back(reference.name.begin);
    }
    if (places.empty()) continue;
    const std::string before = output_of(path, text);
    for (int i = 0; i < 2; ++i) {
      const std::uint32_t at = places[random() % places.size()];
      const lang::Symbol& symbol =
          analysis->facts().names.symbols[analysis->facts().reference_at(at)->symbol];
      // Names of the world and of records are part of what a program prints.
      const bool is_shown = symbol.type != nullptr && symbol.type->is(Kind::kHost);
      if (is_shown || symbol.kind == NameKind::kField || symbol.kind == NameKind::kStruct ||
          symbol.kind == NameKind::kEnum || symbol.kind == NameKind::kEnumValue)
        continue;
      const Renaming renaming = analysis->rename(at, "quiteAnother");
      CAPTURE(path.filename().string());
      CAPTURE(std::string(symbol.name));
      REQUIRE(renaming.why.empty());
      CHECK(output_of(path, edited(text, renaming.edits)) == before);
      ++renamed;
    }
  }
  CHECK(renamed > 20);
}

TEST_CASE("what is not read again makes no difference") {
  std::mt19937 random(11);
  for (const auto& path : programs_below("examples")) {
    std::string text = read(path);
    Session session(library_engine(), options_for(path));
    auto before = session.analyse(text, "p.rbt");
    static constexpr const char* kPieces[] = {"x",           "(",  ")",  "{", "}", "\n",
                                              "let a = 1\n", "/*", "\"", " ", ";", "// c\n"};
    for (int i = 0; i < 5; ++i) {
      const std::size_t at = random() % (text.size() + 1);
      if (i % 3 == 2) {
        text.erase(at, random() % 9);
      } else {
        text.insert(at, kPieces[random() % std::size(kPieces)]);
      }
      const auto now = session.analyse(text, "p.rbt", before);
      const auto afresh = session.analyse(text, "p.rbt");
      CAPTURE(text);
      CHECK(everything(*now) == everything(*afresh));
      before = now;
    }
  }
}

TEST_CASE("a statement is read again when a bracket elsewhere changes its tokens") {
  const std::pair<std::string, std::string> kTexts[] = {
      // A bracket that stays open: lines without indentation close the others, too.
      {"let a = 1\nlet b = [1,\n2]\nlet c = b\nlet d = ",
       "let a = 1\nlet b = [1,\n2]\nlet c = b\nlet d = ("},
      // What is put into a formatted text while a bracket is open is a mistake afterwards.
      {"let z = 0\nlet y = (\nlet x = 0\nlet b = f\"{1 +}\"\nlet c = 1\nlet d = 2\n",
       "let z = 0\nlet y = 3\nlet x = 0\nlet b = f\"{1 +}\"\nlet c = 1\nlet d = 2\n"}};
  Session session(library_engine(), {.default_world = table_world()});
  for (const auto& texts : kTexts) {
    const auto& first = texts.first;  // clang 14 refuses structured bindings in lambdas
    const auto& second = texts.second;
    CAPTURE(second);
    const auto there = session.analyse(second, "p.rbt", session.analyse(first, "p.rbt"));
    CHECK(everything(*there, 1) == everything(*session.analyse(second, "p.rbt"), 1));
    const auto back = session.analyse(first, "p.rbt", there);
    CHECK(everything(*back, 1) == everything(*session.analyse(first, "p.rbt"), 1));
  }
}

TEST_CASE("every position has a defined answer") {
  const std::string text =
      "// note\nlet gr\u00f6\u00dfe = 20mm  /* x */\nprint(\"\u00e4b\", f\"{gr\u00f6\u00dfe}\")\n";
  const auto analysis = analysis_of(text);
  for (std::uint32_t at = 0; at < text.size() + 20; ++at) {
    (void)analysis->hover(at);
    (void)analysis->completion(at);
    (void)analysis->references(at);
    (void)analysis->signature_help(at);
  }
  const auto at = static_cast<std::uint32_t>(text.find("gr"));
  CHECK(analysis->hover(at)->text == "gr\u00f6\u00dfe: length");
  CHECK(analysis->hover(at)->value == "20 mm");
  CHECK(analysis->references(at + 3).size() == 2);
  CHECK(analysis->completion(3).items.empty());
  CHECK_FALSE(analysis->hover(3).has_value());
}

static std::uint32_t end_of(const std::string& text) {
  return static_cast<std::uint32_t>(text.size());
}

TEST_CASE("between quotes the names of planners and of objects are offered") {
  const std::string planners = "moveJ(home(), traj: \"";
  CHECK(offers(analysis_of(planners)->completion(end_of(planners)), "Spline5"));
  for (const std::string& trajectory :
       {std::string("trajectory(\""), std::string("robots.scara().trajectory(\""),
        std::string("trajectory(name: \""), std::string("let tr = trajectory(robots.scara(), \"")})
    CHECK(offers(analysis_of(trajectory)->completion(end_of(trajectory)), "Spline5"));
  const std::string objects = "insertObj(\"\")";
  CHECK(offers(analysis_of(objects)->completion(11), "cube"));
}

TEST_CASE("settings, fitting values, overloads") {
  const std::string call = "let v = 100mm/s\nlet t = 2s\nmoveL(xyz(1mm, 2mm, 3mm), speed: ";
  const auto analysis = analysis_of(call);
  const Completions list = analysis->completion(end_of(call));
  REQUIRE_FALSE(list.items.empty());
  CHECK(list.items[0].text == "v");
  const auto help = analysis->signature_help(end_of(call));
  REQUIRE(help.has_value());
  REQUIRE(help->parameter >= 0);
  const auto& overload = help->overloads[help->active];
  const auto [begin, end] = overload.parameters[static_cast<std::size_t>(help->parameter)];
  CHECK(overload.text.substr(begin, end - begin) == "speed: speed?");
  const std::string half = "moveL(xyz(1mm, 2mm, 3mm), ";
  CHECK(offers(analysis_of(half)->completion(end_of(half)), "blend"));
}

TEST_CASE("a name is not given where it would mean something else") {
  const auto analysis = analysis_of("let a = 1\nlet b = a\nprint(b)\n");
  CHECK(analysis->rename(4, "b").why == "`b` is declared already, on line 2");
  CHECK(analysis->rename(4, "sin").why == "`sin` is a name of the library");
  CHECK(analysis->rename(4, "for").why == "`for` cannot be a name");
  CHECK(analysis->rename(4, "c").edits.size() == 2);
  CHECK_FALSE(analysis->rename(26, "c").edits.empty());
  CHECK_FALSE(analysis_of("let a = )\nprint(a)")->rename(4, "c").why.empty());
}

TEST_CASE("types of variables are shown where none is written") {
  const auto hints = analysis_of("let a = 20mm\nlet b: int = 2\nvar c = [1.0]\n")->inlay_hints();
  REQUIRE(hints.size() == 2);
  CHECK(hints[0].text == ": length");
  CHECK(hints[0].position == 5);
  CHECK(hints[1].text == ": double[]");
}

// What stands at the first letter of a name in a text that ends there.
static std::string type_in(const std::string& text, const std::string& name) {
  const auto hover = analysis_of(text)->hover(static_cast<std::uint32_t>(text.find(name)));
  return hover ? hover->text : "";
}

TEST_CASE("what a text does not say yet has the type that it most likely gets") {
  // Incomplete calls.
  CHECK(type_in("let p = xyz(1mm, ", "p") == "p: posC");
  CHECK(type_in("fn at(i: int, up: length) -> posC { return xyz(z: up) }\nlet p = at(1, ", "p =") ==
        "p: posC");
  CHECK(type_in("struct Slot { row: int, gap: length }\nlet s = Slot(row: ", "s =") == "s: Slot");
  CHECK(type_in("let size = max(2mm, ", "size") == "size: length");
  CHECK(type_in("let ys = [1, 2].map(fn(x) => 1mm * ", "x)") == "x: int");
  CHECK(type_in("let y = [1mm, 2mm].fold(0mm, fn(a, b) => a + ", "b)") == "b: length");
  // Sums, comparisons, lists and choices.
  CHECK(type_in("let gap = 2mm\nlet sum = gap + ", "sum") == "sum: length");
  CHECK(type_in("let gap = 2mm\nlet far = gap > ", "far") == "far: bool");
  CHECK(type_in("let gaps = [2mm, ", "gaps") == "gaps: length[]");
  CHECK(type_in("let gap = true ? 2mm : ", "gap") == "gap: length");
  CHECK(type_in("let gap = 2mm\nlet area = gap * ", "area") == "area");  // it may be anything
}

TEST_CASE("functions without types of parameters are looked into before anybody calls them") {
  const std::string body = "fn mean(xs, unit) {\n  let n = 2mm\n  let m = n\n  return xs[0] + ";
  CHECK(type_in(body, "n = 2mm") == "n: length");
  CHECK(analysis_of(body)->references(static_cast<std::uint32_t>(body.find("xs"))).size() == 2);
  const std::string whole = body + "n\n}\n";
  CHECK(type_in(whole, "n = 2mm") == "n: length");
  CHECK(analysis_of(whole)->diagnostics().empty());  // nobody has called it wrongly
  CHECK(type_in(whole + "print(mean([1mm], 2))\n", "xs") == "xs: length[]");
}

TEST_CASE("what stands beside a mistake keeps its meaning") {
  const auto uses = [](const std::string& text, const std::string& name) {
    return analysis_of(text)->references(static_cast<std::uint32_t>(text.find(name))).size();
  };
  CHECK(uses("let gap = 2mm\nlet A = [1, 2; 3, 4]\nlet b = A[gap, ", "gap") == 2);
  CHECK(uses("let gap = 2mm\nlet xs = [nothing, gap]\nlet ys = [gap, gap]\n", "gap") == 4);
  CHECK(uses("let gap = 2mm\nnothing.at(gap).up(gap, fn(x) => x + gap)\n", "gap") == 4);
  CHECK(uses("let gap = 2mm\nvar xs = [1]\nxs.nothing[gap] = gap\n", "gap") == 3);
  CHECK(uses("fn slot(i: int) => 2 * i\nlet n = 3\nlet m = n.slot", "slot") == 2);
}

TEST_CASE("a loop is there as soon as its variable is") {
  for (const char* text : {"for (k in range(3", "for (k in range(3))", "for (k in range(3)) ",
                           "if (true) { for (k in range(3)) "}) {
    CAPTURE(text);
    CHECK(type_in(text, "k") == "k: int");
  }
}

TEST_CASE("files that a text imports are known while its brackets are open") {
  Session session(
      library_engine(),
      {.default_world = table_world(), .load = [](const std::string& path, const std::string&) {
         return ImportedText{.name = path,
                             .text =
                                 "struct Pallet { rows: int }\n"
                                 "fn slot(p: Pallet) => xyz(1mm * p.rows)\n"};
       }});
  const std::string text =
      "import \"pallets.rbt\" as pal\nlet tray = pal.Pallet(rows: 3)\n"
      "let at = tray.slot()\nfor (i in range(tray.";
  const auto analysis = session.analyse(text, "p.rbt");
  CHECK(analysis->hover(static_cast<std::uint32_t>(text.find("tray")))->text == "tray: Pallet");
  CHECK(analysis->hover(static_cast<std::uint32_t>(text.find("at =")))->text == "at: posC");
  CHECK(offers(analysis->completion(end_of(text)), "rows"));
}

TEST_CASE("in the value of a function without a block its parameters are offered") {
  const std::string text = "let takes = [1, 2].map(fn(entry) => ";
  CHECK(offers(analysis_of(text)->completion(end_of(text)), "entry"));
}

TEST_CASE("texts that no program is do no harm") {
  for (const auto& path : programs_below("tests/fuzz/corpus")) {
    const std::string text = read(path);
    const auto analysis = analysis_of(text);
    for (std::uint32_t at = 0; at < text.size(); at += 37) {
      (void)analysis->completion(at);
      (void)analysis->hover(at);
    }
  }
  for (const std::string& text :
       {std::string(20'000, '('), std::string(20'000, '{'), std::string("\xff\xfe"),
        std::string(3000, '.'), std::string(3000, '"'), std::string("f\"{{{{a.")})
    (void)analysis_of(text)->completion(static_cast<std::uint32_t>(text.size()));
}

TEST_CASE("an analysis can be cancelled") {
  const std::atomic<bool> cancelled{true};
  CompileOptions options;
  options.cancelled = &cancelled;
  const auto analysis = library_engine().analyse("let a = 1", "p.rbt", options);
  CHECK(analysis->was_cancelled());
  CHECK(analysis->diagnostics().at(0).code == "R0629");
  CHECK(analysis->completion(3).items.empty());
  CHECK_FALSE(analysis->hover(4).has_value());
}
