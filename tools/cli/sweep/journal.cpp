#include "sweep/journal.hpp"

#include "sweep/checksum.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

namespace higherpair::cli {
namespace {

// The bytes are those of the machine: a journal is gone on with where it was begun.
constexpr std::string_view kMagic = "higherpair sweep 1\n";
constexpr std::uint32_t kBlockMark = 0x4b4c4248;  // "HBLK"

struct BlockHead {
  std::uint32_t mark = kBlockMark;
  std::uint32_t width = 0;
  std::int64_t number = 0;
  std::int64_t variants = 0;
  std::int64_t good = 0;
  std::int64_t rows = 0;
  std::int64_t cause_bytes = 0;
};

struct CauseHead {
  std::int64_t row = 0;
  std::int64_t length = 0;
};

template <class T>
void put(const T& value, std::string& bytes) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string causes_of(const SweepBlock& block) {
  std::string bytes;
  for (std::size_t row = 0; row < block.causes.size(); ++row) {
    if (!block.causes[row].empty()) {
      put(CauseHead{static_cast<std::int64_t>(row), static_cast<std::int64_t>(block.causes[row].size())},
          bytes);
      bytes += block.causes[row];
    }
  }
  return bytes;
}

std::string bytes_of(const SweepBlock& block, std::size_t width) {
  const std::string causes = causes_of(block);
  std::string bytes;
  put(BlockHead{kBlockMark, static_cast<std::uint32_t>(width), block.number, block.variants, block.good,
                static_cast<std::int64_t>(block.causes.size()), static_cast<std::int64_t>(causes.size())},
      bytes);
  bytes.append(reinterpret_cast<const char*>(block.values.data()), block.values.size() * sizeof(double));
  bytes += causes;
  put(checksum(bytes), bytes);
  return bytes;
}

// Of bytes whose checksum is right.
SweepBlock block_of(const BlockHead& head, std::string_view payload) {
  SweepBlock block;
  block.number = head.number;
  block.variants = head.variants;
  block.good = head.good;
  block.values.resize(static_cast<std::size_t>(head.rows) * head.width);
  block.causes.resize(static_cast<std::size_t>(head.rows));
  std::memcpy(block.values.data(), payload.data(), block.values.size() * sizeof(double));
  payload.remove_prefix(block.values.size() * sizeof(double));
  while (payload.size() >= sizeof(CauseHead)) {
    CauseHead cause;
    std::memcpy(&cause, payload.data(), sizeof cause);
    payload.remove_prefix(sizeof cause);
    block.causes.at(static_cast<std::size_t>(cause.row)) =
        payload.substr(0, static_cast<std::size_t>(cause.length));
    payload.remove_prefix(static_cast<std::size_t>(cause.length));
  }
  return block;
}

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

std::int64_t size_of(int file) {
  struct stat status {};
  return ::fstat(file, &status) == 0 ? status.st_size : 0;
}

std::string header_of(const SweepIdentity& identity) {
  std::string header(kMagic);
  for (const auto& [name, value] : identity) {
    header += fmt::format("{} {}\n", name, value);
  }
  return header + "\n";
}

SweepIdentity identity_of(std::string_view header) {
  SweepIdentity identity;
  header.remove_prefix(kMagic.size());
  while (header.size() > 1) {
    const std::string_view line = header.substr(0, header.find('\n'));
    const std::size_t space = line.find(' ');
    identity[std::string(line.substr(0, space))] = line.substr(space + 1);
    header.remove_prefix(line.size() + 1);
  }
  return identity;
}

std::string differences(const SweepIdentity& there, const SweepIdentity& here) {
  std::string names;
  for (const auto& [name, value] : here) {
    const auto found = there.find(name);
    if (found == there.end() || found->second != value) {
      names += (names.empty() ? "" : ", ") + name;
    }
  }
  return names;
}

// What stands at the beginning of the file up to the empty line; empty where there is no header.
std::string read_header(int file) {
  constexpr std::size_t kLongest = std::size_t{1} << 20;
  std::string text(std::min<std::size_t>(static_cast<std::size_t>(size_of(file)), kLongest), '\0');
  if (!read_at(file, 0, text.data(), text.size()) || !text.starts_with(kMagic)) {
    return "";
  }
  const std::size_t end = text.find("\n\n");
  return end == std::string::npos ? "" : text.substr(0, end + 2);
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

bool Journal::open(const SweepIdentity& identity, std::size_t width, bool resume, const Take& take) {
  width_ = width;
  const std::string header = header_of(identity);
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
    return refuse("another higherpair is at work on this sweep");
  }
  if (size_of(file_) == 0) {
    return begin(header);
  }
  if (!check_header(identity, header, resume)) {
    return false;
  }
  start_ = length_ = static_cast<std::int64_t>(header.size());
  blocks_ = read_blocks(take);
  return ::ftruncate(file_, length_) == 0 || fail("cannot write " + path_);
}

bool Journal::begin(const std::string& header) {
  start_ = static_cast<std::int64_t>(header.size());
  return write(header);
}

bool Journal::check_header(const SweepIdentity& identity, const std::string& header, bool resume) {
  const std::string found = read_header(file_);
  if (found.empty()) {
    return refuse("this is no journal of a sweep; move it away, or give the output another name");
  }
  if (found != header) {
    return refuse(
        fmt::format("this is of another sweep: not the same {}; remove it to begin anew, or give the "
                    "output another name",
                    differences(identity_of(found), identity)));
  }
  return resume ||
         refuse(
             "this holds what an interrupted run of this sweep has done: --resume goes on from there; "
             "remove it to begin anew");
}

bool Journal::write(const std::string& bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count =
        ::pwrite(file_, bytes.data() + done, bytes.size() - done, length_ + static_cast<std::int64_t>(done));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {
      fail("cannot write " + (path_.empty() ? "a temporary file" : path_));
      (void)!::ftruncate(file_, length_);  // else the torn block is cut off when it is read
      return false;
    }
    done += static_cast<std::size_t>(count);
  }
  length_ += static_cast<std::int64_t>(bytes.size());
  return true;
}

bool Journal::append(const SweepBlock& block) {
  if (!write(bytes_of(block, width_))) {
    return false;
  }
  ++blocks_;
  return true;
}

// Moves length_ to behind the last whole block.
std::int64_t Journal::read_blocks(const Take& take) {
  const std::int64_t size = size_of(file_);
  std::int64_t count = 0;
  length_ = start_;
  std::string bytes;
  while (size - length_ >= static_cast<std::int64_t>(sizeof(BlockHead) + sizeof(std::uint64_t))) {
    BlockHead head;
    const std::int64_t rest = size - length_ - static_cast<std::int64_t>(sizeof head + sizeof(std::uint64_t));
    if (!read_at(file_, length_, reinterpret_cast<char*>(&head), sizeof head) || head.mark != kBlockMark ||
        head.width != width_ || head.number != count || head.rows < 0 || head.cause_bytes < 0 ||
        head.cause_bytes > rest ||
        head.rows > (rest - head.cause_bytes) / static_cast<std::int64_t>(width_ * sizeof(double))) {
      break;
    }
    const auto payload = static_cast<std::size_t>(head.rows) * width_ * sizeof(double) +
                         static_cast<std::size_t>(head.cause_bytes);
    bytes.resize(sizeof head + payload + sizeof(std::uint64_t));
    std::uint64_t sum = 0;
    if (!read_at(file_, length_, bytes.data(), bytes.size())) {
      break;
    }
    std::memcpy(&sum, bytes.data() + sizeof head + payload, sizeof sum);
    if (sum != checksum(std::string_view(bytes).substr(0, sizeof head + payload))) {
      break;
    }
    if (!take(block_of(head, std::string_view(bytes).substr(sizeof head, payload)))) {
      break;
    }
    length_ += static_cast<std::int64_t>(bytes.size());
    ++count;
  }
  return count;
}

bool Journal::read(const Take& take) {
  const std::int64_t length = length_;
  bool wanted = true;
  const std::int64_t read = read_blocks([&](const SweepBlock& block) { return wanted = take(block); });
  length_ = length;
  if (read == blocks_ || !wanted) {
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

}  // namespace higherpair::cli
