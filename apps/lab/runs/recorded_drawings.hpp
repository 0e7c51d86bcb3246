#pragma once
// Shapes of a run that are only shown.

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

// What a shape is while only its place and its sizes change.
struct RecordedDrawing {
  double t = 0.0;  // when it was drawn first
  DrawingInfo info;
  std::optional<TextSpan> span;
};

// All shapes of a run, each as often as it became another one, and in one list of rows where they
// were: t, number, x, y, z, qw, qx, qy, qz, and three sizes, which are zero from where it is gone.
class RecordedDrawings {
 public:
  void take(const DrawingChanged& changed, double t, const std::optional<TextSpan>& here);
  // The last row of each shape that was left out.
  void flush();

  [[nodiscard]] const std::vector<RecordedDrawing>& list() const { return list_; }
  [[nodiscard]] const std::vector<Rows>& rows() const { return rows_; }
  [[nodiscard]] std::size_t bytes() const {
    return rows_[0].bytes() + list_.size() * sizeof(RecordedDrawing);
  }

 private:
  static constexpr std::size_t kColumns = 12;
  // Beyond so many rows half of those of each shape are left out, and again half for as many more.
  static constexpr std::size_t kMostRows = 300'000;
  static constexpr std::size_t kMostShapes = 50'000;
  using Row = std::array<double, kColumns>;

  // What makes it another one: name, kind, text, colour, and what it is on.
  using Key = std::tuple<std::string, std::string, std::string, std::string, int, int, std::string>;
  // Rows that were left out since the last one, and the newest of them.
  struct LeftOut {
    std::size_t count = 0;
    std::optional<Row> newest{};
  };
  void add(std::size_t number, const Row& row, bool is_kept);
  void end(const std::string& name, double t);

  std::vector<RecordedDrawing> list_;
  std::vector<Rows> rows_{Rows(kColumns)};
  std::vector<LeftOut> left_out_;             // of each shape of the list
  std::map<Key, std::size_t> numbers_;        // in the list
  std::map<std::string, std::size_t> shown_;  // by name: the number of the one that is shown
};

}  // namespace armlet::lab
