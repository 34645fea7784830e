#include "sweep/journal.hpp"

#include "sweep/block_bytes.hpp"

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
  return fmt::format("{}{}\n", kMagic, identity_text(identity));
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

std::string identity_text(const SweepIdentity& identity) {
  std::string text;
  for (const auto& [name, value] : identity) {
    text += fmt::format("{} {}\n", name, value);
  }
  return text;
}

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
  if (!write(block_bytes(block, width_))) {
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
  std::string bytes(kBlockHeadSize, '\0');
  while (size - length_ >= static_cast<std::int64_t>(kBlockHeadSize)) {
    bytes.resize(kBlockHeadSize);
    if (!read_at(file_, length_, bytes.data(), kBlockHeadSize)) {
      break;
    }
    const auto whole = block_size(bytes, width_, static_cast<std::size_t>(size - length_));
    if (!whole) {
      break;
    }
    bytes.resize(*whole);
    if (!read_at(file_, length_, bytes.data(), bytes.size())) {
      break;
    }
    const auto block = block_of(bytes, width_);
    if (!block || block->number != count || !take(*block)) {
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
