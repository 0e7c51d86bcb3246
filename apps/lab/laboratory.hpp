#pragma once
// A laboratory: one program, its runs, and the pages that show them. It exchanges the messages of
// docs/lab-protocol.md and uses no socket, no thread and no file:
//
//     Laboratory laboratory({.session = ..., .file = "cell.rbt", .text = ...});
//     const int page = laboratory.join();
//     laboratory.receive(page, R"({"type": "hello", "protocol": 1})");
//     while (laboratory.advance()) {}
//     for (const Message& each : laboratory.take_messages(page, 1'000'000)) send(each);
//
// A slow page needs no memory: messages are made from the record of the run when the page takes
// them. All functions are called from one thread at a time; only interrupt() may be called from
// any thread.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/stdlib/session.hpp"
#include "kept_file.hpp"
#include "messages/write_message.hpp"
#include "program_file.hpp"
#include "runs/live_run.hpp"

namespace armlet::lab {

// session  robot, world, imports and folder of all runs.
// bounds   of each run. `most_runs` runs with `most_bytes` are kept; the oldest are dropped.
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
  std::size_t most_picture_bytes = std::size_t{96} << 20U;  // of cameras, for all runs together
  std::size_t most_kept_bytes = std::size_t{512} << 20U;    // of files sent by pages
  // Saves a file beside the program, under this name or a similar one if another file has it;
  // returns the saved file, or an error that is a sentence. Null: files cannot be saved. An empty
  // name in the result: the file is stored for a mesh that comes later.
  std::function<Result<KeptFile>(const std::string& name, std::string bytes)> keep_file{};
  ProgramFile program_file{};
};

class Laboratory {
 public:
  explicit Laboratory(LaboratoryOptions options);
  ~Laboratory();
  Laboratory(const Laboratory&) = delete;
  Laboratory& operator=(const Laboratory&) = delete;

  // Adds a page and returns its number; -1: there are `most_pages` already.
  int join();
  void leave(int page);
  // Handles one message of a page. No message, however wrong, stops the laboratory.
  void receive(int page, std::string_view message);
  // Whether the page has not taken many answers; its next messages should then wait.
  [[nodiscard]] bool is_full(int page) const;

  // Works for some milliseconds. Returns whether there is more to do.
  bool advance();

  // Reads the file of the program, if there is one. A file that another program has changed becomes
  // the text of the laboratory if that has no unsaved edits.
  void look_at_file();

  // The messages for the page that are due, as many as fit into this number of bytes, but at least
  // one.
  [[nodiscard]] std::vector<Message> take_messages(int page, std::size_t most_bytes);

  // Ends the present work of advance() or receive() if it takes too long; from any thread.
  void interrupt() noexcept;

  // The bytes of a file that pages draw, by its name in a description; from any thread. Null: no
  // run that still exists shows such a file.
  [[nodiscard]] FileBytes file(std::string_view name) const;

  // The newest text sent by a page.
  [[nodiscard]] const std::string& text() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace armlet::lab
