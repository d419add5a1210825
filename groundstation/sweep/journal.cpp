#include "groundstation/sweep/journal.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <system_error>

#include "simworld/report/report.hpp"

namespace skein {
namespace {

using Json = nlohmann::ordered_json;

/// Of an object; empty if it has no such text.
std::string text_at(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

bool has_seed(const Json& run) {
  return run.is_object() && run.contains("seed") && run["seed"].is_number_unsigned();
}

}  // namespace

void RunJournal::Unlock::operator()(const int* descriptor) const {
  ::close(*descriptor);
  delete descriptor;
}

RunJournal::RunJournal(const std::string& path, std::string verb, const std::vector<std::uint64_t>& hashes,
                       const IsRun& is_run)
    : path_(path), verb_(std::move(verb)) {
  for (const std::uint64_t hash : hashes) hashes_.push_back(fmt::format("{:016x}", hash));
  const std::string first =
      Json{{"journal", "skein " + verb_}, {"version", version()}, {"scenario_hashes", hashes_}}.dump();
  std::error_code ignored;
  const bool is_new = !std::filesystem::exists(path, ignored);
  if (!is_new && !std::filesystem::is_regular_file(path, ignored)) {
    throw JournalRefused(fmt::format("{}: it is no file", path));
  }
  lock();
  if (!is_new) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in) throw JournalRefused(fmt::format("{}: it cannot be read", path));
    read(text.str(), first, is_run);
    std::error_code failed;
    std::filesystem::resize_file(path, whole_, failed);
    if (failed) throw JournalRefused(fmt::format("{}: it cannot be written: {}", path, failed.message()));
  }
  file_.open(path, std::ios::binary | std::ios::app);
  if (whole_ == 0) put(first);
  if (!file_) throw JournalRefused(fmt::format("{}: it cannot be written: {}", path, std::strerror(errno)));
}

/// Makes the file if need be. Programs that are started meanwhile do not inherit the lock.
void RunJournal::lock() {
  const int descriptor = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor < 0) throw JournalRefused(fmt::format("{}: it cannot be written: {}", path_, std::strerror(errno)));
  lock_.reset(new int(descriptor));
  if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return;
  throw JournalRefused(errno == EWOULDBLOCK ? fmt::format("{}: another skein goes on with it now", path_)
                                            : fmt::format("{}: it cannot be locked: {}", path_, std::strerror(errno)));
}

void RunJournal::refuse_head(const std::string& line) const {
  const Json head = Json::parse(line, nullptr, false);
  if (!head.is_object() || text_at(head, "journal") != "skein " + verb_) {
    throw JournalRefused(fmt::format("{}: it is no journal of skein {}", path_, verb_));
  }
  const std::string of = text_at(head, "version");
  const std::size_t combinations =
      head.contains("scenario_hashes") && head["scenario_hashes"].is_array() ? head["scenario_hashes"].size() : 0;
  std::string why = verb_ == "chaos" ? "another scenario, other values, other faults or another first seed"
                                     : "another scenario or other values";
  if (of != version()) {
    why = fmt::format("version {}, this is {}", of.empty() ? "unknown" : of, version());
  } else if (combinations != hashes_.size()) {
    why = fmt::format("{} combinations of values, these are {}", combinations, hashes_.size());
  }
  throw JournalRefused(fmt::format("{}: it is the journal of another skein {}: of {}", path_, verb_, why));
}

void RunJournal::read(const std::string& text, const std::string& first, const IsRun& is_run) {
  std::size_t number = 0;
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', whole_)) {
    const std::string line = text.substr(whole_, end - whole_);
    whole_ = end + 1;
    if (++number == 1) {
      if (line == first) continue;
      refuse_head(line);
    }
    Json run = Json::parse(line, nullptr, false);
    const bool good = run.is_object() && run.contains("scenario_hash") && run["scenario_hash"].is_string() &&
                      run.contains("run") && has_seed(run["run"]) && (!is_run || is_run(run["run"]));
    if (!good) throw JournalRefused(fmt::format("{}:{}: it is no run of skein {}", path_, number, verb_));
    const auto seed = run["run"]["seed"].get<std::uint64_t>();
    runs_[{run["scenario_hash"].get<std::string>(), seed}] = std::move(run["run"]);
  }
  if (number == 0 && !text.empty() && !first.starts_with(text)) {
    throw JournalRefused(fmt::format("{}: it is no journal of skein {}", path_, verb_));
  }
}

const Json* RunJournal::find(std::size_t combination, std::uint64_t seed) const {
  const auto found = runs_.find({hashes_[combination], seed});
  return found == runs_.end() ? nullptr : &found->second;
}

void RunJournal::add(std::size_t combination, const Json& run) {
  put(Json{{"scenario_hash", hashes_[combination]}, {"run", run}}.dump());
  if (!file_) throw JournalRefused(fmt::format("{}: it cannot be written: {}", path_, std::strerror(errno)));
}

void RunJournal::put(const std::string& line) {
  file_ << line + "\n" << std::flush;
}

}  // namespace skein
