#include "http_guard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <random>

namespace armlet::lab {
namespace {

// Compares in the same time for every token, right or wrong.
bool is_same_secret(std::string_view one, std::string_view other) {
  unsigned differences = one.size() == other.size() ? 0U : 1U;
  for (std::size_t i = 0; i < one.size(); ++i) {
    const char against = other.empty() ? '\0' : other[i % other.size()];
    differences |= static_cast<unsigned char>(one[i]) ^ static_cast<unsigned char>(against);
  }
  return differences == 0;
}

}  // namespace

std::string_view parameter(std::string_view query, std::string_view name) {
  while (!query.empty()) {
    const std::string_view part = query.substr(0, query.find('&'));
    query.remove_prefix(std::min(query.size(), part.size() + 1));
    if (part.size() > name.size() && part.starts_with(name) && part[name.size()] == '=')
      return part.substr(name.size() + 1);
  }
  return {};
}

namespace {

bool is_of(std::string_view text, std::string_view letters) {
  return !text.empty() && text.find_first_not_of(letters) == std::string_view::npos;
}

// "192.168.0.3" or "[::1]": no DNS server can redirect such a name.
bool is_address(std::string_view name) {
  if (name.starts_with('[') && name.ends_with(']'))
    return is_of(name.substr(1, name.size() - 2), "0123456789abcdefABCDEF:.");
  return is_of(name, "0123456789.");
}

bool leads_here(const Door& door, std::string_view host) {
  const std::string port = fmt::format(":{}", door.port);
  if (!host.ends_with(port)) return false;
  host.remove_suffix(port.size());
  if (host == door.host || host == "localhost" || host == "127.0.0.1" || host == "[::1]")
    return true;
  const bool is_everywhere = door.host == "0.0.0.0" || door.host == "[::]";
  return is_everywhere && is_address(host);
}

}  // namespace

std::optional<Refusal> refusal(const Door& door, const Asking& asking) {
  if (asking.method != "GET" && asking.method != "HEAD")
    return Refusal{405, "A laboratory answers GET only."};
  if (!leads_here(door, asking.host))
    return Refusal{403, "This name does not lead to the laboratory; use the address it printed."};
  if (asking.path != "/" && asking.path != "/live" && asking.path != "/file")
    return Refusal{404, "There is no such page."};
  if (!is_same_secret(parameter(asking.query, "token"), door.token)) {
    return Refusal{403,
                   "The token is missing or wrong; use the whole address that armlet lab "
                   "printed when it started."};
  }
  if ((asking.path == "/live") != asking.is_socket)
    return Refusal{400, "A laboratory is spoken to through a WebSocket at /live."};
  if (asking.is_socket && !asking.origin.empty() &&
      asking.origin != fmt::format("http://{}", asking.host))
    return Refusal{403, "Only the laboratory's own page may speak to it."};
  return std::nullopt;
}

std::string new_token() {
  std::random_device chance;
  std::string token;
  for (int i = 0; i < 4; ++i) token += fmt::format("{:08x}", chance());
  return token;
}

std::string fault_of_token(std::string_view token) {
  // 22 of 64 letters are 132 bits, if they are chosen at random.
  if (token.size() < 22 || token.size() > 200)
    return fmt::format("a token has 22 to 200 characters, and this one {}", token.size());
  constexpr std::string_view kLetters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
  return is_of(token, kLetters) ? "" : "a token is made of letters, digits, - and _";
}

bool is_loopback(std::string_view host) {
  return host == "localhost" || host == "::1" || host == "[::1]" ||
         (host.starts_with("127.") && is_address(host));
}

std::string_view scripts_of(std::string_view page) {
  constexpr std::string_view kPolicy = "http-equiv=\"Content-Security-Policy\" content=\"";
  constexpr std::string_view kNone = "script-src 'none'";
  const std::size_t policy = page.find(kPolicy);
  if (policy == std::string_view::npos) return kNone;
  page.remove_prefix(policy + kPolicy.size());
  page = page.substr(0, page.find('"'));
  const std::size_t scripts = page.find("script-src ");
  if (scripts == std::string_view::npos) return kNone;
  page.remove_prefix(scripts);
  const std::string_view said = page.substr(0, page.find(';'));
  return said.find_first_of("\r\n") == std::string_view::npos ? said : kNone;
}

}  // namespace armlet::lab
