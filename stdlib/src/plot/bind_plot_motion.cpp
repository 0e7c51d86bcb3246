// Motions drawn in panels: trajectories, lists of positions, and the columns of a record.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "armlet/interpreter/unit.hpp"
#include "armlet/trajectory/drawing_times.hpp"
#include "moves/trajectories.hpp"
#include "plot/plots.hpp"
#include "values/number_units.hpp"

namespace armlet::bind {
namespace {

// Values over the time of a motion or of a record.
struct Line {
  std::string label{};
  std::vector<double> y{};
  std::string unit{};
  bool right = false;
  bool is_read = false;  // the unit was determined from the text of the program
};
struct Panel {
  std::string title{};
  std::vector<Line> lines{};
};

// Sets the unit of joint values of this order, "rad/s" or "m/s", and their side. Metres have an
// axis of their own if there are angles too.
void set_unit(Line& line, const PosJ& joints, int joint, int order) {
  const auto turns = std::span(joints.turns).first(joints.n);
  const bool angle = turns[static_cast<std::size_t>(joint)];
  constexpr std::string_view kPer[] = {"", "/s", "/s^2"};
  line.unit = fmt::format("{}{}", angle ? "rad" : "m", kPer[order]);
  line.right = !angle && std::ranges::find(turns, true) != turns.end();
}

// Shortens each panel to its old number of series; removes the panels if there were none.
void take_back(Figure& figure, const std::vector<std::size_t>& sizes) {
  if (sizes.empty()) figure.panels.clear();
  for (std::size_t k = 0; k < sizes.size(); ++k) figure.panels[k].series.resize(sizes[k]);
}

// Adds the panels to the figure of the program, all or none of them.
Answer<void> draw(Vm& vm, const std::vector<double>& t, std::vector<Panel> panels) {
  std::size_t values = 0;
  std::vector<std::string> titles;
  for (const Panel& panel : panels) {
    titles.push_back(panel.title);
    values += 2 * panel.lines.size() * t.size();
  }
  if (!make_room(vm, values)) return Failed{};
  Figure& figure = current_figure(Host::of(vm));
  std::vector<std::size_t> sizes;
  for (const Figure& panel : figure.panels) sizes.push_back(panel.series.size());
  const auto fields = panels_of(vm, figure, titles);
  if (!fields) return Failed{};
  for (std::size_t k = 0; k < panels.size(); ++k) {
    for (Line& line : panels[k].lines) {
      Series series{.label = std::move(line.label), .x = t, .y = std::move(line.y)};
      series.right = line.right;
      const PlotUnits units{
          .x = "s", .y = line.unit, .is_read = line.is_read, .is_side_given = true};
      if (!add_series(vm, (**fields)[k], std::move(series), units)) {
        take_back(figure, sizes);
        return Failed{};
      }
    }
    (**fields)[k].y.label.clear();
  }
  return figure_changed(vm);
}

// ---- trajectories -------------------------------------------------------------------------------

// Draws the joints `first` to `last`, with a name each.
Answer<void> draw_motion(Vm& vm, const PlannedMotion& plan, int first, int last,
                         const std::vector<std::string>& labels) {
  const Trajectory& motion = plan.motion;
  const auto knots = motion.knots().size();
  const auto joints = static_cast<std::size_t>(last - first);
  // Each value is searched for among the segments of its joint.
  if (!charge_steps(vm, joints * (1 + knots / 64))) return Failed{};
  const std::vector<double> t = drawing_times(motion);
  std::vector<Panel> panels{
      {.title = "position q"}, {.title = "speed qd"}, {.title = "acceleration qdd"}};
  for (int order = 0; order < 3; ++order) {
    for (int joint = first; joint < last; ++joint) {
      if (!charge_steps(vm, 1 + t.size() / 4)) return Failed{};
      Line line{.label = labels[static_cast<std::size_t>(joint - first)]};
      for (const double at : t) line.y.push_back(motion.value(joint, at, order));
      set_unit(line, plan.joints, joint, order);
      panels[static_cast<std::size_t>(order)].lines.push_back(std::move(line));
    }
  }
  return draw(vm, t, std::move(panels));
}

Answer<void> plot_trajectory(Vm& vm, const PlannedMotion& plan, OptionalText given_label,
                             std::optional<std::int64_t> only) {
  const std::string label = text_or_nothing(given_label);
  int first = 0, last = plan.motion.n();
  if (only) {
    if (*only < 1 || *only > last) {
      return failure(vm, "R0626",
                     fmt::format("there is no joint {}: the motion has {}", *only, last),
                     at("joint"), "joints count from 1");
    }
    first = static_cast<int>(*only) - 1;
    last = first + 1;
    if (!label.empty()) return draw_motion(vm, plan, first, last, {label});
  }
  std::vector<std::string> labels;
  for (int joint = first; joint < last; ++joint)
    labels.push_back(fmt::format("{}{}joint {}", label, label.empty() ? "" : ", ", joint + 1));
  return draw_motion(vm, plan, first, last, labels);
}

Answer<void> plot_named_trajectory(Vm& vm, const PlannedMotion& plan, std::span<const Slot> names) {
  const auto labels = labels_of(vm, names, at("label"), static_cast<std::size_t>(plan.motion.n()));
  if (!labels) return Failed{};
  return draw_motion(vm, plan, 0, plan.motion.n(), *labels);
}

// ---- positions ----------------------------------------------------------------------------------

// The joints of positions, a line each; nullopt if their numbers of joints differ.
std::optional<std::vector<Line>> joint_lines(std::span<const Slot> positions,
                                             const std::string& label) {
  std::vector<Line> lines;
  if (positions.empty()) return lines;
  const PosJ& first = posj(positions[0]);
  for (int joint = 0; joint < first.n; ++joint) {
    Line line{.label = fmt::format("{}{}", label, joint + 1)};
    if (first.kinds_known) set_unit(line, first, joint, 0);
    for (const Slot position : positions) {
      if (posj(position).n != first.n) return std::nullopt;
      line.y.push_back(posj(position).q[static_cast<std::size_t>(joint)]);
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

Answer<void> plot_positions(Vm& vm, std::span<const double> x, std::span<const Slot> positions,
                            OptionalItems given_labels, OptionalText x_unit) {
  if (x.size() != positions.size()) return size_failure(vm, "x and y", x.size(), positions.size());
  if (!make_room(vm, 2 * x.size())) return Failed{};
  auto lines = joint_lines(positions, "joint ");
  if (!lines)
    return failure(vm, "R0613", "the positions have different numbers of joints", at("y"));
  const auto labels = labels_of(vm, given_labels, at("label"), lines->size());
  if (!labels || !make_room(vm, 2 * x.size() * lines->size())) return Failed{};
  Figure& figure = current_figure(Host::of(vm));
  const std::size_t had = figure.series.size();
  for (std::size_t k = 0; k < lines->size(); ++k) {
    Line& line = (*lines)[k];
    Series series{.label = given_labels ? (*labels)[k] : line.label,
                  .x = {x.begin(), x.end()},
                  .y = std::move(line.y)};
    series.right = line.right;
    if (add_series(vm, figure, std::move(series),
                   {text_or_nothing(x_unit), line.unit, at("x"), at("y")}))
      continue;
    figure.series.resize(had);
    return Failed{};
  }
  return figure_changed(vm);
}

// ---- records ------------------------------------------------------------------------------------

std::string unit_of(const Type& type) {
  return type.is_quantity() ? si_unit(type.dim) : std::string();
}

double number_in(Slot s, const Type& type) {
  return type.is(Kind::kReal) ? s.d : static_cast<double>(s.i);
}

// Lines of numbers that are side by side in each row: value(slot, k) for k below this number.
template <class F>
std::vector<Line> side_by_side(std::span<const Slot> values, const std::vector<std::string>& labels,
                               const std::string& unit, F value) {
  std::vector<Line> lines;
  for (std::size_t k = 0; k < labels.size(); ++k) {
    Line line{.label = labels[k], .unit = unit};
    for (const Slot s : values) line.y.push_back(value(s, k));
    lines.push_back(std::move(line));
  }
  return lines;
}

std::vector<std::string> numbered(const std::string& label, std::size_t count) {
  std::vector<std::string> labels;
  for (std::size_t k = 1; k <= count; ++k) labels.push_back(fmt::format("{}{}", label, k));
  return labels;
}

struct Column {
  std::vector<Line> lines{};
  bool uneven = false;  // its rows have different numbers of values
};

// The lines of a column; none if its values are no numbers.
Column column_of(std::span<const Slot> values, const Type& type, const std::string& name) {
  const auto is_simple = [](const Type& t) { return t.is_number() || t.is(Kind::kBool); };
  if (is_simple(type)) {
    return {side_by_side(values, {name}, unit_of(type),
                         [&](Slot s, std::size_t) { return number_in(s, type); })};
  }
  if (type.is(Kind::kList) && is_simple(*type.element)) {
    const std::size_t count = items_value(values[0]).size();
    if (std::ranges::any_of(values, [&](Slot s) { return items_value(s).size() != count; }))
      return {.uneven = true};
    return {side_by_side(
        values, numbered(name, count), unit_of(*type.element),
        [&](Slot s, std::size_t k) { return number_in(items_value(s)[k], *type.element); })};
  }
  if (type.is(Kind::kHost) && type.host == &kPosC) {
    return {side_by_side(values, {name + ".x", name + ".y", name + ".z"}, "m",
                         [](Slot s, std::size_t k) {
                           return posc(s).T.translation()[static_cast<Eigen::Index>(k)];
                         })};
  }
  if (type.is(Kind::kHost) && type.host == &kPosJ) {
    auto lines = joint_lines(values, name);
    return lines ? Column{*std::move(lines)} : Column{.uneven = true};
  }
  return {};
}

// Upper bound of the number of values per row, charged as work before the values are read.
std::size_t width_of(std::span<const Slot> values, const Type& type) {
  if (type.is(Kind::kList)) return items_value(values[0]).size();
  return type.is(Kind::kHost) ? kMaxJoints : 1;
}

// The panels of a column: one, or several if its lines have more than two units.
void add_panels(std::vector<Panel>& panels, const std::string& name, std::vector<Line> lines) {
  std::vector<std::string> units;
  const std::size_t first = panels.size();
  for (Line& line : lines) {
    auto found = std::ranges::find(units, line.unit);
    if (found == units.end()) found = units.insert(found, line.unit);
    const auto place = static_cast<std::size_t>(found - units.begin());
    while (panels.size() <= first + place / 2) {
      const std::size_t more = panels.size() - first;
      panels.push_back({more == 0 ? name : fmt::format("{} ({})", name, more + 1), {}});
    }
    line.right = line.right || place % 2 == 1;
    panels[first + place / 2].lines.push_back(std::move(line));
  }
}

Answer<void> plot_table(Vm& vm, const RecordObj& table, OptionalText given_label,
                        OptionalText given_units) {
  const std::vector<RecordField>& columns = table.layout->type->record->row->record->fields;
  const auto rows = table_rows(table);
  const std::string label = text_or_nothing(given_label);
  if (rows.empty()) return failure(vm, "R0626", "there are no samples to draw", at("run"));
  std::vector<double> t;
  std::vector<Panel> panels;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const Type& type = *columns[k].type;
    const std::string_view known = part_of(given_units.value_or(""), k);
    std::vector<Slot> values;
    if (!charge_steps(vm, rows.size())) return Failed{};
    for (const Slot row : rows) values.push_back(static_cast<const RecordObj*>(row.o)->fields()[k]);
    if (k == 0) {
      for (const Slot time : values) t.push_back(time.d);
      continue;
    }
    if (!make_room(vm, 2 * width_of(values, type) * rows.size())) return Failed{};
    Column column = column_of(values, type, columns[k].name);
    if (column.uneven) {
      return failure(
          vm, "R0613",
          fmt::format("the column `{}` has not as many values in every row", columns[k].name),
          at("run"), "each of them is a line");
    }
    if (column.lines.empty()) continue;
    const auto read = read_units(vm, known, column.lines.front().unit, column.lines.size());
    for (std::size_t i = 0; i < read.size(); ++i) {
      column.lines[i].unit = read[i];
      column.lines[i].is_read = !read[i].empty();
    }
    for (Line& line : column.lines) {
      if (!label.empty()) line.label = column.lines.size() == 1 ? label : label + ", " + line.label;
    }
    add_panels(panels, columns[k].name, std::move(column.lines));
  }
  if (panels.empty())
    return failure(vm, "R0626", "no column of this record holds numbers", at("run"));
  return draw(vm, t, std::move(panels));
}

constexpr NativeFunction kPlotMotionFunctions[] = {
    def<plot_trajectory>(
        "plot(tr: trajectory, label: string?, joint: int?)",
        "Draws positions, speeds and accelerations of a trajectory in three panels, angles in "
        "degrees "
        "on the left and lengths on the right; joint: only this one, counted from 1; label: what "
        "the "
        "lines are called in the legend.",
        "plot(trajectory(\"434\", [home(), posJ(60deg, 30deg, 0mm, 0deg)], time: 2s))"),
    def<plot_named_trajectory>(
        "plot(tr: trajectory, label: string[])", "The same with a name for each joint.",
        "plot(trajectory(\"Syn\", [home(), posJ(60deg, 30deg, 0mm, 0deg)]), label: [\"base\", "
        "\"elbow\", \"stroke\", \"wrist\"])"),
    def<plot_positions>(
        "plot(x: D[], y: posJ[], label: string[]?, xUnit: unit(x)?)",
        "Draws a line for each joint of positions, angles on the left and lengths on the right.",
        "plot([0s, 1s], [home(), posJ(60deg, 30deg, 0mm, 0deg)])"),
    def<plot_table>("plot(run: table, label: string?, runUnits: units(run)?)",
                    "Draws every column of a record over its time, in a panel each. A list, a posJ "
                    "and a posC are "
                    "several lines, those of different units on axes of their own; texts and other "
                    "columns without numbers are left out. label: "
                    "the name of the "
                    "record in the legend, where two are compared in one figure.",
                    "record run every (10ms) { q: joints() }; moveJ(home()); plot(run)"),
};

}  // namespace

std::span<const NativeFunction> plot_motion_functions() { return kPlotMotionFunctions; }

}  // namespace armlet::bind
