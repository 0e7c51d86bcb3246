#include "server.hpp"

#include <fmt/format.h>

#include <chrono>
#include <list>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

#include "armlet/core/platform.hpp"
#include "civetweb_library.hpp"
#include "connections.hpp"
#include "frame_guard.hpp"
#include "http_guard.hpp"

namespace armlet::lab {
namespace {

constexpr std::int64_t kMostWork_ns = 10'000'000'000;
// The limit of an incomplete WebSocket frame: more bytes than a message may have, and the bytes
// that are read ahead.
constexpr std::size_t kMostFrameBytes = kMostMessageBytes + 64'000;

std::string_view text_of(const char* text) { return text == nullptr ? "" : text; }

std::string_view reason(int status) {
  switch (status) {
    case 200:
      return "OK";
    case 400:
      return "Bad Request";
    case 404:
      return "Not Found";
    case 405:
      return "Method Not Allowed";
    default:
      return "Forbidden";
  }
}

// The HTTP headers that allow a page to load and run only parts of itself.
std::string security_headers(std::string_view host, std::string_view page) {
  return fmt::format(
      "Content-Security-Policy: default-src 'none'; {1}; style-src 'unsafe-inline'; "
      "img-src data: blob:; media-src blob:; font-src data:; connect-src 'self' ws://{0} blob: "
      "data:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'\r\n"
      "X-Content-Type-Options: nosniff\r\nReferrer-Policy: no-referrer\r\n"
      "Cross-Origin-Resource-Policy: same-origin\r\nCross-Origin-Opener-Policy: same-origin\r\n"
      "Cache-Control: no-store\r\n",
      host, scripts_of(page));
}

class Server {
 public:
  Server(Laboratory& laboratory, const ServerOptions& options)
      : laboratory_(laboratory),
        options_(options),
        connections_(laboratory),
        door_{options.host, options.port, options.token} {}

  std::string run() {
    if (!web_.is_whole()) {
      return fmt::format(
          "the library {} was not found, which serves pages (Debian package libcivetweb1)",
          ARMLET_CIVETWEB_LIBRARY);
    }
    if (std::string why = start(); !why.empty()) return why;
    std::thread worker([this] { connections_.work(); });
    options_.on_ready(fmt::format("http://{}:{}/?token={}", shown_host(), door_.port, door_.token));
    watch();
    connections_.end();
    laboratory_.interrupt();
    worker.join();
    web_.stop(context_);
    return {};
  }

 private:
  // Stops work that takes too long, closes connections with too large frames, waits for the end.
  void watch() {
    while (!options_.is_over()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      cut_large_frames();
      const std::int64_t since = connections_.busy_since();
      if (since != 0 && steady_time_ns() - since > kMostWork_ns) laboratory_.interrupt();
    }
  }

  [[nodiscard]] std::string shown_host() const {
    return door_.host == "0.0.0.0" ? "127.0.0.1" : door_.host;
  }

  std::string start() {
    const std::string ports = fmt::format("{}:{}", door_.host, door_.port);
    const char* const settings[] = {"listening_ports",
                                    ports.c_str(),
                                    "num_threads",
                                    "128",
                                    "request_timeout_ms",  // also for connections without a request
                                    "3000",
                                    "websocket_timeout_ms",
                                    "5000",  // after five pings without an answer
                                    "enable_websocket_ping_pong",
                                    "yes",
                                    "enable_directory_listing",
                                    "no",
                                    "enable_keep_alive",
                                    "no",
                                    "max_request_size",
                                    "8192",
                                    "tcp_nodelay",
                                    "1",
                                    nullptr};
    mg_callbacks callbacks{};
    callbacks.begin_request = [](mg_connection* connection) {
      // The library is loaded once; the server keeps a pointer to it.
      static const Civetweb web;
      return static_cast<Server*>(web.get_user_data(connection))->answer(connection);
    };
    callbacks.log_message = [](const mg_connection*, const char*) { return 1; };
    callbacks.log_access = [](const mg_connection*, const char*) { return 1; };
    context_ = web_.start(&callbacks, this, const_cast<const char**>(settings));
    if (context_ == nullptr)
      return fmt::format("nothing can be served at {}: it is no address of this machine, or in use",
                         ports);
    mg_server_port listening[4] = {};
    if (web_.get_server_ports(context_, 4, listening) > 0) door_.port = listening[0].port;
    web_.set_websocket_handler(
        context_, "/live",
        [](const mg_connection*, void* self) {
          return static_cast<Server*>(self)->connections_.is_full() ? 1 : 0;
        },
        [](mg_connection* connection, void* self) { static_cast<Server*>(self)->open(connection); },
        [](mg_connection* connection, int bits, char* data, std::size_t size, void* self) {
          return static_cast<Server*>(self)->receive(connection, bits, {data, size}) ? 1 : 0;
        },
        [](const mg_connection* connection, void* self) {
          static_cast<Server*>(self)->close(connection);
        },
        this);
    return {};
  }

