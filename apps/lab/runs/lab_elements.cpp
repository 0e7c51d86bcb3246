#include "lab_elements.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "armlet/backend/event.hpp"
#include "armlet/cell/clock.hpp"
#include "armlet/interpreter/unit.hpp"
#include "armlet/stdlib/install.hpp"
#include "armlet/stdlib/laboratory_controls.hpp"
#include "live_run.hpp"

namespace armlet::lab {
namespace {

constexpr std::int64_t kPlotStep_ns = 10'000'000;
constexpr std::int64_t kPlotPoints = 2000;
constexpr int kPointsInSlice = 40;
constexpr std::int64_t kWayPoints = 250;  // of paths of features in a picture
constexpr std::size_t kMostColumns = 64;

// The number in the type of the field.
Value value_for(const LabRow* row, const SetField& set) {
  if (const double* number = std::get_if<double>(&set.value)) {
    if (row != nullptr && row->type == LabFieldType::kInt && *number == std::floor(*number) &&
        std::abs(*number) < 1e15)
      return Value(static_cast<std::int64_t>(*number));
    return Value(Value::Number{*number, row == nullptr ? Dim{} : row->dim});
  }
  if (const bool* truth = std::get_if<bool>(&set.value)) return Value(*truth);
  return Value(std::get<std::string>(set.value));
}

Eigen::VectorXd vector_of(const std::vector<double>& numbers) {
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(),
                                           static_cast<Eigen::Index>(numbers.size()));
}

}  // namespace

std::optional<LabElements> lab_of(Session& session, std::optional<LabElements> known) {
  if (session.vm() == nullptr || session.host() == nullptr) return known;
  const LabControls controls(session);
  const LabRows* rows = controls.rows();
  const auto robots = static_cast<std::size_t>(session.host()->cell().robot_count());
  // The default page has two sliders and two plots for each robot of the cell, so it can grow.
  if (rows == nullptr && known && known->rows.rows.size() >= 4 * robots) return known;
  LabElements lab{.rows = rows == nullptr ? default_lab_rows(session.host()->cell()) : *rows,
                  .ranges = {},
                  .has_block = rows != nullptr};
  for (const LabRow& row : lab.rows.rows) {
    const bool is_hand = row.kind == LabRowKind::kSliders && !row.axes.empty();
    lab.ranges.emplace_back();
    lab.places.push_back(row.at.empty() ? std::nullopt : span_of(session.sources(), row.at));
    if (!is_hand) continue;
    const auto ranges = controls.hand_ranges(row.name);
    if (ranges.ok()) lab.ranges.back() = ranges.value();
  }
  return lab;
}

std::optional<Error> apply_input(Session& session, const InputWhat& input) {
  LabControls controls(session);
  return std::visit(
      Overload{
          [&](const SetField& set) {
            const LabRow* row =
                controls.rows() == nullptr ? nullptr : controls.rows()->find(set.name);
            return controls.set_field(set.name, value_for(row, set));
          },
          [&](const PressButton& press) { return controls.press(press.name); },
          [&](const SetJoints& set) { return controls.move_joints(set.robot, vector_of(set.q)); },
          [&](const SetHand& set) { return controls.move_hand(set.sliders, set.values); }},
      input);
}

std::vector<ElementValue> element_values(Session& session, const LabElements& lab) {
  std::vector<ElementValue> out;
  LabControls controls(session);
  const auto add = [&](const LabRow& row, const auto& result) {
    ElementValue value{.name = row.name};
    if (!result.ok()) {
      value.fault = result.error().message;
    } else {
      value.value = Value(result.value());
    }
    out.push_back(std::move(value));
  };
  for (const LabRow& row : lab.rows.rows) {
    if (row.kind == LabRowKind::kField) {
      add(row, controls.field(row.name));
    } else if (row.kind == LabRowKind::kSliders && !row.axes.empty()) {
      add(row, controls.hand(row.name));
    } else if (row.is_read && row.kind != LabRowKind::kImage && row.kind != LabRowKind::kView) {
      add(row, controls.read(row.name));
    }
  }
  return out;
}

