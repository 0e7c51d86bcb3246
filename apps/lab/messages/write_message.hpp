#pragma once
// Messages to pages as JSON (docs/lab-protocol.md).

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/interpreter/editor/analysis.hpp"
#include "armlet/stdlib/laboratory_controls.hpp"
#include "kept_file.hpp"
#include "program_file.hpp"
#include "runs/lab_elements.hpp"
#include "runs/looker.hpp"
#include "runs/record.hpp"
#include "text_message.hpp"

namespace armlet::lab {

using Seq = std::optional<std::int64_t>;

// One message to a page.
struct Message {
  std::string bytes;
  bool is_binary = false;
};

struct Welcome {
  int page = 0;
  std::string key;
  std::string version;
  std::string file;
  std::string text;
  std::int64_t text_version = 0;
  bool is_demo = false;
  // Words of the language by kind, for highlighting.
  std::map<std::string, std::vector<std::string>> words;
};
struct ControlState {
  std::optional<int> holder;
  std::vector<int> pages;
  std::vector<int> wishes;
  std::map<int, std::string> names;  // of the people at pages that have told them
};

[[nodiscard]] Message write_welcome(const Welcome& welcome, Seq to);
[[nodiscard]] Message write_document(const Document& document);
[[nodiscard]] Message write_saved(Seq to);
[[nodiscard]] Message write_control(const ControlState& control);
[[nodiscard]] Message write_text(const std::string& text, std::int64_t version, int from);
[[nodiscard]] Message write_diagnostics(std::int64_t text_version, bool runs,
                                        const std::vector<TextMessage>& items);
[[nodiscard]] Message write_error(Seq to, std::string_view reason, std::string_view message,
                                  const UnreachedGoal* unreached = nullptr);
[[nodiscard]] Message write_completion(Seq to, const Analysis& analysis, std::uint32_t at);
[[nodiscard]] Message write_hover(Seq to, const Analysis& analysis, std::uint32_t at);
[[nodiscard]] Message write_signature(Seq to, const Analysis& analysis, std::uint32_t at);
[[nodiscard]] Message write_definition(Seq to, const Analysis& analysis, std::uint32_t at);
[[nodiscard]] Message write_formatted(Seq to, const std::optional<std::string>& text,
                                      const std::vector<TextMessage>& problems);
[[nodiscard]] Message write_breakpoints(Seq to, const std::vector<int>& lines,
                                        const std::vector<int>& known);
// values  of elements, if they are part of this message; null: they have a message of their own.
[[nodiscard]] Message write_instant(Seq to, const SeenInstant& instant, bool is_cursor,
                                    const std::vector<ElementValue>* values = nullptr);

// nearest  joint values and pose nearest to the goal, if there is no solution.
struct InverseAnswer {
  struct Nearest {
    std::vector<double> q;
    Eigen::Isometry3d T_world_tool = Eigen::Isometry3d::Identity();
    double distance = 0.0;
    double angle = 0.0;
  };
  bool is_ok = false;
  std::vector<double> q;
  std::string reason;
  std::optional<Nearest> nearest;
};
[[nodiscard]] Message write_inverse(Seq to, const InverseAnswer& answer);
struct Comparison {
  int run = 0;
  int with = 0;
  bool is_same = false;
  double same_until = 0.0;
  double parts_at = 0.0;
  int line = 0;
  int line_with = 0;
};
[[nodiscard]] Message write_comparison(Seq to, const Comparison& comparison);

// ---- runs
using RunList = std::vector<std::unique_ptr<RunRecord>>;
[[nodiscard]] Message write_runs(const RunList& runs);
[[nodiscard]] Message write_shown(int run);
[[nodiscard]] Message write_run(const RunRecord& run);
[[nodiscard]] Message write_description(const RunRecord& run);
// Parts of lists, from index `first`, at most `count` items.
[[nodiscard]] Message write_moves(const RunRecord& run, std::size_t first, std::size_t count);
[[nodiscard]] Message write_ways(const RunRecord& run, std::size_t first, std::size_t count);
[[nodiscard]] Message write_stretches(const RunRecord& run, std::size_t first, std::size_t count);
[[nodiscard]] Message write_lines(const RunRecord& run, std::size_t first, std::size_t count);
[[nodiscard]] Message write_events(const RunRecord& run, std::size_t first, std::size_t count);
[[nodiscard]] Message write_drawings(const RunRecord& run, std::size_t first, std::size_t count);
[[nodiscard]] Message write_notes(const RunRecord& run, std::size_t first, std::size_t count);
[[nodiscard]] Message write_advice(const RunRecord& run, std::size_t first, std::size_t count);
[[nodiscard]] Message write_figure(const RunRecord& run, const RecordedFigure& figure);
// The contents of elements at an instant.
[[nodiscard]] Message write_elements(Seq to, int run, double t,
                                     const std::vector<ElementValue>& values);
[[nodiscard]] Message write_taken(Seq to, int run);
// The bytes of a file that a page has requested in its message number `to`.
inline constexpr std::uint32_t kFileMessage = 6;
[[nodiscard]] Message write_file(std::uint32_t to, std::string_view bytes);
// The picture of an element that a page has requested in its message number `to`, with its marks.
inline constexpr std::uint32_t kPictureMessage = 8;
[[nodiscard]] Message write_picture(std::uint32_t to, const LabPicture& picture);
// The answer to a page whose file was saved: its name.
[[nodiscard]] Message write_kept(Seq to, const KeptFile& kept);
// A laboratory in the form in which another one can continue it.
//
// world  given by the user; null: the default one of the command.
// text   the newest text; it need not have run.
// files  that the program imports and loads, by their paths from its folder.
struct Exported {
  std::string version;
  std::string robot;
  const WorldText* world = nullptr;
  std::string file;
  std::string text;
  bool is_demo = false;
  const std::map<std::string, std::string>& files;
  const RunList& runs;
  int shown = 0;
};
[[nodiscard]] Message write_exported(Seq to, const Exported& exported);
// kind  1 robot, 2 object, 3 element, 4 forces, 5 contact, 7 drawings.
[[nodiscard]] Message write_rows(std::uint32_t kind, int run, std::size_t index, const Rows& rows,
                                 std::size_t first, std::size_t count);

}  // namespace armlet::lab