  // ---- requests
  int answer(mg_connection* connection) {
    const mg_request_info& info = *web_.get_request_info(connection);
    const auto header = [&](const char* name) {
      return text_of(web_.get_header(connection, name));
    };
    const Asking asking{.method = text_of(info.request_method),
                        .path = text_of(info.local_uri),
                        .query = text_of(info.query_string),
                        .host = header("Host"),
                        .origin = header("Origin"),
                        .is_socket = !header("Upgrade").empty()};
    const std::optional<Refusal> refused = refusal(door_, asking);
    if (!refused && asking.is_socket) return 0;  // the WebSocket handler takes it
    if (refused) {
      reply(connection, refused->status, "text/plain; charset=utf-8", refused->why + "\n", asking);
      return refused->status;
    }
    if (asking.path == "/file") return give_file(connection, asking);
    reply(connection, 200, "text/html; charset=utf-8", options_.page, asking);
    return 200;
  }

  // Files that pages draw. A name always means the same bytes, so browsers may cache them.
  int give_file(mg_connection* connection, const Asking& asking) {
    const FileBytes bytes = laboratory_.file(parameter(asking.query, "name"));
    const int status = bytes == nullptr ? 404 : 200;
    const std::string_view body =
        bytes == nullptr ? std::string_view("There is no such file.\n") : std::string_view(*bytes);
    const std::string head = fmt::format(
        "HTTP/1.1 {} {}\r\nContent-Type: {}\r\nContent-Length: {}\r\n"
        "Content-Security-Policy: default-src 'none'; sandbox\r\nContent-Disposition: "
        "attachment\r\n"
        "X-Content-Type-Options: nosniff\r\nReferrer-Policy: no-referrer\r\n"
        "Cross-Origin-Resource-Policy: same-origin\r\nCache-Control: {}\r\nConnection: "
        "close\r\n\r\n",
        status, reason(status),
        bytes == nullptr ? "text/plain; charset=utf-8" : "application/octet-stream", body.size(),
        bytes == nullptr ? "no-store" : "private, max-age=31536000, immutable");
    web_.write(connection, head.data(), head.size());
    if (asking.method != "HEAD") web_.write(connection, body.data(), body.size());
    return status;
  }

  void reply(mg_connection* connection, int status, std::string_view type, std::string_view body,
             const Asking& asking) {
    const std::string head = fmt::format(
        "HTTP/1.1 {} {}\r\nContent-Type: {}\r\nContent-Length: {}\r\n{}"
        "Connection: close\r\n\r\n",
        status, reason(status), type, body.size(),
        status == 200 ? security_headers(asking.host, options_.page) : std::string());
    web_.write(connection, head.data(), head.size());
    if (asking.method != "HEAD") web_.write(connection, body.data(), body.size());
  }

  // ---- sockets
  struct Socket {
    explicit Socket(const mg_request_info& info) : frame(info.remote_addr, info.remote_port) {}

    FrameGuard frame;
    std::shared_ptr<Connection> page;
  };

  [[nodiscard]] Socket* socket_of(const mg_connection* connection) {
    return static_cast<Socket*>(web_.get_connection_data(connection));
  }

  void open(mg_connection* connection) {
    auto page = connections_.add([this, connection](const Message& message) {
      const int kind = message.is_binary ? MG_WEBSOCKET_OPCODE_BINARY : MG_WEBSOCKET_OPCODE_TEXT;
      return web_.websocket_write(connection, kind, message.bytes.data(), message.bytes.size()) > 0;
    });
    if (page == nullptr) return;
    const std::lock_guard lock(sockets_mutex_);
    Socket& socket = sockets_.emplace_back(*web_.get_request_info(connection));
    socket.page = std::move(page);
    web_.set_connection_data(connection, &socket);
  }

  bool receive(mg_connection* connection, int bits, std::string_view data) {
    Socket* socket = socket_of(connection);
    if (socket == nullptr || socket->page->is_closed()) return false;
    socket->frame.came_out();
    const int kind = bits & 0x0F;
    if (kind == MG_WEBSOCKET_OPCODE_PING || kind == MG_WEBSOCKET_OPCODE_PONG) return true;
    if (kind != MG_WEBSOCKET_OPCODE_TEXT && kind != MG_WEBSOCKET_OPCODE_CONTINUATION) return false;
    return socket->page->receive(data, (bits & 0x80) != 0);
  }

  void close(const mg_connection* connection) {
    Socket* socket = socket_of(connection);
    if (socket == nullptr) return;
    socket->frame.release();
    socket->page->close();
    web_.set_connection_data(const_cast<mg_connection*>(connection), nullptr);
    const std::lock_guard lock(sockets_mutex_);
    sockets_.remove_if([&](const Socket& each) { return &each == socket; });
  }

  void cut_large_frames() {
    const std::lock_guard lock(sockets_mutex_);
    for (Socket& socket : sockets_) socket.frame.cut_beyond(kMostFrameBytes);
  }

  Laboratory& laboratory_;
  const ServerOptions& options_;
  Civetweb web_;
  Connections connections_;
  Door door_;
  mg_context* context_ = nullptr;
  std::mutex sockets_mutex_;
  std::list<Socket> sockets_;
};

}  // namespace

std::string serve(Laboratory& laboratory, const ServerOptions& options) {
  return Server(laboratory, options).run();
}

}  // namespace armlet::lab
