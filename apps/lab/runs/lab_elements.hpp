#pragma once
// The elements of a laboratory's page: their descriptions, contents and inputs.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "armlet/core/error.hpp"
#include "record.hpp"

namespace armlet::lab {

// The elements of a run so far; `known` if they have not changed.
[[nodiscard]] std::optional<LabElements> lab_of(Session& session, std::optional<LabElements> known);

// Applies an input of a user to the run. Returns the reason if it is refused.
[[nodiscard]] std::optional<Error> apply_input(Session& session, const InputWhat& input);

// The content of an element at an instant.
struct ElementValue {
  std::string name;
  Value value{};
  std::string fault{};  // why there is no value
};
// The values of all fields, sliders of the tool pose, tables, and texts that change.
[[nodiscard]] std::vector<ElementValue> element_values(Session& session, const LabElements& lab);

// Adds the numbers of a value in their order, SI; false: it holds a value of another type.
[[nodiscard]] bool add_numbers(const Value& value, std::vector<double>& numbers);
// Adds the units of the numbers that add_numbers adds.
void add_units(const Value& value, std::vector<std::string>& units);

// Replays a run silently and reads its plots and the features of its views at equal intervals.
class PlotReader {
 public:
  PlotReader(const SessionOptions& options, RunRecord& record);

  // Reads some points. Returns whether there are more.
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
  std::int64_t views_every_ = 1;  // views are read at every n-th point, n this number
  bool draws_ = false;            // a view needs a picture for its features
};

}  // namespace armlet::lab
