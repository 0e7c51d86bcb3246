#pragma once
// The HTTP server civetweb, loaded only to serve a laboratory: other commands start sooner.

#include <civetweb.h>

#include "armlet/core/platform.hpp"

namespace armlet::lab {

class Civetweb {
 public:
  Civetweb() : library_(ARMLET_CIVETWEB_LIBRARY) {
    is_whole_ = take(start, "mg_start") && take(stop, "mg_stop") &&
                take(set_websocket_handler, "mg_set_websocket_handler") &&
                take(websocket_write, "mg_websocket_write") &&
                take(get_request_info, "mg_get_request_info") &&
                take(get_header, "mg_get_header") && take(write, "mg_write") &&
                take(get_user_data, "mg_get_user_context_data") &&
                take(get_server_ports, "mg_get_server_ports") &&
                take(set_connection_data, "mg_set_user_connection_data") &&
                take(get_connection_data, "mg_get_user_connection_data");
  }

  // Whether the library was found with all of its functions.
  [[nodiscard]] bool is_whole() const { return is_whole_; }

  decltype(&mg_start) start = nullptr;
  decltype(&mg_stop) stop = nullptr;
  decltype(&mg_set_websocket_handler) set_websocket_handler = nullptr;
  decltype(&mg_websocket_write) websocket_write = nullptr;
  decltype(&mg_get_request_info) get_request_info = nullptr;
  decltype(&mg_get_header) get_header = nullptr;
  decltype(&mg_write) write = nullptr;
  decltype(&mg_get_user_context_data) get_user_data = nullptr;
  decltype(&mg_get_server_ports) get_server_ports = nullptr;
  decltype(&mg_set_user_connection_data) set_connection_data = nullptr;
  decltype(&mg_get_user_connection_data) get_connection_data = nullptr;

 private:
  template <class Function>
  bool take(Function& function, const char* name) {
    function = reinterpret_cast<Function>(library_.find(name));
    return function != nullptr;
  }

  LoadedLibrary library_;
  bool is_whole_ = false;
};

}  // namespace armlet::lab
