// The commands of the prompt, one row each.

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

#include "armlet/core/error.hpp"
#include "armlet/core/files.hpp"
#include "armlet/core/similar.hpp"
#include "armlet/interpreter/editor/analysis.hpp"
#include "armlet/interpreter/host/globals.hpp"
#include "armlet/interpreter/reference.hpp"
#include "armlet/interpreter/unit.hpp"
#include "armlet/math/format_vector.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/plot/braille.hpp"
#include "armlet/stdlib/install.hpp"
#include "armlet/stdlib/robot_text.hpp"
#include "console/setup.hpp"
#include "prompt/prompt.hpp"
#include "prompt/questions.hpp"

namespace armlet::cli {
namespace {

struct PromptCommand {
  std::string_view name;
  std::string_view argument;  // as help shows it; in brackets if it is optional
  std::string_view help;
  bool (*run)(Prompt& prompt, std::string_view argument);
};

bool refuse(std::string_view why) {
  progress(why);
  return false;
}

// ---- information --------------------------------------------------------------------------------

bool show_errors(const Analysis& analysis) {
  bool any = false;
  for (const Diagnostic& d : analysis.diagnostics()) {
    if (d.severity != Severity::kError) continue;
    show(d, analysis.sources(), false);
    any = true;
  }
  return any;
}

bool show_type(Prompt& prompt, std::string_view expression) {
  if (show_errors(*prompt.session().analyse(std::string(expression), ":type"))) return false;
  const auto analysis = prompt.session().analyse(fmt::format("let it = {}", expression), ":type");
  const std::vector<InlayHint> hints = analysis->inlay_hints();
  if (hints.size() != 1 || !analysis->diagnostics().empty()) return refuse("that is no value");
  say(hints.front().text.substr(2));
  return true;
}

bool list_names(Prompt& prompt, std::string_view) {
  const auto analysis = prompt.session().analyse("", "line");
  std::size_t shown = 0;
  for (const Completion& item : analysis->completion(0).items) {
    if (item.kind == NameKind::kLibraryFunction || item.kind == NameKind::kWord ||
        item.kind == NameKind::kConstant || item.kind == NameKind::kType ||
        item.kind == NameKind::kText || item.detail.empty())
      continue;
    say(fmt::format("{:<20} {}", item.text, item.detail));
    ++shown;
  }
  if (shown == 0) say("no names have been declared");
  return true;
}

bool list_robots(Prompt& prompt, std::string_view) {
  const Cell& cell = prompt.host().cell();
  for (int i = 0; i < cell.robot_count(); ++i)
    say(robot_table(*cell.robot(i).model, cell.robot(i).name));
  const Robot* model = prompt.host().default_robot_model().get();
  if (cell.robot_count() == 0) say(model == nullptr ? "no robot" : robot_table(*model));
  return true;
}

bool list_objects(Prompt& prompt, std::string_view) {
  const Cell& cell = prompt.host().cell();
  const World& world = cell.world();
  for (std::size_t i = 0; i < world.size(); ++i) {
    const Object& object = world.object(i);
    const std::string where = place_text(cell, object.name);
    say(fmt::format("{:<16} {}{}{}", object.name, format_point_mm(object.T_world_obj.translation()),
                    where.empty() ? "" : "   ", where));
  }
  if (world.size() == 0) say("no objects yet: a line that names one of the world fetches them all");
  return true;
}

bool show_where(Prompt& prompt, std::string_view) {
  const Cell& cell = prompt.host().cell();
  say(prompt.time());
  const Robot* model = prompt.host().default_robot_model().get();
  if (cell.robot_count() == 0 && model != nullptr)
    say(fmt::format("{} waits at its home; the first line that asks for it brings it in",
                    model->name()));
  for (int i = 0; i < cell.robot_count(); ++i) {
    const CellRobot& robot = cell.robot(i);
    say(fmt::format("{}  joints {}\n  hand at {}{}", robot.name, joints_text(robot),
                    format_pose(cell.T_world_tool(i)),
                    robot.held.empty() ? std::string() : "\n  holds " + robot.held));
  }
  return true;
}

// Compound units that are used often, besides the simple ones.
constexpr std::array<std::string_view, 12> kCombined{"mm/s",   "m/s",   "deg/s",   "rad/s",
                                                     "mm/s^2", "m/s^2", "deg/s^2", "rad/s^2",
                                                     "mm^2",   "m^2",   "N/mm",    "kg*m^2"};

std::string in_unit(double si, double factor, std::string_view unit) {
  return fmt::format("{:.10g} {}", si / factor, unit);
}

// The value is assigned to `ans`, as if the expression had been typed alone.
bool show_units(Prompt& prompt, std::string_view expression) {
  if (!prompt.enter_aside(std::string(expression))) return false;
  const std::optional<EntryValue> shown = prompt.session().shown();
  if (!shown || !shown->name.empty()) return refuse("that is no expression");
  const Value value = prompt.session().vm()->global("ans");
  const auto* number = value.get_if<Value::Number>();
  if (number == nullptr || number->dim.is_none())
    return refuse(fmt::format("that is {}, which has no unit", shown->type));
  std::string line;
  const auto add = [&](std::string_view unit, Dim dim, double factor) {
    if (dim == number->dim) line += (line.empty() ? "" : "   ") + in_unit(number->si, factor, unit);
  };
  for (const Unit& unit : all_units()) add(unit.name, unit.dim, unit.factor);
  for (const std::string_view name : kCombined) {
    if (const auto unit = parse_unit(name)) add(name, unit->dim, unit->factor);
  }
  say(line.empty() ? shown->text : line);
  return true;
}

bool show_steps(Prompt& prompt, std::string_view name) {
  const Cell& cell = prompt.host().cell();
  const std::optional<int> asked = name.empty() ? std::nullopt : cell.find_robot(name);
  if (!name.empty() && !asked) return refuse(fmt::format("there is no robot {}", name));
  for (int i = 0; i < cell.robot_count(); ++i) {
    if (!asked || *asked == i) say(last_move_text(prompt.host(), i));
  }
  return cell.robot_count() > 0 || refuse("no robot has moved");
}

bool plot_figures(Prompt& prompt, std::string_view) {
  const std::vector<Figure>& figures = prompt.host().figures();
  if (figures.empty()) return refuse("there is no figure; plot(...) draws one");
  say(to_braille(figures.back(), 72, 18, is_capable_terminal(STDOUT_FILENO)));
  return true;
}

bool explain_code(Prompt&, std::string_view code) { return explain(std::string(code)) == kDone; }

// ---- undo and redo ------------------------------------------------------------------------------

// A number from 1 on; nullopt after a message.
std::optional<std::size_t> count_of(std::string_view text) {
  std::size_t count = 1;
  if (text.empty()) return count;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (error == std::errc() && end == text.data() + text.size() && count > 0) return count;
  progress(fmt::format("\"{}\" is not a number from 1 on; write for example :undo 2", text));
  return std::nullopt;
}

// The entries in one line each.
std::string first_lines(const std::vector<std::string>& entries) {
  std::string out;
  for (const std::string& text : entries) out += "\n  " + text.substr(0, text.find('\n'));
  return out;
}

constexpr std::string_view kStoppedGoing = "stopped; all as it was";

bool undo(Prompt& prompt, std::string_view argument) {
  const auto count = count_of(argument);
  if (!count) return false;
  const std::vector<std::string> undone = prompt.undo(*count);
  if (undone.empty()) return refuse(interrupted() ? kStoppedGoing : "there is nothing to undo");
  say(fmt::format("{}, robots, objects and names as before{}", prompt.time(), first_lines(undone)));
  return true;
}

bool redo(Prompt& prompt, std::string_view argument) {
  const auto count = count_of(argument);
  if (!count) return false;
  const std::vector<std::string> done = prompt.redo(*count);
  if (done.empty()) return refuse(interrupted() ? kStoppedGoing : "there is nothing to do again");
  say(fmt::format("{}, done again{}", prompt.time(), first_lines(done)));
  return true;
}

// The present time of the session, and the entry it is in or after.
std::string place_of(Prompt& prompt) {
  const auto named = [](const LoggedEntry& entry) {
    return fmt::format("{}: {}", entry.name, entry.text.substr(0, entry.text.find('\n')));
  };
  if (const auto line = prompt.under_way()) {
    return fmt::format("{}, in {}\n:redo takes it to its end, :undo back to before it",
                       prompt.time(), named(*line));
  }
  return fmt::format("{}, behind {}", prompt.time(),
                     named(prompt.session().entries().back().logged));
}

bool go_to(Prompt& prompt, std::string_view argument) {
  const auto t_ns = time_of(std::string(argument));
  if (!t_ns) return refuse("write :goto with a time of this session, such as :goto 3.2s");
  try {
    if (!prompt.go_to(*t_ns)) return refuse(kStoppedGoing);
  } catch (const ArgumentError& error) {
    return refuse(error.what());
  }
  say(place_of(prompt));
  return true;
}

bool list_runs(Prompt& prompt, std::string_view argument) {
  const std::vector<SessionLog>& runs = prompt.session().runs();
  if (runs.empty()) return refuse("no run was left for another one");
  if (!argument.empty()) {
    const auto number = count_of(argument);
    if (!number) return false;
    if (*number > runs.size())
      return refuse(fmt::format("there is no run {}; :runs lists those there are", *number));
    if (!prompt.take_up(*number - 1)) return refuse(kStoppedGoing);
    say(place_of(prompt));
    return true;
  }
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const LoggedEntry& last = runs[i].entries.back();
    say(fmt::format("{:>3}  to t = {:.2f} s, {} {}: {}", i + 1,
                    static_cast<double>(last.end.t_ns) * 1e-9, runs[i].entries.size() - 1,
                    runs[i].entries.size() == 2 ? "line" : "lines",
                    last.text.substr(0, last.text.find('\n'))));
  }
  return true;
}

bool reset(Prompt& prompt, std::string_view) {
  prompt.undo(prompt.session().entries().size());
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
  const auto [end, error] =
      std::from_chars(argument.data(), argument.data() + argument.size(), factor);
  if (error != std::errc() || end != argument.data() + argument.size() || !(factor >= 0.01) ||
      factor > 1000.0)
    return refuse("write :speed 1x for the speed of the clock, from 0.01x to 1000x, or :speed max");
  prompt.pace().set(factor);
  say(fmt::format("moves are shown at {:g} times their speed", factor));
  return true;
}

// ---- files --------------------------------------------------------------------------------------

bool save(Prompt& prompt, std::string_view path) {
  if (!path.ends_with(".rbt")) return refuse("a program is a .rbt file: write :save NAME.rbt");
  Result<NewFile> made = create_file(std::string(path));
  if (!made.ok())
    return refuse(fmt::format("{} cannot be written: {}", path, made.error().message));
  NewFile file = std::move(made).value();
  const Prompt::Saved saved = prompt.program();
  file.write(saved.text);
  if (const auto error = file.finish())
    return refuse(fmt::format("{} cannot be written: {}", path, error->message));
  say(fmt::format("saved in {}", path));
  if (!saved.comments.empty())
    say(fmt::format("a file does not take {}: comments there", fmt::join(saved.comments, ", ")));
  return true;
}

bool load(Prompt& prompt, std::string_view path) {
  const auto text = read_file(std::string(path), false);
  return text && prompt.enter(*text);
}

bool record(Prompt& prompt, std::string_view argument) {
  const std::string path(argument == "on" ? "session.arec" : argument == "off" ? "" : argument);
  if (!path.empty() && !path.ends_with(".arec"))
    return refuse("write :record on, :record off or :record FILE.arec");
  if (!prompt.record(path)) return false;
  say(path.empty()
          ? "the session is not recorded"
          : fmt::format("{} will have the session when it ends, for `armlet replay`", path));
  return true;
}

bool quit(Prompt& prompt, std::string_view) {
  prompt.quit();
  return true;
}

bool show_commands(Prompt& prompt, std::string_view);

constexpr PromptCommand kCommands[] = {
    {"?", "NAME", "what a function, a setting or a word does, with an example", show_page},
    {"??", "WORDS", "the functions for a subject, such as ??inverse kinematics", nullptr},
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
    {":goto", "TIME", "to a time of the session, such as :goto 3.2s", go_to},
    {":runs", "[N]", "what was left by going back and on otherwise, or back to the Nth of it",
     list_runs},
    {":speed", "1x|max", "show moves at the speed of the clock, or compute them at once",
     set_speed},
    {":save", "FILE.rbt", "the lines so far as a program", save},
    {":record", "on|off",
     "leave the session for `armlet replay` in session.arec, or in a FILE.arec", record},
    {":load", "FILE.rbt", "run a file as if it were typed here", load},
    {":quit", "", "end, like Ctrl-D", quit},
};

bool show_commands(Prompt&, std::string_view) {
  for (const PromptCommand& command : kCommands) {
    print_out(fmt::format("{:<10} {:<12} {}\n", command.name, command.argument, command.help));
  }
  say("?moveL shows what a function does, ??straight line the functions for a subject.");
  say("Tab completes, the arrow keys fetch earlier lines, Ctrl-C stops. A semicolon hides a "
      "value.");
  return true;
}

}  // namespace

