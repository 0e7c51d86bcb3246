// Messages that a page has not received yet.

#include <algorithm>
#include <utility>

#include "laboratory_state.hpp"

namespace armlet::lab {
namespace {

constexpr std::size_t kItemsInMessage = 2000;
constexpr std::size_t kBytesInRows = 256 * 1024;

// A list of messages of limited size in bytes.
class Parcel {
 public:
  explicit Parcel(std::size_t most) : most_(most) {}

  [[nodiscard]] bool is_full() const { return bytes_ >= most_; }
  void add(Message message) {
    bytes_ += message.bytes.size();
    messages_.push_back(std::move(message));
  }
  [[nodiscard]] std::vector<Message> take() { return std::move(messages_); }

 private:
  std::size_t most_;
  std::size_t bytes_ = 0;
  std::vector<Message> messages_;
};

// Adds the rest of a list, in several messages.
template <class Write>
void add_items(Parcel& parcel, std::size_t& known, std::size_t size, const Write& write) {
  while (known < size && !parcel.is_full()) {
    const std::size_t count = std::min(size - known, kItemsInMessage);
    parcel.add(write(known, count));
    known += count;
  }
}

void add_rows(Parcel& parcel, std::uint32_t kind, int run, const std::vector<Rows>& all,
              std::vector<std::size_t>& known) {
  known.resize(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::size_t most = std::max<std::size_t>(1, kBytesInRows / (8 * all[i].columns()));
    while (known[i] < all[i].count() && !parcel.is_full()) {
      const std::size_t count = std::min(all[i].count() - known[i], most);
      parcel.add(write_rows(kind, run, i, all[i], known[i], count));
      known[i] += count;
    }
  }
}

// The head of a run is sent first, and again in its last state when everything else has been sent.
void add_run(Parcel& parcel, const RunRecord& run, KnownOfRun& known) {
  if (known.changes == 0) {
    RunRecord begun;
    begun.number = run.number;
    begun.t_end = run.t_end;
    begun.label = run.label;
    begun.parent = run.parent;
    begun.text_version = run.text_version;
    begun.inputs = run.inputs;
    parcel.add(write_run(begun));
    known.changes = 1;
  }
  if (known.described != run.described) {
    parcel.add(write_description(run));
    known.described = run.described;
  }
  add_items(parcel, known.events, run.events.size(),
            [&](auto first, auto count) { return write_events(run, first, count); });
  add_items(parcel, known.moves, run.moves.size(),
            [&](auto first, auto count) { return write_moves(run, first, count); });
  add_items(parcel, known.ways, run.ways.size(),
            [&](auto first, auto count) { return write_ways(run, first, count); });
  add_items(parcel, known.stretches, run.stretches.size(),
            [&](auto first, auto count) { return write_stretches(run, first, count); });
  add_items(parcel, known.lines, run.lines.size(),
            [&](auto first, auto count) { return write_lines(run, first, count); });
  add_items(parcel, known.texts, run.texts.size(),
            [&](auto first, auto count) { return write_notes(run, first, count); });
  add_items(parcel, known.advice, run.advice.size(),
            [&](auto first, auto count) { return write_advice(run, first, count); });
  add_items(parcel, known.drawn, run.drawings.list().size(),
            [&](auto first, auto count) { return write_drawings(run, first, count); });
  add_rows(parcel, 1, run.number, run.robot_rows, known.robots);
  add_rows(parcel, 2, run.number, run.object_rows, known.objects);
  add_rows(parcel, 3, run.number, run.element_rows, known.elements);
  add_rows(parcel, 4, run.number, run.force_rows, known.forces);
  add_rows(parcel, 5, run.number, run.contact_rows, known.contacts);
  add_rows(parcel, 7, run.number, run.drawings.rows(), known.drawings);
  if (parcel.is_full()) return;
  if (known.figures != run.figure_changes) {
    for (const RecordedFigure& figure : run.figures) parcel.add(write_figure(run, figure));
    known.figures = run.figure_changes;
  }
  if (known.changes != run.changes) {
    parcel.add(write_run(run));
    known.changes = run.changes;
  }
}

}  // namespace

std::vector<Message> Laboratory::State::take_messages(Page& page, std::size_t most_bytes) {
  Parcel parcel(most_bytes);
  while (!page.answers.empty() && !parcel.is_full()) {
    page.answer_bytes -= page.answers.front().bytes.size();
    parcel.add(std::move(page.answers.front()));
    page.answers.pop_front();
  }
  if (!page.is_greeted || parcel.is_full()) return parcel.take();

  const auto news = [&](std::uint64_t& known, std::uint64_t now) {
    return std::exchange(known, now) != now;
  };
  if (news(page.known.control, pages.control_changes())) parcel.add(write_control(pages.control()));
  if (news(page.known.text, versions.text) && text.from != page.number)
    parcel.add(write_text(text.now, text.version, text.from));
  if (news(page.known.document, versions.document)) parcel.add(write_document(text.document));
  if (news(page.known.diagnostics, versions.diagnostics))
    parcel.add(write_diagnostics(text.version, text.runs, text.diagnostics));
  if (news(page.known.breakpoints, versions.breakpoints))
    parcel.add(write_breakpoints({}, breakpoints.lines, breakpoints.known));
  if (news(page.known.runs, versions.runs)) parcel.add(write_runs(runs));
  const RunRecord* run = find_run(shown);
  if (news(page.known.shown, versions.shown) && run != nullptr) parcel.add(write_shown(shown));
  if (news(page.known.cursor, versions.cursor) && cursor) {
    parcel.add(cursor->elements);
    parcel.add(cursor->instant);
  }
  if (run != nullptr && !parcel.is_full()) add_run(parcel, *run, page.runs[shown]);
  for (const int wanted : page.wanted) {
    const RunRecord* other = find_run(wanted);
    if (other != nullptr && wanted != shown && !parcel.is_full())
      add_run(parcel, *other, page.runs[wanted]);
  }
  return parcel.take();
}

}  // namespace armlet::lab
