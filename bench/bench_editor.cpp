// The response times of an editor: analysis of a program of 1,000 lines after a key stroke, a
// completion list with 1,000 names in scope, and single queries.

#include <cstdio>
#include <string>

#include "armlet/interpreter/editor/analysis.hpp"
#include "armlet/stdlib/install.hpp"
#include "bench.hpp"

namespace {

using namespace armlet;
using namespace armlet::bench;

// One station of a cell: a struct, two functions, variables, a loop. 26 lines.
std::string station(int i) {
  const std::string n = std::to_string(i);
  return "// Station " + n + ": where parts lie and how they are taken.\nstruct Slot" + n +
         " { row: int = 0, height: length = 20mm, weight: mass = 0.5kg }\n"
         "/// The place of part k.\nfn place" +
         n +
         "(k: int, gap: length = 30mm) -> posC {\n  let x = 250mm + gap * (k % 4)\n"
         "  let y = -60mm + gap * (k / 4)\n  return xyz(x, y, 40mm)\n}\nfn mean" +
         n +
         "(xs: double[]) {\n  var total = 0.0\n  for (x in xs) { total += x }\n"
         "  return total / max(xs.length, 1)\n}\nlet count" +
         n + " = 5\nvar done" + n + ": int = 0\nlet heights" + n +
         " = [20mm, 30mm, 40mm, 55mm]\nfor (k in range(count" + n + ")) {\n  let p = place" + n +
         "(k, gap: 25mm)\n  let slot = Slot" + n + "(row: k / 4, height: heights" + n +
         "[k % 4])\n"
         "  if (slot.height > 25mm && k % 2 == 0) {\n"
         "    print(f\"part {k} at {p.x:.1f mm} height {slot.height}\")\n    done" +
         n + " += 1\n  }\n}\nlet average" + n + " = mean" + n + "([1.0, 2.5, done" + n +
         " * 0.5])\nprint(average" + n + ", sin(30deg))\n";
}

void report(const char* what, double ns) { std::printf("%-58s %10.3f ms\n", what, ns / 1e6); }

}  // namespace

int main() {
  const Engine& engine = library_engine();
  std::string text;
  for (int i = 0; i < 39; ++i) text += station(i);  // 1,014 lines
  const std::string key = "let extra = average3 + count7";
  const std::string typed = text + key;
  const auto before = engine.analyse(text, "bench.rbt");
  std::printf("%zu bytes, %d lines\n", text.size(), before->sources()[0].line_count());
  const auto measure = [](const char* what, int calls, auto work) {
    std::vector<double> rounds;
    for (int round = 0; round < 11; ++round) rounds.push_back(nanoseconds_per_call(calls, work));
    report(what, median(rounds));
  };
  measure("analysed afresh", 3, [&](int) {
    return static_cast<double>(engine.analyse(typed, "bench.rbt")->diagnostics().size());
  });
  measure("analysed again, a statement typed at the end", 3, [&](int) {
    return static_cast<double>(
        engine.analyse(typed, "bench.rbt", {}, before)->diagnostics().size());
  });
  std::string broken = text;
  broken.insert(text.find("let count20"), "let half = max(count3, ");
  measure("analysed again, a call begun in the middle", 3, [&](int) {
    return static_cast<double>(
        engine.analyse(broken, "bench.rbt", {}, before)->diagnostics().size());
  });
  std::string names;
  for (int i = 0; i < 1000; ++i)
    names += "let name" + std::to_string(i) + " = " + std::to_string(i) + "\n";
  const auto many = engine.analyse(names, "names.rbt");
  const auto end = static_cast<std::uint32_t>(names.size());
  measure("completion list with 1,000 names in scope", 10,
          [&](int) { return static_cast<double>(many->completion(end).items.size()); });
  const auto name = static_cast<std::uint32_t>(text.rfind("count38"));
  measure("hover", 1000, [&](int) { return before->hover(name)->text.empty() ? 0.0 : 1.0; });
  measure("definition", 1000,
          [&](int) { return static_cast<double>(before->definition(name)->begin); });
  measure("references", 1000,
          [&](int) { return static_cast<double>(before->references(name).size()); });
}