bool is_command(std::string_view line) {
  line = trimmed(line);
  return line.starts_with('?') ||
         (line.starts_with(':') && line.size() > 1 &&
          std::isalpha(static_cast<unsigned char>(line[1])) != 0) ||
         page_question(line).has_value();
}

CommandPart command_part(std::string_view before_cursor) {
  CommandPart part;
  const std::size_t first = before_cursor.find_first_not_of(" \t");
  const std::string_view line = before_cursor.substr(first);
  const auto offer = [&part](std::string_view start, std::string_view name) {
    if (name.starts_with(start)) part.choices.texts.emplace_back(name);
  };
  if (line.starts_with('?')) {
    const std::size_t behind = std::min(line.find_first_not_of('?'), line.size());
    const std::string_view start = trimmed(line.substr(behind));
    part.choices.word_bytes = start.size();
    for (const std::string& name : help_names(library_engine())) offer(start, name);
    return part;
  }
  const std::size_t space = line.find(' ');
  if (space == line.npos) {
    part.choices.word_bytes = line.size();
    for (const PromptCommand& command : kCommands) offer(line, command.name);
    return part;
  }
  const auto* known = std::ranges::find(kCommands, line.substr(0, space), &PromptCommand::name);
  part.is_expression = known != std::end(kCommands) && known->argument == "EXPRESSION";
  part.begin = first + space + 1;
  return part;
}

bool run_command(Prompt& prompt, std::string_view line) {
  line = trimmed(line);
  if (const auto name = page_question(line)) {
    if (is_declared(prompt, line)) return prompt.enter(std::string(line));
    return name->empty() ? show_commands(prompt, {}) : show_asked_page(prompt, line, *name);
  }
  if (line.starts_with("??")) return search_pages(trimmed(line.substr(2)));
  if (line == "?") return show_commands(prompt, {});
  if (line.starts_with('?')) return show_page(prompt, trimmed(line.substr(1)));
  const std::size_t space = line.find(' ');
  const std::string_view name = line.substr(0, space);
  const std::string_view argument =
      space == std::string_view::npos ? "" : trimmed(line.substr(space));
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
