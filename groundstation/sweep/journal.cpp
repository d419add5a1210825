#include "groundstation/sweep/journal.hpp"

#include <fmt/core.h>

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

}  // namespace

RunJournal::RunJournal(const std::string& path, std::string verb, const std::vector<std::uint64_t>& hashes)
    : path_(path), verb_(std::move(verb)) {
  for (const std::uint64_t hash : hashes) hashes_.push_back(fmt::format("{:016x}", hash));
  const std::string first =
      Json{{"journal", "skein " + verb_}, {"version", version()}, {"scenario_hashes", hashes_}}.dump();
  std::error_code ignored;
  const bool is_new = !std::filesystem::exists(path, ignored);
  if (!is_new && !std::filesystem::is_regular_file(path, ignored)) {
    throw JournalRefused(fmt::format("{}: it is no file", path));
  }
  if (!is_new) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in) throw JournalRefused(fmt::format("{}: it cannot be read", path));
    read(text.str(), first);
    std::error_code failed;
    std::filesystem::resize_file(path, whole_, failed);
    if (failed) throw JournalRefused(fmt::format("{}: it cannot be written: {}", path, failed.message()));
  }
  file_.open(path, std::ios::binary | std::ios::app);
  if (whole_ == 0) put(first);
  if (!file_) throw JournalRefused(fmt::format("{}: it cannot be written: {}", path, std::strerror(errno)));
}

void RunJournal::read(const std::string& text, const std::string& first) {
  std::size_t number = 0;
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', whole_)) {
    const std::string line = text.substr(whole_, end - whole_);
    whole_ = end + 1;
    if (++number == 1) {
      if (line == first) continue;
      const Json head = Json::parse(line, nullptr, false);
      if (!head.is_object() || head.value("journal", "") != "skein " + verb_) {
        throw JournalRefused(fmt::format("{}: it is no journal of skein {}", path_, verb_));
      }
      throw JournalRefused(
          fmt::format("{}: it is the journal of another skein {}: of another scenario, other values or "
                      "another version ({}, this is {})",
                      path_, verb_, head.value("version", "unknown"), version()));
    }
    Json run = Json::parse(line, nullptr, false);
    const bool good = run.is_object() && run.contains("scenario_hash") && run["scenario_hash"].is_string() &&
                      run.contains("run") && run["run"].contains("seed") && run["run"]["seed"].is_number_unsigned();
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
