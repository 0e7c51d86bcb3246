#include "frame_guard.hpp"

#include <linux/tcp.h>
#include <netdb.h>
#include <sys/ioctl.h>
#include <sys/resource.h>
#include <sys/socket.h>

#include <algorithm>

namespace armlet::lab {
namespace {

bool is_connected_to(int socket, const std::string& address, int port) {
  sockaddr_storage peer{};
  socklen_t size = sizeof peer;
  auto* const end = reinterpret_cast<sockaddr*>(&peer);
  char name[NI_MAXHOST] = {};
  char service[NI_MAXSERV] = {};
  return getpeername(socket, end, &size) == 0 &&
         (peer.ss_family == AF_INET || peer.ss_family == AF_INET6) &&
         getnameinfo(end, size, name, sizeof name, service, sizeof service,
                     NI_NUMERICHOST | NI_NUMERICSERV) == 0 &&
         service == std::to_string(port) && name == address;
}

// The socket connected to that address and port; -1: there is none.
int find_socket(const std::string& address, int port) {
  rlimit most{};
  if (getrlimit(RLIMIT_NOFILE, &most) != 0) return -1;
  const int end = static_cast<int>(std::min<rlim_t>(most.rlim_cur, 65'536));
  for (int socket = 3; socket < end; ++socket) {
    if (is_connected_to(socket, address, port)) return socket;
  }
  return -1;
}

}  // namespace

FrameGuard::FrameGuard(const std::string& address, int port) : socket_(find_socket(address, port)) {
  read_before_ = read_bytes();
}

std::uint64_t FrameGuard::read_bytes() const {
  tcp_info info{};
  socklen_t size = sizeof info;
  int unread = 0;
  if (socket_ < 0 || getsockopt(socket_, IPPROTO_TCP, TCP_INFO, &info, &size) != 0 ||
      ioctl(socket_, FIONREAD, &unread) != 0)
    return read_before_;
  const auto left = static_cast<std::uint64_t>(unread);
  return info.tcpi_bytes_received - std::min<std::uint64_t>(left, info.tcpi_bytes_received);
}

void FrameGuard::came_out() {
  const std::lock_guard lock(mutex_);
  read_before_ = read_bytes();
}

void FrameGuard::release() {
  const std::lock_guard lock(mutex_);
  socket_ = -1;
}

bool FrameGuard::cut_beyond(std::size_t bytes) {
  const std::lock_guard lock(mutex_);
  if (socket_ < 0 || read_bytes() <= read_before_ + bytes) return false;
  shutdown(socket_, SHUT_RDWR);
  socket_ = -1;
  return true;
}

}  // namespace armlet::lab
