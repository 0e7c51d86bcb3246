#include "connections.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "armlet/core/platform.hpp"

namespace armlet::lab {
namespace {

constexpr std::size_t kMostWaiting = 64;          // messages of one page
constexpr std::size_t kMostAtOnce = 1024 * 1024;  // bytes of messages that are taken at a time
constexpr std::int64_t kBetweenLooks_ns = 400'000'000;  // at the file of the program

}  // namespace

// ---- one page -------------------------------------------------------------------------------

Connection::Connection(std::function<bool(const Message&)> send, std::function<void()> on_message)
    : send_(std::move(send)), on_message_(std::move(on_message)), sender_([this] { send_all(); }) {}

Connection::~Connection() {
  close();
  if (sender_.joinable()) sender_.join();
}

bool Connection::receive(std::string_view piece, bool is_last) {
  if (begun_.size() + piece.size() > kMostMessageBytes) return false;
  begun_.append(piece);
  if (!is_last) return true;
  {
    std::unique_lock lock(mutex_);
    // The socket is not read until the laboratory has taken a message.
    changed_.wait(lock, [this] { return inbox_.size() < kMostWaiting || is_closed_; });
    if (is_closed_) return false;
    inbox_.push_back(std::move(begun_));
  }
  begun_.clear();
  on_message_();
  return true;
}

bool Connection::give_up() {
  bool was_open = false;
  {
    const std::lock_guard lock(mutex_);
    was_open = !is_closed_.exchange(true);
  }
  changed_.notify_all();
  return was_open;
}

void Connection::close() {
  if (give_up()) on_message_();  // reports that the page has left
  if (sender_.joinable() && sender_.get_id() != std::this_thread::get_id()) sender_.join();
}

std::optional<std::string> Connection::next() {
  std::optional<std::string> message;
  {
    const std::lock_guard lock(mutex_);
    if (inbox_.empty()) return message;
    message = std::move(inbox_.front());
    inbox_.pop_front();
  }
  changed_.notify_all();
  return message;
}

bool Connection::wants_messages() {
  const std::lock_guard lock(mutex_);
  return outbox_.empty() && !is_sending_ && !is_closed_;
}

void Connection::send(std::vector<Message> messages) {
  {
    const std::lock_guard lock(mutex_);
    outbox_ = std::move(messages);
  }
  changed_.notify_all();
}

void Connection::send_all() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return !outbox_.empty() || is_closed_; });
    if (is_closed_) return;
    const std::vector<Message> messages = std::exchange(outbox_, {});
    is_sending_ = true;
    lock.unlock();
    const bool all_sent = std::ranges::all_of(
        messages, [&](const Message& each) { return !is_closed_ && send_(each); });
    lock.lock();
    is_sending_ = false;
    if (!all_sent) is_closed_ = true;
    lock.unlock();
    if (!all_sent) changed_.notify_all();
    on_message_();
    lock.lock();
  }
}

// ---- all pages ------------------------------------------------------------------------------

void Connections::wake() {
  {
    const std::lock_guard lock(mutex_);
    has_news_ = true;
  }
  news_.notify_one();
}

std::shared_ptr<Connection> Connections::add(std::function<bool(const Message&)> send) {
  std::shared_ptr<Connection> connection;
  {
    const std::lock_guard lock(mutex_);
    if (all_.size() >= kMost || is_over_) return nullptr;
    connection = std::make_shared<Connection>(std::move(send), [this] { wake(); });
    all_.push_back(connection);
  }
  wake();
  return connection;
}

void Connections::end() {
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
    for (const auto& each : all_) each->give_up();
  }
  news_.notify_one();
}

bool Connections::is_full() {
  const std::lock_guard lock(mutex_);
  return all_.size() >= kMost || is_over_;
}

// Passes on one message of each page, so that no page waits for another. Whether there were any.
bool Connections::hand_in() {
  std::vector<std::shared_ptr<Connection>> present;
  {
    const std::lock_guard lock(mutex_);
    present.assign(all_.begin(), all_.end());
  }
  bool any = false;
  for (const auto& each : present) {
    if (each->page == 0 && !each->is_closed()) each->page = laboratory_.join();
    if (each->is_closed() || each->page < 0) {
      each->give_up();
      laboratory_.leave(each->page);
      const std::lock_guard lock(mutex_);
      all_.remove(each);
      continue;
    }
    if (laboratory_.is_full(each->page)) continue;
    if (const auto message = each->next()) {
      laboratory_.receive(each->page, *message);
      any = true;
    }
  }
  return any;
}

void Connections::hand_out() {
  std::vector<std::shared_ptr<Connection>> present;
  {
    const std::lock_guard lock(mutex_);
    present.assign(all_.begin(), all_.end());
  }
  for (const auto& each : present) {
    if (each->page <= 0 || !each->wants_messages()) continue;
    std::vector<Message> messages = laboratory_.take_messages(each->page, kMostAtOnce);
    if (!messages.empty()) each->send(std::move(messages));
  }
}

void Connections::work() {
  bool is_busy = true;
  std::int64_t next_look = 0;
  while (true) {
    {
      std::unique_lock lock(mutex_);
      if (!is_busy) {
        news_.wait_for(lock, std::chrono::nanoseconds(kBetweenLooks_ns),
                       [this] { return has_news_ || is_over_; });
      }
      if (is_over_) return;
      has_news_ = false;
    }
    busy_since_ = steady_time_ns();
    if (busy_since_ >= next_look) {
      laboratory_.look_at_file();
      next_look = busy_since_ + kBetweenLooks_ns;
    }
    is_busy = hand_in();
    if (is_busy) hand_out();  // a page that has asked need not wait for the run
    is_busy = laboratory_.advance() || is_busy;
    hand_out();
    busy_since_ = 0;
  }
}

}  // namespace armlet::lab
