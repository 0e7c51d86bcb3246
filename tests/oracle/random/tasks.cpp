// What runs at the same time: branches, watches, waiting, and errors in the middle of it.

#include <utility>

#include "random/program.hpp"

namespace armlet::oracle {

// What tasks may not do: leave the loop or function around them.
void RandomProgram::task_body(int count) {
  const Ty* const result = std::exchange(result_, nullptr);
  const int loops = std::exchange(loops_, 0);
  const std::size_t vars = vars_.size();
  for (int i = 0; i < count; ++i) {
    if (one_in(2)) waiting();
    statement();
  }
  if (one_in(3)) waiting();
  leaving();
  vars_.resize(vars);
  loops_ = loops;
  result_ = result;
}

std::string RandomProgram::milliseconds(std::size_t most) {
  if (one_in(8)) return "0.0004s";
  return std::to_string(1 + below(most)) + "ms";
}

// Conditions do not wait, so they call nothing that might.
std::string RandomProgram::condition() {
  const int calls = std::exchange(calls_left_, 0);
  const std::vector<Recent> recent = std::exchange(recent_, {});
  std::string out = truth(1);
  if (one_in(3)) out = "now() >= " + milliseconds(20);
  if (one_in(3)) out = "counter % 3 == " + std::to_string(below(3));
  calls_left_ = calls;
  recent_ = recent;
  return one_in(2) ? "looked(" + out + ")" : out;
}

void RandomProgram::waiting() {
  if (!one_in(3)) return line("wait(" + (one_in(6) ? "0s" : milliseconds(5)) + ")");
  const std::string text = "wait until " + condition() + ", timeout: " + milliseconds(6);
  if (one_in(3)) return line(text);
  const std::string error = fresh();
  line("try { " + text + " } catch (" + error + ") { print(" + error + ".kind, " + error +
       ".message, " + error + ".time) }");
}

void RandomProgram::branches() {
  open("parallel");
  const std::size_t count = below(4);
  for (std::size_t i = 0; i < count; ++i) {
    if (one_in(5)) {
      line(one_in(2) ? "counter += 1" : "print(\"branch\", now())");
      continue;
    }
    open("");
    task_body(1 + static_cast<int>(below(2)));
    close();
  }
  if (one_in(4)) watch();
  close();
}

void RandomProgram::watch() {
  open(one_in(2) ? "when (" + condition() + ")" : "every (" + milliseconds(4) + ")");
  task_body(1);
  close();
}

// A block of its own, or the rest of the one that is open.
void RandomProgram::watching() {
  const bool has_block = !one_in(4);
  if (has_block) open("");
  watch();
  if (one_in(3)) watch();
  if (one_in(2)) waiting();
  body(1);
  if (!one_in(4)) waiting();
  leaving();
  if (has_block) close();
}

void RandomProgram::concurrent() {
  --tasks_left_;
  switch (below(3)) {
    case 0:
      return branches();
    case 1:
      return watching();
    default:
      // Cleaning up takes time too.
      open("try");
      branches();
      close(" finally {");
      line("wait(" + milliseconds(3) + ")");
      line("print(\"cleaned up\", now())");
      close();
  }
}

}  // namespace armlet::oracle
