// What is kept of a whole run in bounded memory: a flown trail and a search's costs.
//
// When the list is full every second entry goes, and from then on only every second one is taken; the newest is always
// there. Source: none needed. Departs from source: none. Complexity: O(1) an entry on average.
#pragma once

#include <cstddef>
#include <vector>

namespace skein::watch {

template <typename Entry>
class History {
 public:
  explicit History(std::size_t bound) : bound_(bound) {}

  void add(const Entry& entry) {
    if (provisional_) entries_.pop_back();
    entries_.push_back(entry);
    provisional_ = count_ % stride_ != 0;
    ++count_;
    if (entries_.size() >= bound_) thin();
  }
  void replace_last(const Entry& entry) { entries_.back() = entry; }
  void clear() { *this = History(bound_); }
  [[nodiscard]] bool empty() const { return entries_.empty(); }
  [[nodiscard]] const Entry& last() const { return entries_.back(); }
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }

 private:
  void thin() {
    const Entry newest = entries_.back();
    if (provisional_) entries_.pop_back();
    for (std::size_t i = 0; 2 * i < entries_.size(); ++i) entries_[i] = entries_[2 * i];
    entries_.resize((entries_.size() + 1) / 2);
    stride_ *= 2;
    provisional_ = (count_ - 1) % stride_ != 0;
    if (provisional_) entries_.push_back(newest);
  }

  std::size_t bound_;
  std::size_t stride_ = 1;
  std::size_t count_ = 0;
  bool provisional_ = false;  ///< the last entry gives way to the next one
  std::vector<Entry> entries_;
};

}  // namespace skein::watch