bool add_numbers(const Value& value, std::vector<double>& numbers) {
  return std::visit(
      Overload{[&](std::int64_t whole) {
                 numbers.push_back(static_cast<double>(whole));
                 return true;
               },
               [&](bool truth) {
                 numbers.push_back(truth ? 1.0 : 0.0);
                 return true;
               },
               [&](const Value::Number& number) {
                 numbers.push_back(number.si);
                 return true;
               },
               [&](const Value::List& list) {
                 return std::ranges::all_of(
                     list, [&](const Value& each) { return add_numbers(each, numbers); });
               },
               [&](const Value::Matrix& matrix) {
                 numbers.insert(numbers.end(), matrix.elements.begin(), matrix.elements.end());
                 return true;
               },
               [](const auto&) { return false; }},
      value.content());
}

void add_units(const Value& value, std::vector<std::string>& units) {
  std::visit(Overload{[&](const Value::Number& number) { units.push_back(si_unit(number.dim)); },
                      [&](const Value::List& list) {
                        for (const Value& each : list) add_units(each, units);
                      },
                      [&](const Value::Matrix& matrix) {
                        units.resize(units.size() + matrix.elements.size());
                      },
                      [&](const auto&) { units.emplace_back(); }},
             value.content());
}

// ---- plots ----------------------------------------------------------------------------------

PlotReader::PlotReader(const SessionOptions& options, RunRecord& record)
    : record_(record), session_(std::make_unique<Session>(library_engine(), options)) {
  static_cast<void>(session_->replay(record.log));
  end_ns_ = to_ns(record.t_end);
  step_ns_ = std::max(kPlotStep_ns, end_ns_ / kPlotPoints);
  record_.element_rows.clear();
  const std::int64_t points = end_ns_ / step_ns_ + 1;
  views_every_ = std::max<std::int64_t>(1, (points + kWayPoints - 1) / kWayPoints);
  for (const LabRow& row : record_.lab->rows.rows)
    draws_ = draws_ || (row.kind == LabRowKind::kView && row.takes_picture);
}

bool PlotReader::advance() {
  for (int i = 0; i < kPointsInSlice; ++i) {
    if (next_ns_ > end_ns_) return false;
    const std::uint64_t steps = session_->vm() == nullptr ? 0 : session_->result().steps;
    const Progress progress = session_->run({.until_ns = next_ns_, .steps = kSliceSteps});
    if (progress == Progress::kPaused && session_->result().steps - steps >= kSliceSteps)
      return true;
    if (progress == Progress::kFailed || progress == Progress::kCancelled) return false;
    const bool views = points_++ % views_every_ == 0 || next_ns_ == end_ns_;
    read_all(to_seconds(next_ns_), views);
    if (progress != Progress::kPaused) return false;
    if (views && draws_) i = kPointsInSlice;  // a picture takes as long as that many points
    next_ns_ = next_ns_ < end_ns_ ? std::min(next_ns_ + step_ns_, end_ns_) : end_ns_ + 1;
  }
  return true;
}

void PlotReader::read_all(double t, bool views) {
  LabControls controls(*session_);
  const std::vector<LabRow>& elements = record_.lab->rows.rows;
  while (record_.element_rows.size() < elements.size()) record_.element_rows.emplace_back(1);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const bool is_wanted =
        elements[i].kind == LabRowKind::kPlot || (elements[i].kind == LabRowKind::kView && views);
    if (!is_wanted || !elements[i].is_read) continue;
    const Result<Value> read = controls.read(elements[i].name);
    std::vector<double> row{t};
    if (!read.ok() || !add_numbers(*read, row) || row.size() > kMostColumns || row.size() == 1)
      continue;
    if (!std::ranges::all_of(row, [](double each) { return std::isfinite(each); })) continue;
    Rows& rows = record_.element_rows[i];
    if (rows.columns() != row.size()) {
      if (rows.count() != 0) continue;
      rows = Rows(row.size());
      record_.lab->units.resize(elements.size());
      record_.lab->units[i].clear();
      add_units(*read, record_.lab->units[i]);
      ++record_.described;
    }
    rows.add(row);
  }
}

}  // namespace armlet::lab
