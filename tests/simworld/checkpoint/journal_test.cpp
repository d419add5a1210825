// A journal gives back what was appended, cuts off what a dying process left, and refuses everything else.
#include "simworld/checkpoint/journal.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "tests/simworld/checkpoint/scratch.hpp"

namespace skein {
namespace {

using test::read_file;
using test::Scratch;
using test::write_file;
using Records = std::vector<std::pair<std::uint32_t, Bytes>>;

const Records kRecords{{1, {1, 2, 3}}, {2, {}}, {7, Bytes(20, 9)}, {2, {0, 0, 0, 0, 0, 0, 0, 0, 1}}};

Records read_all(Journal& journal) {
  Records records;
  journal.read([&](std::uint32_t kind, std::span<const std::uint8_t> content) {
    records.emplace_back(kind, Bytes(content.begin(), content.end()));
  });
  return records;
}

/// A file with kRecords. @return the places where records end, 0 first
std::vector<std::size_t> write_records(const std::string& path) {
  Journal journal(path, false);
  std::vector<std::size_t> ends{0};
  for (const auto& [kind, content] : kRecords) {
    journal.append(kind, content);
    ends.push_back(read_file(path).size());
  }
  return ends;
}

TEST(Journal, GivesBackWhatWasAppendedAlsoByALaterProcess) {
  const Scratch folder;
  const std::string path = folder.path() + "/journal";
  write_records(path);
  Journal journal(path, true);
  EXPECT_EQ(read_all(journal), kRecords);
  journal.append(5, Bytes{4});
  Records more = kRecords;
  more.push_back({5, {4}});
  EXPECT_EQ(read_all(journal), more);
  EXPECT_EQ(read_all(journal), more) << "reading changes nothing";
}

TEST(Journal, ARecordThatIsTornAnywhereIsCutOffAndTheNextOneFollows) {
  const Scratch folder;
  const std::string path = folder.path() + "/journal";
  const std::vector<std::size_t> ends = write_records(path);
  const Bytes whole = read_file(path);
  std::size_t records = 0;
  for (std::size_t length = 0; length <= whole.size(); ++length) {
    if (records + 1 < ends.size() && length == ends[records + 1]) ++records;
    write_file(path, {whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)});
    Journal journal(path, false);
    Records expected(kRecords.begin(), kRecords.begin() + static_cast<std::ptrdiff_t>(records));
    ASSERT_EQ(read_all(journal), expected) << "cut at byte " << length;
    ASSERT_EQ(read_file(path).size(), ends[records]);
    journal.append(6, Bytes{8});
    expected.push_back({6, {8}});
    ASSERT_EQ(read_all(journal), expected) << "cut at byte " << length;
  }
  EXPECT_EQ(records, kRecords.size());
}

TEST(Journal, AFlippedBitOfAnyByteIsFound) {
  const Scratch folder;
  const std::string path = folder.path() + "/journal";
  write_records(path);
  const Bytes whole = read_file(path);
  for (std::size_t byte = 0; byte < whole.size(); ++byte) {
    const std::size_t bit = 8 * byte + byte % 8;
    Bytes flipped = whole;
    flipped[bit / 8] = static_cast<std::uint8_t>(flipped[bit / 8] ^ (1U << (bit % 8)));
    write_file(path, flipped);
    Journal journal(path, false);
    try {
      (void)read_all(journal);
      FAIL() << "bit " << bit;
    } catch (const JournalFault& fault) {
      ASSERT_EQ(fault.kind, JournalFault::Kind::Damaged) << "bit " << bit << ": " << fault.what();
    }
    ASSERT_EQ(read_file(path), flipped) << "nothing is thrown away of what is damaged";
  }
}

TEST(Journal, OneProcessAtATimeHasItOpen) {
  const Scratch folder;
  const std::string path = folder.path() + "/journal";
  {
    const Journal first(path, false);
    try {
      const Journal second(path, false);
      FAIL() << "two have it open";
    } catch (const JournalFault& fault) {
      EXPECT_EQ(fault.kind, JournalFault::Kind::InUse);
    }
  }
  EXPECT_NO_THROW(Journal(path, false));
}

TEST(Journal, WhatCannotBeOpenedOrWrittenSaysWhy) {
  try {
    const Journal journal("/proc/none/journal", false);
    FAIL() << "it was opened";
  } catch (const JournalFault& fault) {
    EXPECT_EQ(fault.kind, JournalFault::Kind::Unusable);
    EXPECT_STREQ(fault.what(), "/proc/none/journal: No such file or directory");
  }
  Journal full("/dev/full", false);
  EXPECT_THROW(full.append(1, Bytes{1}), JournalFault);
}

TEST(Journal, ClearForgetsAll) {
  const Scratch folder;
  const std::string path = folder.path() + "/journal";
  write_records(path);
  Journal journal(path, false);
  journal.clear();
  journal.append(3, Bytes{1});
  EXPECT_EQ(read_all(journal), (Records{{3, {1}}}));
}

}  // namespace
}  // namespace skein
