#include "pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace armlet::lab {

int Pages::join() {
  if (static_cast<int>(pages_.size()) >= most_) return -1;
  const int number = ++last_;
  pages_[number].number = number;
  pages_[number].key = fmt::format("{:08x}{:08x}", chance_(), chance_());
  return number;
}

void Pages::leave(int page) {
  if (pages_.erase(page) == 0) return;
  std::erase(control_.pages, page);
  std::erase(control_.wishes, page);
  control_.names.erase(page);
  if (is_holder(page)) {
    control_.holder.reset();
    if (!control_.wishes.empty()) static_cast<void>(give(control_.wishes.front()));
  }
  ++changes_;
}

Page* Pages::find(int page) {
  const auto found = pages_.find(page);
  return found == pages_.end() ? nullptr : &found->second;
}

void Pages::answer(Page& page, Message message) {
  page.answer_bytes += message.bytes.size();
  page.answers.push_back(std::move(message));
}

void Pages::forget_run(int run) {
  for (auto& [number, page] : pages_) {
    page.runs.erase(run);
    page.wanted.erase(run);
  }
}

void Pages::enter(int page, std::string_view key) {
  control_.pages.push_back(page);
  const Page* holder = control_.holder ? find(*control_.holder) : nullptr;
  if (holder == nullptr || holder->key == key) control_.holder = page;
  ++changes_;
}

bool Pages::take(int page) {
  ++changes_;
  if (!control_.holder) control_.holder = page;
  std::erase(control_.wishes, page);
  if (is_holder(page)) return true;
  control_.wishes.push_back(page);
  return false;
}

void Pages::set_name(int page, std::string name) {
  control_.names.erase(page);
  if (!name.empty()) control_.names.emplace(page, std::move(name));
  ++changes_;
}

bool Pages::give(std::optional<int> page) {
  if (page && std::ranges::find(control_.pages, *page) == control_.pages.end()) return false;
  control_.holder = page;
  if (page) std::erase(control_.wishes, *page);
  ++changes_;
  return true;
}

}  // namespace armlet::lab
