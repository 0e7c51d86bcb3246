#pragma once
// Shapes of a run that are displayed but have no effect.

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "armlet/backend/event.hpp"
#include "messages/text_places.hpp"
#include "rows.hpp"

namespace armlet::lab {

// The properties of a shape that stay the same while its pose and sizes change.
struct RecordedDrawing {
  double t = 0.0;  // when it was drawn first
  DrawingInfo info;
  std::optional<TextSpan> span;
};

// All shapes of a run, with a new entry when one gets other properties, and one list of rows with
// their poses: t, number, x, y, z, qw, qx, qy, qz, and three sizes, all zero after its removal.
class RecordedDrawings {
 public:
  void take(const DrawingChanged& changed, double t, const std::optional<TextSpan>& here);
  // Adds the last row of each shape if it was left out.
  void flush();

  [[nodiscard]] const std::vector<RecordedDrawing>& list() const { return list_; }
  [[nodiscard]] const std::vector<Rows>& rows() const { return rows_; }
  [[nodiscard]] std::size_t bytes() const {
    return rows_[0].bytes() + list_.size() * sizeof(RecordedDrawing);
  }

 private:
  static constexpr std::size_t kColumns = 12;
  // Beyond this number of rows only every second of each shape is kept, then every fourth ...
  static constexpr std::size_t kMostRows = 300'000;
  static constexpr std::size_t kMostShapes = 50'000;
  using Row = std::array<double, kColumns>;

  // The properties of a shape: name, kind, text, colour, and what it is mounted on.
  using Key = std::tuple<std::string, std::string, std::string, std::string, int, int, std::string>;
  // The number of rows left out since the last one, and the newest of them.
  struct LeftOut {
    std::size_t count = 0;
    std::optional<Row> newest{};
  };
  void add(std::size_t number, const Row& row, bool is_kept);
  void end(const std::string& name, double t);

  std::vector<RecordedDrawing> list_;
  std::vector<Rows> rows_{Rows(kColumns)};
  std::vector<LeftOut> left_out_;             // of each shape of the list
  std::map<Key, std::size_t> numbers_;        // index in the list
  std::map<std::string, std::size_t> shown_;  // by name: index of the present entry
};

}  // namespace armlet::lab
