// armlet help: the help pages of the library.

#include <fmt/format.h>

#include <vector>

#include "armlet/core/similar.hpp"
#include "armlet/interpreter/reference.hpp"
#include "armlet/stdlib/install.hpp"
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

}  // namespace

int help(const std::string& name, bool markdown) {
  if (markdown) {
    print_out(kPreface);
    print_out(reference_markdown(library_engine()));
    return finish_output() ? kDone : kFailed;
  }
  if (name.empty()) return list_names();
  const std::string page = help_page(library_engine(), name);
  if (!page.empty()) {
    print_out(page);
    return finish_output() ? kDone : kFailed;
  }
  const std::vector<std::string> found = help_search(library_engine(), name);
  if (found.empty()) return not_found(name);
  for (const std::string& each : found) print_out(help_page(library_engine(), each));
  return finish_output() ? kDone : kFailed;
}

}  // namespace armlet::cli
