#pragma once
// The pages that are connected, between the threads of their sockets and the one of the laboratory.

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

// One page. Its socket's thread puts messages in and waits while too many lie there; a thread of
// its own sends what comes out, as slowly as the page takes it.
class Connection {
 public:
  // send        writes a message to the socket; false: it cannot be reached any more.
  // on_message  called when something has arrived or was sent, and when it has closed.
  Connection(std::function<bool(const Message&)> send, std::function<void()> on_message);
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  // ---- the thread of the socket
  // A piece of a message. False: it is too long, and the connection is to be closed.
  bool receive(std::string_view piece, bool is_last);
  // Nothing is sent from here on, and nothing arrives.
  void close();
  // The same, without waiting for a message that is on its way; from any thread. Whether it was
  // open.
  bool give_up();

  // ---- the thread of the laboratory
  // The oldest message; nothing: there is none.
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

// All of them, and the loop in which the laboratory works.
class Connections {
 public:
  explicit Connections(Laboratory& laboratory) : laboratory_(laboratory) {}

  // Null: there are as many as there may be.
  std::shared_ptr<Connection> add(std::function<bool(const Message&)> send);
  [[nodiscard]] bool is_full();
  // Works until `end()`, in the thread that calls it.
  void work();
  void end();
  // Since when the laboratory is at one piece of work, steady time in ns; 0: it is at none.
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
