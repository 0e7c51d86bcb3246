#pragma once
// The elements of a laboratory's page: what they are, what they show, what is done at them.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "armlet/core/error.hpp"
#include "record.hpp"

namespace armlet::lab {

// The elements that a run has come to; `known` if nothing has changed.
[[nodiscard]] std::optional<LabElements> lab_of(Session& session, std::optional<LabElements> known);

// Does to the run what somebody did at its page. Why not, if it is refused.
[[nodiscard]] std::optional<Error> apply_input(Session& session, const InputWhat& input);

// What an element shows at an instant.
struct ElementValue {
  std::string name;
  Value value{};
  std::string fault{};  // why there is none
};
// Of all fields, hands, tables and texts that change.
[[nodiscard]] std::vector<ElementValue> element_values(Session& session, const LabElements& lab);

// Numbers of a value in the order in which they stand in it, SI; false: it holds something else.
[[nodiscard]] bool add_numbers(const Value& value, std::vector<double>& numbers);
// The units of the numbers that add_numbers gives.
void add_units(const Value& value, std::vector<std::string>& units);

// Takes a run once more, unheard, and reads its plots and the features of its views at even times.
class PlotReader {
 public:
  PlotReader(const SessionOptions& options, RunRecord& record);

  // Reads some. Returns whether there are more.
  bool advance();
  [[nodiscard]] int run() const { return record_.number; }
  [[nodiscard]] Session& session() { return *session_; }

 private:
  void read_all(double t, bool views);

  RunRecord& record_;
  std::unique_ptr<Session> session_;
  std::int64_t next_ns_ = 0;
  std::int64_t step_ns_ = 0;
  std::int64_t end_ns_ = 0;
  std::int64_t points_ = 0;
  std::int64_t views_every_ = 1;  // of the points, views are read at one of so many
  bool draws_ = false;            // a view needs a picture for its features
};

}  // namespace armlet::lab
