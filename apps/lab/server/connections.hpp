#pragma once
// The connected pages, between the threads of their sockets and the thread of the laboratory.

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "laboratory.hpp"

namespace armlet::lab {

// One page. The thread of its socket adds messages, and waits while there are too many; a second
// thread sends messages at the speed of the page.
class Connection {
 public:
  // send        writes a message to the socket; false: the connection is lost.
  // on_message  called when a message has arrived or was sent, and when the connection has closed.
  Connection(std::function<bool(const Message&)> send, std::function<void()> on_message);
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  // ---- the thread of the socket
  // A piece of a message. False: it is too long, and the connection must be closed.
  bool receive(std::string_view piece, bool is_last);
  // After this nothing is sent or received.
  void close();
  // Closes the connection without waiting for a message that is being sent; may be called from any
  // thread. Returns whether it was open.
  bool give_up();

  // ---- the thread of the laboratory
  // The oldest message; nullopt: there is none.
  [[nodiscard]] std::optional<std::string> next();
  [[nodiscard]] bool wants_messages();
  void send(std::vector<Message> messages);
  [[nodiscard]] bool is_closed() const { return is_closed_.load(); }

  int page = 0;  // its number in the laboratory; 0: it has not joined

 private:
  void send_all();

  std::function<bool(const Message&)> send_;
  std::function<void()> on_message_;
  std::string begun_;  // of a message in pieces
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::string> inbox_;
  std::vector<Message> outbox_;
  bool is_sending_ = false;
  std::atomic<bool> is_closed_{false};
  std::thread sender_;
};

// All pages, and the loop in which the laboratory works.
class Connections {
 public:
  explicit Connections(Laboratory& laboratory) : laboratory_(laboratory) {}

  // Null: there are too many already.
  std::shared_ptr<Connection> add(std::function<bool(const Message&)> send);
  [[nodiscard]] bool is_full();
  // Works until `end()` is called, in the calling thread.
  void work();
  void end();
  // The start of the present piece of work of the laboratory, steady time in ns; 0: it is idle.
  [[nodiscard]] std::int64_t busy_since() const { return busy_since_.load(); }

 private:
  static constexpr std::size_t kMost = 48;

  bool hand_in();
  void hand_out();
  void wake();

  Laboratory& laboratory_;
  std::mutex mutex_;
  std::condition_variable news_;
  std::list<std::shared_ptr<Connection>> all_;
  bool has_news_ = false;
  bool is_over_ = false;
  std::atomic<std::int64_t> busy_since_{0};
};

}  // namespace armlet::lab
