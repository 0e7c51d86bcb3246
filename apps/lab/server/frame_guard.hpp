#pragma once
// Limits the size of incomplete WebSocket frames.
//
// civetweb reads a frame of up to 2 GB into memory before it can be refused. Therefore this class
// watches how many bytes the process has read from the socket since the last piece of a message.

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>

namespace armlet::lab {

class FrameGuard {
 public:
  // address, port  of the other end; they identify the socket among those of this process.
  FrameGuard(const std::string& address, int port);

  // ---- the thread of the socket
  // Called when a piece of a message has been received.
  void came_out();
  // Called before the socket is closed: its number may soon belong to another one.
  void release();

  // ---- any thread
  // Closes the connection if an incomplete frame has more bytes. Returns whether it did.
  bool cut_beyond(std::size_t bytes);

 private:
  // The bytes that the process has read from the socket.
  [[nodiscard]] std::uint64_t read_bytes() const;

  std::mutex mutex_;
  int socket_ = -1;  // -1: unknown, or closed
  std::uint64_t read_before_ = 0;
};

}  // namespace armlet::lab
