#pragma once
// How much of a frame has been read that is not whole yet.
//
// civetweb takes a frame of up to 2 GB into memory before anybody can refuse it. So the bytes that
// the process has read from the socket since the last piece of a message are watched from outside.

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>

namespace armlet::lab {

class FrameGuard {
 public:
  // address, port  the other end, which says which of the sockets of this process it is.
  FrameGuard(const std::string& address, int port);

  // ---- the thread of the socket
  // A piece of a message has come out.
  void came_out();
  // The socket is about to be closed: its number may soon belong to another.
  void release();

  // ---- any thread
  // Ends the connection if more than so many bytes wait for the end of their frame. Whether it did.
  bool cut_beyond(std::size_t bytes);

 private:
  // Bytes that the process has read from the socket.
  [[nodiscard]] std::uint64_t read_bytes() const;

  std::mutex mutex_;
  int socket_ = -1;  // -1: unknown, or closed
  std::uint64_t read_before_ = 0;
};

}  // namespace armlet::lab
