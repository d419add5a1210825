// The runs of a long job (a sweep, a fault campaign) that are done, in a file, so that it can go on after an
// interruption.
//
// JSON lines: the first says of what job (verb, version, scenario hash of each combination), each other holds a run
// with its combination's scenario hash (which covers text and overrides) and its seed. A line is written when its run
// is done, at once; a last line that is torn is cut off, its run is made again. Numbers keep every bit, so that a job
// that went on prints what one without interruption prints, wall times aside. As long as one job has a journal, it is
// locked for others. Source: flock(2). Departs from source: none. Complexity: O(log runs) a question, O(bytes) a run.
#pragma once

#include <cstdint>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace skein {

/// A journal that cannot be used; what() is one line.
struct JournalRefused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class RunJournal {
 public:
  /// Whether JSON, of which the seed was checked, holds what the job takes from a run.
  using IsRun = std::function<bool(const nlohmann::ordered_json&)>;

  /// Goes on with the file, or begins it. @param verb whose journal it is: "sweep" @param hashes scenario hash of each
  /// combination, in their order @param is_run empty: all are @throws JournalRefused if it is of another job or
  /// version, no journal, locked by another process, or cannot be written
  RunJournal(const std::string& path, std::string verb, const std::vector<std::uint64_t>& hashes,
             const IsRun& is_run = {});

  /// The run of that combination and seed; nullptr: it was not made yet.
  [[nodiscard]] const nlohmann::ordered_json* find(std::size_t combination, std::uint64_t seed) const;
  /// @throws JournalRefused if it cannot be written
  void add(std::size_t combination, const nlohmann::ordered_json& run);

 private:
  struct Unlock {
    void operator()(const int* descriptor) const;
  };
  void lock();
  void read(const std::string& text, const std::string& first, const IsRun& is_run);
  [[noreturn]] void refuse_head(const std::string& line) const;
  void put(const std::string& line);

  std::string path_;
  std::string verb_;
  std::vector<std::string> hashes_;
  std::map<std::pair<std::string, std::uint64_t>, nlohmann::ordered_json> runs_;
  std::size_t whole_ = 0;              ///< bytes of whole lines
  std::unique_ptr<int, Unlock> lock_;  ///< the descriptor that holds it
  std::ofstream file_;
};

}  // namespace skein
