// armlet help: the help pages of the library.

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "armlet/core/similar.hpp"
#include "armlet/interpreter/reference.hpp"
#include "armlet/stdlib/help_topics.hpp"
#include "armlet/stdlib/install.hpp"
#include "commands.hpp"
#include "console/console.hpp"

namespace armlet::cli {
namespace {

constexpr std::string_view kPreface =
    "# The library\n\n"
    "Written by `armlet help --markdown` from the tables that the checker reads; the tests compare "
    "and run every\n"
    "example. `armlet help moveL` shows one page, `armlet help torque` finds pages by a word.\n\n"
    "In a signature, `name: type` is a parameter, `name: type = value` one that may be left out "
    "and then has that\n"
    "value, `name: type?` one that may be left out. `D` and `E` stand for a quantity or a "
    "`double`, `T` and `U` for any\n"
    "type. A first parameter `r: robot` may be left out when it is clear which robot is meant. "
    "`f(x, y)` may be\n"
    "written `x.f(y)`.\n";

int list_names() {
  std::string line;
  for (const std::string& name : help_names(library_engine())) {
    if (line.size() + name.size() + 2 > 96) {
      print_out(line + "\n");
      line.clear();
    }
    line += line.empty() ? name : "  " + name;
  }
  print_out(line + "\n");
  return finish_output() ? kDone : kFailed;
}

int not_found(const std::string& name) {
  const std::vector<std::string> names = help_names(library_engine());
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  std::string message = fmt::format("armlet: there is no page about {}", name);
  const auto meant = most_similar(name, candidates);
  if (meant) message += fmt::format("; did you mean {}", *meant);
  progress(message + (meant ? "?" : ".") + " `armlet help` lists all of them.");
  return kUsage;
}

// The first sentence beside the name, cut at the width of a line.
void print_line(const HelpLine& line) {
  constexpr std::size_t kWidth = 100;
  std::string text = fmt::format("{:<18} {}", line.name, line.sentence);
  if (text.size() > kWidth) text = text.substr(0, text.rfind(' ', kWidth - 4)) + " ...";
  print_out(text + "\n");
}

// Lines of names, filled.
void print_names(std::string line, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (line.size() + name.size() + 2 > 96) {
      print_out(line + "\n");
      line = "   ";
    }
    line += " " + name + (&name == &names.back() ? "" : ",");
  }
  print_out(line + "\n");
}

// What is known about words without a page of their own; false: nothing.
bool print_found(const HelpQuestion& asked) {
  const std::size_t most = asked.whole ? std::string::npos : asked.is_search ? 25 : 8;
  const HelpFound found = help_about(library_engine(), asked.name, help_topics());
  if (found.pages.empty() && !found.is_setting) return false;
  if (found.is_setting) print_names(fmt::format("{} is a setting of", asked.name), found.settings);
  const std::size_t shown = std::min(most, found.pages.size());
  for (std::size_t i = 0; i < shown; ++i) print_line(found.pages[i]);
  if (shown < found.pages.size()) {
    const std::string all = asked.at_prompt ? fmt::format("??{} all", asked.name)
                                            : fmt::format("armlet help \"{}\" --all", asked.name);
    print_out(fmt::format("{} more: {}\n", found.pages.size() - shown, all));
  }
  return true;
}

}  // namespace

int help(const HelpQuestion& asked) {
  if (asked.markdown) {
    print_out(kPreface);
    print_out(reference_markdown(library_engine()));
    return finish_output() ? kDone : kFailed;
  }
  if (asked.name.empty()) return list_names();
  ShortPage page;
  if (!asked.is_search) {
    if (asked.whole) {
      page.text = help_page(library_engine(), asked.name);
    } else {
      page = short_help_page(library_engine(), asked.name);
    }
  }
  if (page.text.empty() && !print_found(asked)) return not_found(asked.name);
  print_out(page.text);
  if (page.left_out > 0) {
    const std::string all = asked.at_prompt ? fmt::format("?{} all", asked.name)
                                            : fmt::format("armlet help \"{}\" --all", asked.name);
    print_out(fmt::format("  {} more forms: {}\n", page.left_out, all));
  }
  return finish_output() ? kDone : kFailed;
}

}  // namespace armlet::cli
