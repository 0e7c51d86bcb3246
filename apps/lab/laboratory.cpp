#include "laboratory.hpp"

#include <exception>
#include <utility>

#include "armlet/stdlib/install.hpp"
#include "laboratory_state.hpp"

namespace armlet::lab {

namespace {

// Runs, and looks into them, that lead to the same picture share it, so that it is rendered once.
SessionOptions with_pictures(SessionOptions options, std::size_t most_bytes) {
  options.pictures = std::make_shared<KeptPictures>(most_bytes);
  return options;
}

}  // namespace

Laboratory::State::State(LaboratoryOptions given)
    : options(std::move(given)),
      imported(std::make_shared<TakenFiles>()),
      session_options(
          with_pictures(lab::session_options(noting(options.session, imported), options.bounds),
                        options.most_picture_bytes)),
      pages(options.most_pages),
      text_session(library_engine(), session_options),
      looker(session_options) {
  versions = {1, 1, 1, 1, 1, 1, 1, options.program_file.write ? 1U : 0U};
  text.document.exists = options.program_file.write && options.program_file.exists;
  if (text.document.exists) text.document.text = options.text;
  take_text(options.text, 0, true);
}

Laboratory::Laboratory(LaboratoryOptions options)
    : state_(std::make_unique<State>(std::move(options))) {}
Laboratory::~Laboratory() = default;

int Laboratory::join() { return state_->pages.join(); }

void Laboratory::leave(int page) { state_->pages.leave(page); }

void Laboratory::receive(int number, std::string_view message) {
  Page* page = state_->pages.find(number);
  if (page == nullptr) return;
  const auto read = read_request(message);
  if (const auto* unreadable = std::get_if<Unreadable>(&read))
    return state_->refuse(*page, unreadable->seq, "message", unreadable->why);
  const auto& request = std::get<Request>(read);
  try {
    state_->handle(*page, request);
  } catch (const std::exception& error) {
    state_->refuse(*page, request.seq, "refused", error.what());
  }
}

bool Laboratory::is_full(int number) const {
  const Page* page = state_->pages.find(number);
  return page != nullptr && page->answer_bytes > Pages::kMostAnswerBytes;
}

bool Laboratory::advance() {
  const bool looks_on = state_->advance_look();
  const bool runs_on = state_->advance_run();
  const bool plots_on = !runs_on && state_->advance_plots();
  return looks_on || runs_on || plots_on;
}

void Laboratory::look_at_file() { state_->look_at_file(); }

std::vector<Message> Laboratory::take_messages(int number, std::size_t most_bytes) {
  Page* page = state_->pages.find(number);
  return page == nullptr ? std::vector<Message>() : state_->take_messages(*page, most_bytes);
}

void Laboratory::interrupt() noexcept {
  const std::lock_guard lock(state_->busy_mutex);
  if (state_->busy != nullptr) state_->busy->cancel();
}

FileBytes Laboratory::file(std::string_view name) const { return state_->files.find(name); }

const std::string& Laboratory::text() const { return state_->text.now; }

}  // namespace armlet::lab
