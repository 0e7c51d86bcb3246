#pragma once
// A laboratory: one program, its runs, and the pages that look at them. It speaks the messages of
// docs/lab-protocol.md and knows no socket, no thread and no file:
//
//     Laboratory laboratory({.session = ..., .file = "cell.rbt", .text = ...});
//     const int page = laboratory.join();
//     laboratory.receive(page, R"({"type": "hello", "protocol": 1})");
//     while (laboratory.advance()) {}
//     for (const Message& each : laboratory.take_messages(page, 1'000'000)) send(each);
//
// A page that takes its messages slowly costs nothing: what it has not been told is read from the
// record of the run when it asks. All functions are called from one thread at a time; only
// interrupt() may come from any.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/stdlib/session.hpp"
#include "kept_file.hpp"
#include "messages/write_message.hpp"
#include "runs/live_run.hpp"

namespace armlet::lab {

// session  robot, world, imports and folder of all runs.
// bounds   of each run. `most_runs` and `most_bytes` are kept; the oldest go first.
struct LaboratoryOptions {
  SessionOptions session{};
  std::string file = "program.rbt";
  std::string text{};
  std::string version{};  // of Armlet
  bool is_demo = false;
  RunBounds bounds{};
  std::size_t most_runs = 24;
  std::size_t most_bytes = std::size_t{192} << 20U;
  int most_pages = 64;
  std::size_t most_picture_bytes = std::size_t{96} << 20U;  // of cameras, kept for all runs
  std::size_t most_kept_bytes = std::size_t{512} << 20U;    // of files that pages send
  // Keeps a file beside the program, under this name or, where another file has it, one like it,
  // which is returned; or says why not, as a sentence. Null: nothing can be kept. A name without
  // letters: it is kept for what comes later.
  std::function<Result<KeptFile>(const std::string& name, std::string bytes)> keep_file{};
};

class Laboratory {
 public:
  explicit Laboratory(LaboratoryOptions options);
  ~Laboratory();
  Laboratory(const Laboratory&) = delete;
  Laboratory& operator=(const Laboratory&) = delete;

  // A page that has connected; -1: there are as many as there may be.
  int join();
  void leave(int page);
  // One message of a page. Whatever it holds, the laboratory goes on.
  void receive(int page, std::string_view message);
  // Whether answers pile up that the page does not take: what it sends is better left waiting.
  [[nodiscard]] bool is_full(int page) const;

  // Works for some milliseconds. Returns whether there is more to do.
  bool advance();

  // What the page has not been told yet, as far as it fits into so many bytes, but at least one
  // message.
  [[nodiscard]] std::vector<Message> take_messages(int page, std::size_t most_bytes);

  // Ends what advance() or receive() does at the moment, if that takes too long; from any thread.
  void interrupt() noexcept;

  // The bytes of a file that pages draw, by its name in a description; from any thread. Null: there
  // is none, or no run is left that shows it.
  [[nodiscard]] FileBytes file(std::string_view name) const;

  // The newest text that a page has sent.
  [[nodiscard]] const std::string& text() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace armlet::lab
