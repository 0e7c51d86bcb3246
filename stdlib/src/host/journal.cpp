#include "host/journal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "armlet/core/hash.hpp"

namespace armlet {

void Journal::begin(LoggedEntry& entry, bool has_later) {
  entry_ = &entry;
  has_later_ = has_later;
  inputs_ = replies_ = stops_ = cancelled_ = 0;
  pieces_ = 0;
  place_ = {};
  left_.reset();
}

void Journal::resume(LoggedEntry& entry, bool has_later) {
  begin(entry, has_later);
  inputs_ = entry.inputs.size();
  replies_ = entry.replies.size();
  stops_ = entry.stopped_ns.size();
  cancelled_ = entry.cancelled.size();
  place_ = entry.end;
}

const Input* Journal::next() const {
  return inputs_ < entry_->inputs.size() ? &entry_->inputs[inputs_] : nullptr;
}

void Journal::add(Input input) {
  part();
  entry_->inputs.push_back(std::move(input));
  ++inputs_;
}

Reply Journal::ask(std::string question, const std::function<Reply()>& outside) {
  std::vector<Reply>& replies = entry_->replies;
  if (replies_ < replies.size() && replies[replies_].question == question)
    return replies[replies_++];
  replies.resize(replies_);  // a program that asks another question is another run
  Reply reply = outside();
  reply.question = std::move(question);
  ++replies_;
  return replies.emplace_back(std::move(reply));
}

Reply Journal::save(std::string_view name, std::string_view content,
                    const std::function<Reply()>& outside) {
  Fnv1a hash;
  hash.add(content);
  return ask(fmt::format("save {} {:016x}", name, hash.value()), [&] {
    if (silent_) return keep_unwritten(name, content);
    Reply reply = outside();
    return keeps_files_ || reply.error ? reply : keep_unwritten(name, content);
  });
}

Reply Journal::keep_unwritten(std::string_view name, std::string_view content) {
  constexpr std::size_t kMostBytes = std::size_t{64} << 20U;
  std::string& held = unwritten_[std::string(name)];
  const std::size_t bytes = unwritten_bytes_ - held.size() + content.size();
  if (!keeps_files_ && bytes > kMostBytes) {
    return Reply{.error = Error{"file", fmt::format("the files of this run have more than {} MB",
                                                    kMostBytes >> 20U)}};
  }
  held = content;
  unwritten_bytes_ = bytes;
  return Reply{.question = {}, .text = std::string(name)};
}

Reply Journal::load(const std::string& name, const std::function<Reply()>& outside) {
  return ask("load " + name, [&] {
    const auto found = unwritten_.find(name);
    const bool is_written = keeps_files_ && !silent_;
    return is_written || found == unwritten_.end() ? outside()
                                                   : Reply{.question = {}, .text = found->second};
  });
}

std::string Journal::print(std::string_view text, const std::function<std::string()>& outside) {
  std::vector<Reply>& replies = entry_->replies;
  std::string question = fmt::format("print {} {}", ++pieces_, text.size());
  if (replies_ < replies.size() && replies[replies_].question == question)
    return replies[replies_++].text;
  if (silent_) return {};
  std::string why = outside();
  if (why.empty()) return why;
  return ask(std::move(question), [&] { return Reply{.question = {}, .text = why}; }).text;
}

std::optional<std::int64_t> Journal::next_stop(std::int64_t now_ns, std::int64_t until_ns) const {
  if (stops_ >= entry_->stopped_ns.size()) return std::nullopt;
  const std::int64_t stop = std::max(entry_->stopped_ns[stops_], now_ns);
  return stop < until_ns ? std::optional(stop) : std::nullopt;
}

void Journal::stop_time(std::int64_t now_ns) {
  part();
  entry_->stopped_ns.push_back(now_ns);
  ++stops_;
}

void Journal::note(const Instant& place, std::span<const Cancellation> cancelled) {
  place_ = place;
  if (!cancelled.empty()) note_cancelled(cancelled);
  cancelled_ = cancelled.size();
  if (is_at_its_end() && !entry_->end.has_reached(place)) entry_->end = place;
}

void Journal::note_cancelled(std::span<const Cancellation> cancelled) {
  const std::size_t known = std::min(cancelled.size(), entry_->cancelled.size());
  const bool is_known = known == cancelled.size() &&
                        std::ranges::equal(cancelled, std::span(entry_->cancelled).first(known));
  if (is_known) return;
  part();
  entry_->cancelled.assign(cancelled.begin(), cancelled.end());
}

bool Journal::is_at_its_end() const {
  return !has_later_ && inputs_ == entry_->inputs.size() && replies_ == entry_->replies.size() &&
         stops_ == entry_->stopped_ns.size() && cancelled_ == entry_->cancelled.size();
}

void Journal::part() {
  if (place_.has_reached(entry_->end) && is_at_its_end()) return;
  left_ = *entry_;
  entry_->inputs.resize(inputs_);
  entry_->replies.resize(replies_);
  entry_->stopped_ns.resize(stops_);
  entry_->cancelled.resize(std::min(cancelled_, entry_->cancelled.size()));
  entry_->end = place_;
}

}  // namespace armlet
