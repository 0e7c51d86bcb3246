#include "run/inputs.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "armlet/cell/clock.hpp"
#include "armlet/core/format.hpp"
#include "armlet/core/platform.hpp"
#include "armlet/stdlib/laboratory_controls.hpp"
#include "console/console.hpp"

namespace armlet::cli {
namespace {

using InputJson = nlohmann::json;

// A mistake in a line.
struct Wrong {
  std::string why;
};

const InputJson& member(const InputJson& object, const char* name) {
  const auto found = object.find(name);
  if (found == object.end()) throw Wrong{fmt::format("`{}` is missing", name)};
  return *found;
}

std::string text_in(const InputJson& object, const char* name) {
  const InputJson& value = member(object, name);
  if (!value.is_string()) throw Wrong{fmt::format("`{}` is a text, not {}", name, value.dump())};
  return value.get<std::string>();
}

double number_of(const InputJson& value, const char* name) {
  const double number = value.is_number() ? value.get<double>() : std::nan("");
  if (!std::isfinite(number))
    throw Wrong{fmt::format("`{}` takes numbers, not {}", name, value.dump())};
  return number;
}

std::vector<double> numbers_in(const InputJson& object, const char* name) {
  const InputJson& list = member(object, name);
  if (!list.is_array()) throw Wrong{fmt::format("`{}` is a list, not {}", name, list.dump())};
  std::vector<double> numbers;
  for (const InputJson& each : list) numbers.push_back(number_of(each, name));
  return numbers;
}

std::int64_t time_in(const InputJson& object) {
  const double t = number_of(member(object, "t"), "t");
  constexpr double kMost = static_cast<double>(kEndOfTime_ns) * 1e-9;
  if (t < 0.0 || t > kMost)
    throw Wrong{
        fmt::format("`t` lies between 0 s and 100 years, not at {} s", format_number(t, 9))};
  return to_ns(t);
}

InputScript::Set set_in(const InputJson& object) {
  InputScript::Set set{text_in(object, "set"), {}};
  const InputJson& value = member(object, "value");
  if (value.is_boolean()) {
    set.value = value.get<bool>();
  } else if (value.is_number_integer()) {
    set.value = value.get<std::int64_t>();
  } else if (value.is_number()) {
    set.value = number_of(value, "value");
  } else if (value.is_string()) {
    set.value = value.get<std::string>();
  } else {
    throw Wrong{fmt::format("`value` is a number, a text, true or false, not {}", value.dump())};
  }
  return set;
}

// A key other than `t` and those of the input is a mistake.
void refuse_others(const InputJson& object, std::initializer_list<std::string_view> known) {
  for (const auto& [key, value] : object.items()) {
    if (key == "t" || std::ranges::find(known, key) != known.end()) continue;
    std::string list = "`t`";
    for (const std::string_view each : known) list += fmt::format(", `{}`", each);
    throw Wrong{fmt::format("there is no `{}` here; such an input has {}", key, list)};
  }
}

InputScript::Line line_of(const InputJson& object) {
  if (!object.is_object())
    throw Wrong{"an input is an object, such as {\"t\": 2, \"press\": \"go\"}"};
  InputScript::Line line{.t_ns = time_in(object)};
  if (object.contains("set")) {
    refuse_others(object, {"set", "value"});
    line.what = set_in(object);
  } else if (object.contains("press")) {
    refuse_others(object, {"press"});
    line.what = InputScript::Press{text_in(object, "press")};
  } else if (object.contains("joints")) {
    refuse_others(object, {"joints", "values"});
    line.what = InputScript::Joints{text_in(object, "joints"), numbers_in(object, "values")};
  } else if (object.contains("hand")) {
    refuse_others(object, {"hand", "values"});
    line.what = InputScript::Hand{text_in(object, "hand"), numbers_in(object, "values")};
  } else if (object.contains("show")) {
    refuse_others(object, {"show"});
    line.what = InputScript::Show{text_in(object, "show")};
  } else {
    throw Wrong{"an input has one of `set`, `press`, `joints`, `hand` and `show`"};
  }
  return line;
}

// ---- applying inputs

Value value_for(const LabControls& controls, const InputScript::Set& set) {
  const LabRow* row = controls.rows() == nullptr ? nullptr : controls.rows()->find(set.field);
  const Dim dim = row == nullptr ? dims::kNone : row->dim;
  return std::visit(
      [dim](const auto& given) {
        if constexpr (std::is_same_v<std::decay_t<decltype(given)>, double>) {
          return Value(Value::Number{given, dim});
        } else if constexpr (std::is_same_v<std::decay_t<decltype(given)>, std::int64_t>) {
          return dim.is_none() ? Value(given)
                               : Value(Value::Number{static_cast<double>(given), dim});
        } else {
          return Value(given);
        }
      },
      set.value);
}

// Numbers in SI, rows in brackets.
std::string shown(const Value& value) {
  return std::visit(
      Overload{[](std::monostate) { return std::string("nothing"); },
               [](bool truth) { return std::string(truth ? "true" : "false"); },
               [](std::int64_t whole) { return fmt::format("{}", whole); },
               [](const Value::Number& number) { return format_number(number.si, 9); },
               [](const std::string& text) { return text; },
               [](const Value::List& list) {
                 std::string out = "[";
                 for (const Value& each : list) out += (out.size() > 1 ? ", " : "") + shown(each);
                 return out + ']';
               },
               [](const Value::Matrix& matrix) {
                 std::string out = "[";
                 for (std::size_t i = 0; i < matrix.elements.size(); ++i)
                   out += (i == 0                 ? ""
                           : i % matrix.cols == 0 ? "; "
                                                  : ", ") +
                          format_number(matrix.elements[i], 9);
                 return out + ']';
               },
               [](const Value::Record& record) {
                 std::string out = "(";
                 for (const auto& [name, field] : record.fields)
                   out += fmt::format("{}{}: {}", out.size() > 1 ? ", " : "", name, shown(field));
                 return out + ')';
               },
               [](const Value::Enum& which) { return which.value; },
               [&value](const auto&) { return value.kind(); }},
      value.content());
}

// "image 320 x 240, RGB; 2 features [100, 80; 120.5, 90]".
std::string shown(const LabPicture& picture) {
  const Image& image = picture.image;
  std::string out = fmt::format("image {} x {}, {}", image.width(), image.height(),
                                image.kind() == PixelKind::kRgb    ? "RGB"
                                : image.kind() == PixelKind::kGrey ? "grey"
                                                                   : "depth");
  for (const LabMarks& marks : picture.marks) {
    out += fmt::format("; {} {}{}{} [", marks.pixels.size(),
                       marks.what == "truth" ? "corner" : marks.what,
                       marks.pixels.size() == 1 || marks.what == "wanted" ? "" : "s",
                       marks.object.empty() ? "" : " of " + marks.object);
    for (std::size_t i = 0; i < marks.pixels.size(); ++i)
      out += fmt::format("{}{}, {}", i == 0 ? "" : "; ", format_number(marks.pixels[i][0], 5),
                         format_number(marks.pixels[i][1], 5));
    out += ']';
  }
  if (!picture.fault.empty()) out += "; no features: " + picture.fault;
  return out;
}

bool has_picture(const LabRow& row) {
  return row.kind == LabRowKind::kView || (row.kind == LabRowKind::kImage && row.is_read);
}

// Prints what a row shows, or why it shows nothing, as on the page: its function has failed, and
// the run and the other rows go on.
template <class Shown>
std::optional<Error> print_row(const std::string& row, const Result<Shown>& what) {
  if (!what && what.error().code != "failed") return what.error();
  print_out(what ? fmt::format("{} = {}\n", row, shown(*what))
                 : fmt::format("{} shows nothing: {}\n", row, what.error().message));
  return std::nullopt;
}

std::optional<Error> show_row(LabControls& controls, const std::string& row) {
  const LabRow* known = controls.rows() == nullptr ? nullptr : controls.rows()->find(row);
  if (known != nullptr && has_picture(*known)) return print_row(row, controls.picture(row));
  return print_row(row, controls.read(row));
}

std::optional<Error> apply(LabControls& controls, const InputScript::Line& line) {
  return std::visit(
      Overload{[&](const InputScript::Set& each) {
                 return controls.set_field(each.field, value_for(controls, each));
               },
               [&](const InputScript::Press& each) { return controls.press(each.button); },
               [&](const InputScript::Joints& each) {
                 return controls.move_joints(each.robot, Eigen::Map<const Eigen::VectorXd>(
                                                             each.q.data(), std::ssize(each.q)));
               },
               [&](const InputScript::Hand& each) {
                 return controls.move_hand(each.sliders, each.values);
               },
               [&](const InputScript::Show& each) { return show_row(controls, each.row); }},
      line.what);
}

}  // namespace

void InputScript::tell(int line, const std::string& why) const {
  progress(fmt::format("armlet: {}:{}: {}", path_, line, why));
}

int InputScript::read(const std::string& path) {
  if (path.empty()) return kDone;
  path_ = path;
  const auto text = read_file(path, false);
  if (!text) return kNoFile;
  int number = 0;
  int mistakes = 0;
  constexpr int kMostMistakes = 10;
  for (std::size_t at = 0; at < text->size() && mistakes < kMostMistakes;) {
    const std::size_t end = std::min(text->find('\n', at), text->size());
    const std::string_view written = std::string_view(*text).substr(at, end - at);
    at = end + 1;
    ++number;
    const std::size_t first = written.find_first_not_of(" \t\r");
    if (first == std::string_view::npos || written[first] == '#') continue;
    try {
      Line line = line_of(InputJson::parse(written));
      line.number = number;
      if (!lines_.empty() && line.t_ns < lines_.back().t_ns) {
        throw Wrong{fmt::format("time goes back from {} s to {} s",
                                format_number(to_seconds(lines_.back().t_ns), 9),
                                format_number(to_seconds(line.t_ns), 9))};
      }
      lines_.push_back(std::move(line));
    } catch (const Wrong& wrong) {
      tell(number, wrong.why);
      ++mistakes;
    } catch (const InputJson::exception&) {
      tell(number, "this is no JSON object");
      ++mistakes;
    }
  }
  return mistakes == 0 ? kDone : kRejected;
}

void InputScript::listen(SessionOptions& session, std::function<void(const Diagnostic&)> tell) {
  session.laboratory = is_wanted();
  session.on_press = [this, tell = std::move(tell)](const PressReport& report) {
    if (report.failure) tell(*report.failure);
    button_failed_ = button_failed_ || report.failure.has_value();
  };
}

bool InputScript::play_lines(Session& session) const {
  LabControls controls(session);
  for (const Line& line : lines_) {
    const Progress status = session.run({.until_ns = line.t_ns});
    if (interrupted()) return false;
    if (status != Progress::kPaused) {
      tell(line.number, "the run has ended before this input");
      return false;
    }
    if (const auto refused = apply(controls, line)) {
      tell(line.number, refused->message);
      return false;
    }
  }
  session.run(Budget{});
  if (session.is_at_rest()) session.finish();
  return true;
}

RunResult InputScript::play(Session& session) const {
  const bool played = play_lines(session);
  RunResult result = session.result();
  if (interrupted()) {
    result.status = Progress::kCancelled;
  } else if (result.status != Progress::kCancelled && (!played || button_failed_)) {
    result.status = Progress::kFailed;
  }
  return result;
}

}  // namespace armlet::cli
