// The commands of the prompt, one row each.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

#include "armlet/core/files.hpp"
#include "armlet/core/format.hpp"
#include "armlet/core/similar.hpp"
#include "armlet/interpreter/editor/analysis.hpp"
#include "armlet/interpreter/unit.hpp"
#include "armlet/plot/braille.hpp"
#include "armlet/stdlib/install.hpp"
#include "armlet/stdlib/robot_text.hpp"
#include "prompt/prompt.hpp"

namespace armlet::cli {
namespace {

struct PromptCommand {
  std::string_view name;
  std::string_view argument;  // as help shows it; in brackets if it may be left out
  std::string_view help;
  bool (*run)(Prompt& prompt, std::string_view argument);
};

bool refuse(std::string_view why) {
  progress(why);
  return false;
}

void say(std::string_view text) {
  print_out(text);
  if (!text.ends_with('\n')) print_out("\n");
  static_cast<void>(finish_output());
}

// ---- what there is ------------------------------------------------------------------------------

bool show_type(Prompt& prompt, std::string_view expression) {
  const std::string text = fmt::format("let it = ({})", expression);
  const auto analysis = prompt.session().analyse(text, "line");
  bool wrong = false;
  for (const Diagnostic& d : analysis->diagnostics()) {
    if (!d.is_error()) continue;
    show(d, analysis->sources(), false);
    wrong = true;
  }
  const std::vector<InlayHint> hints = analysis->inlay_hints();
  if (wrong || hints.empty()) return !wrong && refuse("that has no value");
  say(hints.front().text.substr(2));
  return true;
}

bool list_names(Prompt& prompt, std::string_view) {
  const auto analysis = prompt.session().analyse("", "line");
  std::size_t shown = 0;
  for (const Completion& item : analysis->completion(0).items) {
    if (item.kind == NameKind::kLibraryFunction || item.kind == NameKind::kWord ||
        item.kind == NameKind::kConstant || item.kind == NameKind::kType || item.kind == NameKind::kText)
      continue;
    print_out(fmt::format("{:<20} {}\n", item.text, item.detail));
    ++shown;
  }
  say(shown == 0 ? "no names have been declared" : "");
  return true;
}

bool list_robots(Prompt& prompt, std::string_view) {
  const Cell& cell = prompt.host().cell();
  for (int i = 0; i < cell.robot_count(); ++i) print_out(robot_table(*cell.robot(i).model, cell.robot(i).name));
  if (cell.robot_count() == 0) {
    const Robot* model = prompt.host().default_robot_model();
    print_out(model == nullptr ? "no robot\n" : robot_table(*model));
  }
  say("");
  return true;
}

bool list_objects(Prompt& prompt, std::string_view) {
  const World& world = prompt.host().cell().world();
  for (std::size_t i = 0; i < world.size(); ++i) {
    const Object& object = world.object(i);
    std::string where = world.resting_on(object.name);
    if (const auto& held = world.attachment(object.name); held && held->on.empty()) {
      where = fmt::format("held by {}", prompt.host().cell().robot(held->carrier).name);
    } else if (!where.empty()) {
      where = "on " + where;
    }
    print_out(fmt::format("{:<16} {}{}{}\n", object.name, format_point_mm(object.T_world_obj.translation()),
                          where.empty() ? "" : "   ", where));
  }
  say(world.size() == 0 ? "no objects; a line that names one of the table's fetches the table" : "");
  return true;
}

bool show_where(Prompt& prompt, std::string_view) {
  const Cell& cell = prompt.host().cell();
  say(prompt.time());
  if (cell.robot_count() == 0) say("no robot has been used yet");
  for (int i = 0; i < cell.robot_count(); ++i) {
    const CellRobot& robot = cell.robot(i);
    say(fmt::format("{}  joints {}\n  hand at {}{}", robot.name, joints_text(robot),
                    format_pose(cell.T_world_tool(i)),
                    robot.held.empty() ? std::string() : "\n  holds " + robot.held));
  }
  return true;
}

// Units that are written often, besides the simple ones.
constexpr std::array<std::string_view, 12> kCombined{"mm/s",   "m/s",   "deg/s", "rad/s", "mm/s^2", "m/s^2",
                                                     "deg/s^2", "rad/s^2", "mm^2", "m^2",   "N/mm",  "kg*m^2"};

bool show_units(Prompt& prompt, std::string_view expression) {
  Session& session = prompt.session();
  std::string line;
  const auto try_unit = [&](std::string_view unit) {
    const std::string shown = fmt::format("{{({}):{}}}", expression, unit);
    if (session.submit(fmt::format("print(f\"{}\")", shown), "line"))
      line += (line.empty() ? "" : "   ") + shown;
  };
  for (const Unit& unit : all_units()) try_unit(unit.name);
  for (const std::string_view unit : kCombined) try_unit(unit);
  if (line.empty()) return show_type(prompt, expression) && refuse("that is no quantity with a unit");
  return prompt.enter_aside(fmt::format("print(f\"{}\")", line));
}

bool show_steps(Prompt& prompt, std::string_view robot) {
  return prompt.enter_aside(robot.empty() ? std::string("explain()") : fmt::format("{}.explain()", robot));
}

bool plot_figures(Prompt& prompt, std::string_view) {
  const std::vector<Figure>& figures = prompt.host().figures();
  if (figures.empty()) return refuse("there is no figure; plot(...) draws one");
  say(to_braille(figures.back(), 72, 18, false));
  return true;
}

bool explain_code(Prompt&, std::string_view code) { return explain(std::string(code)) == kDone; }

// ---- back and forth -------------------------------------------------------------------------------

// A number from 1 on; nothing after a message.
std::optional<std::size_t> count_of(std::string_view text) {
  std::size_t count = 1;
  if (text.empty()) return count;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (error == std::errc() && end == text.data() + text.size() && count > 0) return count;
  progress(fmt::format("\"{}\" is not a number of lines; write for example :undo 2", text));
  return std::nullopt;
}

// What the entries from `first` on were, in one line each.
std::string first_lines(std::span<const Entry> entries) {
  std::string out;
  for (const Entry& entry : entries) out += "  " + entry.text.substr(0, entry.text.find('\n')) + "\n";
  return out;
}

bool undo(Prompt& prompt, std::string_view argument) {
  const auto count = count_of(argument);
  if (!count) return false;
  const std::vector<Entry> entries = prompt.session().entries();
  const std::size_t undone = prompt.session().undo(*count);
  if (undone == 0) return refuse("there is nothing to undo");
  say(fmt::format("{}, robots, objects and names as before\n{}", prompt.time(),
                  first_lines(std::span(entries).last(undone))));
  return true;
}

bool redo(Prompt& prompt, std::string_view argument) {
  const auto count = count_of(argument);
  if (!count) return false;
  const std::size_t done = prompt.session().redo(*count);
  if (done == 0) return refuse("there is nothing to do again");
  say(fmt::format("{}, done again\n{}", prompt.time(),
                  first_lines(std::span(prompt.session().entries()).last(done))));
  return true;
}

bool reset(Prompt& prompt, std::string_view) {
  prompt.session().undo(prompt.session().entries().size());
  say(prompt.time() + ", everything as at the start; :redo brings lines back");
  return true;
}

bool set_speed(Prompt& prompt, std::string_view argument) {
  if (argument == "max") {
    prompt.pace().set(0.0);
    say("moves are computed as fast as possible");
    return true;
  }
  if (argument.ends_with('x')) argument.remove_suffix(1);
  double factor = 0.0;
  const auto [end, error] = std::from_chars(argument.data(), argument.data() + argument.size(), factor);
  if (error != std::errc() || end != argument.data() + argument.size() || !(factor >= 0.01) || factor > 1000.0)
    return refuse("write :speed 1x for the speed of the clock, from 0.01x to 1000x, or :speed max");
  prompt.pace().set(factor);
  say(fmt::format("moves take {} of their time", factor == 1.0 ? "all" : fmt::format("1/{:g}", factor)));
  return true;
}

// ---- files ------------------------------------------------------------------------------------------

bool save(Prompt& prompt, std::string_view path) {
  if (!path.ends_with(".rbt")) return refuse("a program is a .rbt file: write :save NAME.rbt");
  Result<NewFile> made = create_file(std::string(path));
  if (!made.ok()) return refuse(fmt::format("{} cannot be written: {}", path, made.error().message));
  NewFile file = std::move(made).value();
  file.write(prompt.program());
  if (const auto error = file.finish())
    return refuse(fmt::format("{} cannot be written: {}", path, error->message));
  say(fmt::format("saved in {}", path));
  return true;
}

bool load(Prompt& prompt, std::string_view path) {
  const auto text = read_file(std::string(path), false);
  return text && prompt.enter(*text);
}

bool quit(Prompt& prompt, std::string_view) {
  prompt.quit();
  return true;
}

bool show_commands(Prompt& prompt, std::string_view);

constexpr PromptCommand kCommands[] = {
    {"?", "NAME", "what a function, a setting or a word does, with an example",
     [](Prompt&, std::string_view name) { return help(std::string(name), false) == kDone; }},
    {"??", "WORD", "the pages that mention a word", nullptr},
    {":help", "", "these commands", show_commands},
    {":type", "EXPRESSION", "the type of a value, which is not computed", show_type},
    {":units", "EXPRESSION", "a quantity in every unit that fits", show_units},
    {":names", "", "what has been declared, with types", list_names},
    {":robots", "", "the table of each robot", list_robots},
    {":objects", "", "where each object is", list_objects},
    {":where", "", "time, joints, hand and what it holds", show_where},
    {":steps", "[ROBOT]", "how the last move was planned", show_steps},
    {":plot", "", "the last figure, drawn here", plot_figures},
    {":explain", "CODE", "what a message means, for example :explain E0401", explain_code},
    {":undo", "[N]", "back to before the last line, or the last N", undo},
    {":redo", "[N]", "what was undone, again", redo},
    {":reset", "", "back to the start", reset},
    {":speed", "1x|max", "show moves at the speed of the clock, or compute them at once", set_speed},
    {":save", "FILE.rbt", "the lines so far as a program", save},
    {":load", "FILE.rbt", "run a file as if it were typed here", load},
    {":quit", "", "end, like Ctrl-D", quit},
};

bool show_commands(Prompt&, std::string_view) {
  for (const PromptCommand& command : kCommands) {
    print_out(fmt::format("{:<10} {:<12} {}\n", command.name, command.argument, command.help));
  }
  say("Tab completes, the arrow keys fetch earlier lines, Ctrl-C stops. A semicolon hides a value.");
  return true;
}

bool search_pages(std::string_view word) {
  const std::vector<std::string> found = help_search(library_engine(), word);
  if (found.empty()) return refuse(fmt::format("no page mentions \"{}\"", word));
  for (const std::string& name : found) {
    const std::string page = help_page(library_engine(), name);
    print_out(page.substr(0, page.find('\n')) + "\n");
  }
  say("");
  return true;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

}  // namespace

bool is_command(std::string_view line) {
  line = trimmed(line);
  return line.starts_with('?') || (line.starts_with(':') && line.size() > 1 && std::isalpha(static_cast<unsigned char>(line[1])) != 0);
}

std::vector<std::string> commands_with(std::string_view start) {
  std::vector<std::string> out;
  for (const PromptCommand& command : kCommands) {
    if (command.name.starts_with(start)) out.emplace_back(command.name);
  }
  return out;
}

bool run_command(Prompt& prompt, std::string_view line) {
  line = trimmed(line);
  if (line.starts_with("??")) return search_pages(trimmed(line.substr(2)));
  if (line == "?") return show_commands(prompt, {});
  if (line.starts_with('?')) return help(std::string(trimmed(line.substr(1))), false) == kDone;
  const std::size_t space = line.find(' ');
  const std::string_view name = line.substr(0, space);
  const std::string_view argument = space == std::string_view::npos ? "" : trimmed(line.substr(space));
  const auto* known = std::ranges::find(kCommands, name, &PromptCommand::name);
  if (known == std::end(kCommands)) {
    std::vector<std::string_view> names;
    for (const PromptCommand& command : kCommands) names.push_back(command.name);
    const auto meant = most_similar(name, names);
    return refuse(fmt::format("there is no command {}{}; :help lists all", name,
                              meant ? fmt::format("; did you mean {}?", *meant) : std::string()));
  }
  if (!known->argument.empty() && !known->argument.starts_with('[') && argument.empty())
    return refuse(fmt::format("write {} {}: {}", known->name, known->argument, known->help));
  if (known->argument.empty() && !argument.empty())
    return refuse(fmt::format("{} takes nothing more: {}", known->name, known->help));
  return known->run(prompt, argument);
}

}  // namespace armlet::cli
