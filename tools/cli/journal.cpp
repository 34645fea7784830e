#include "journal.hpp"

#include "checksum.hpp"
#include "outcome.hpp"
#include "record_bytes.hpp"
#include "tell.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/core.h>

namespace higherpair::cli {
namespace {

constexpr std::uint32_t kRecordMark = 0x44525048;  // "HPRD"
constexpr std::int64_t kSumSize = sizeof(std::uint64_t);

struct RecordHead {
  std::uint32_t mark = kRecordMark;
  std::uint32_t unused = 0;
  std::int64_t number = 0;
  std::int64_t size = 0;  ///< number of bytes that follow, without the checksum
};
constexpr std::int64_t kHeadSize = sizeof(RecordHead);

bool read_at(int file, std::int64_t place, char* to, std::size_t count) {
  while (count > 0) {
    const ssize_t got = ::pread(file, to, count, place);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    to += got;
    place += got;
    count -= static_cast<std::size_t>(got);
  }
  return true;
}

std::int64_t length_of(int file) {
  struct stat status {};
  return ::fstat(file, &status) == 0 ? status.st_size : 0;
}

// The complete record at a position of the file, with head and checksum; empty if there is none.
std::string record_at(int file, std::int64_t place, std::int64_t number) {
  const std::int64_t most = length_of(file) - place - kHeadSize - kSumSize;
  std::string bytes(static_cast<std::size_t>(kHeadSize), '\0');
  if (most < 0 || !read_at(file, place, bytes.data(), bytes.size())) {
    return "";
  }
  std::string_view text = bytes;
  const auto head = take<RecordHead>(text);
  if (head.mark != kRecordMark || head.number != number || head.size < 0 || head.size > most) {
    return "";
  }
  bytes.resize(static_cast<std::size_t>(kHeadSize + head.size + kSumSize));
  if (!read_at(file, place, bytes.data(), bytes.size())) {
    return "";
  }
  text = bytes;
  std::string_view sum = text.substr(bytes.size() - kSumSize);
  text.remove_suffix(kSumSize);
  return take<std::uint64_t>(sum) == checksum(text) ? bytes : "";
}

std::string unequal_names(const RunIdentity& there, const RunIdentity& here) {
  std::string names;
  for (const auto& [name, value] : here) {
    const auto found = there.find(name);
    if (found == there.end() || found->second != value) {
      names += (names.empty() ? "" : ", ") + name;
    }
  }
  return names;
}

}  // namespace

Journal::~Journal() {
  if (file_ >= 0) {
    ::close(file_);
  }
}

bool Journal::fail(const std::string& what) {
  error_ = fmt::format("{}: {}", what, std::strerror(errno));
  return false;
}

bool Journal::refuse(const std::string& why) {
  refused_ = true;
  error_ = fmt::format("{}: {}", path_, why);
  return false;
}

std::string Journal::magic() const {
  return fmt::format("higherpair {} 2\n", run_);
}

// The beginning of the file up to the empty line; empty if it is not a valid header.
std::string Journal::read_header() const {
  constexpr std::int64_t kLongest = std::int64_t{1} << 20;
  std::string text(static_cast<std::size_t>(std::min(length_of(file_), kLongest)), '\0');
  if (!read_at(file_, 0, text.data(), text.size()) || !text.starts_with(magic())) {
    return "";
  }
  const std::size_t end = text.find("\n\n");
  return end == std::string::npos ? "" : text.substr(0, end + 2);
}

// Whether the file has no complete record.
bool Journal::holds_nothing() const {
  const std::string header = read_header();
  return length_of(file_) == 0 ||
         (!header.empty() && record_at(file_, static_cast<std::int64_t>(header.size()), 0).empty());
}

bool Journal::open(const RunIdentity& identity, bool resume, const Take& take) {
  const std::string header = fmt::format("{}{}\n", magic(), identity_text(identity));
  if (path_.empty()) {
    std::FILE* temporary = std::tmpfile();
    file_ = temporary == nullptr ? -1 : ::dup(::fileno(temporary));
    if (temporary != nullptr) std::fclose(temporary);
    return file_ < 0 ? fail("cannot make a temporary file") : begin(header);
  }
  file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file_ < 0) {
    return fail("cannot write " + path_);
  }
  if (::flock(file_, LOCK_EX | LOCK_NB) != 0) {
    return refuse("another higherpair is at work on this " + run_);
  }
  if (holds_nothing()) {
    return ::ftruncate(file_, 0) == 0 ? begin(header) : fail("cannot write " + path_);
  }
  if (!check_header(identity, header, resume)) {
    return false;
  }
  start_ = length_ = static_cast<std::int64_t>(header.size());
  records_ = read_records(take);
  return ::ftruncate(file_, length_) == 0 || fail("cannot write " + path_);
}

bool Journal::begin(const std::string& header) {
  start_ = static_cast<std::int64_t>(header.size());
  return write(header);
}

bool Journal::check_header(const RunIdentity& identity, const std::string& header, bool resume) {
  const std::string found = read_header();
  if (found.empty()) {
    return refuse(
        fmt::format("this is no journal of a {}; move it away, or give the output another name", run_));
  }
  if (found != header) {
    return refuse(fmt::format(
        "this is of another {}: not the same {}; remove it to begin anew, or give the output another name",
        run_, unequal_names(identity_in(std::string_view(found).substr(magic().size())), identity)));
  }
  return resume || refuse(fmt::format("this holds what an interrupted run of this {} has done: --resume goes "
                                      "on from there; remove it to begin anew",
                                      run_));
}

bool Journal::write(const std::string& bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count =
        ::pwrite(file_, bytes.data() + done, bytes.size() - done, length_ + static_cast<std::int64_t>(done));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {
      fail("cannot write " + (path_.empty() ? "a temporary file" : path_));
      (void)!::ftruncate(file_, length_);  // otherwise reading cuts off the incomplete record
      return false;
    }
    done += static_cast<std::size_t>(count);
  }
  length_ += static_cast<std::int64_t>(bytes.size());
  return true;
}

bool Journal::append(std::string_view record) {
  std::string bytes;
  put(RecordHead{kRecordMark, 0, records_, static_cast<std::int64_t>(record.size())}, bytes);
  bytes += record;
  put(checksum(bytes), bytes);
  if (!write(bytes)) {
    return false;
  }
  ++records_;
  return true;
}

// Also moves length_ to the end of the last complete record.
std::int64_t Journal::read_records(const Take& take) {
  length_ = start_;
  for (std::int64_t count = 0;; ++count) {
    const std::string bytes = record_at(file_, length_, count);
    if (bytes.empty() ||
        !take(std::string_view(bytes).substr(kHeadSize, bytes.size() - kHeadSize - kSumSize))) {
      return count;
    }
    length_ += static_cast<std::int64_t>(bytes.size());
  }
}

bool Journal::read(const Take& take) {
  const std::int64_t length = length_;
  bool wanted = true;
  const std::int64_t read = read_records([&](std::string_view record) { return wanted = take(record); });
  length_ = length;
  if (read == records_ || !wanted) {
    return wanted;
  }
  error_ = fmt::format("cannot read {} any more", path_.empty() ? "a temporary file" : path_);
  return false;
}

void Journal::remove() {
  if (!path_.empty()) {
    ::unlink(path_.c_str());
  }
}

int report_journal(const Journal& journal) {
  tell("higherpair: {}\n", journal.error());
  return journal.is_refused() ? kExitInput : kExitMachine;
}

}  // namespace higherpair::cli
