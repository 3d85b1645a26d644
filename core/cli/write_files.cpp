#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cli/files.h"

namespace liftarm::cli {

namespace {

namespace fs = std::filesystem;

constexpr mode_t kNewFile = 0666;  // less what the shell's umask takes
constexpr int kMostNames = 100;

base::Error failed(const std::string& path, int reason) {
  return {base::Status::kInvalidInput,
          path + ": cannot be written (" + std::generic_category().message(reason) + ")"};
}

//! Writes all of it to an open file and closes that. \return Why not, or nothing.
std::optional<int> writeAndClose(int file, const std::string& content, bool flush) {
  std::optional<int> reason;
  std::size_t done = 0;
  while (done < content.size() && !reason.has_value()) {
    const ssize_t written = ::write(file, content.data() + done, content.size() - done);
    if (written >= 0) {
      done += static_cast<std::size_t>(written);
    } else if (errno != EINTR) {
      reason = errno;
    }
  }
  if (!reason.has_value() && flush && ::fsync(file) != 0) {
    reason = errno;
  }
  if (::close(file) != 0 && !reason.has_value()) {
    reason = errno;
  }
  return reason;
}

//! A file under a passing name, which is removed again unless it takes its place.
class StagedFile {
 public:
  StagedFile(std::string place, std::string passing)
      : place_(std::move(place)), passing_(std::move(passing)) {}

  StagedFile(const StagedFile&) = delete;
  StagedFile& operator=(const StagedFile&) = delete;
  StagedFile& operator=(StagedFile&&) = delete;

  StagedFile(StagedFile&& other) noexcept
      : place_(std::move(other.place_)), passing_(std::move(other.passing_)) {
    other.passing_.clear();
  }

  ~StagedFile() {
    if (!passing_.empty()) {
      ::unlink(passing_.c_str());
    }
  }

  //! \return Why it cannot, or nothing.
  std::optional<int> takePlace() {
    if (::rename(passing_.c_str(), place_.c_str()) != 0) {
      return errno;
    }
    passing_.clear();
    return std::nullopt;
  }

 private:
  std::string place_;
  std::string passing_;
};

//! Where a path leads: through links, so that a link stays one.
std::string placeOf(const std::string& path) {
  std::error_code error;
  const fs::path real = fs::canonical(path, error);
  return error ? path : real.string();
}

base::Result<StagedFile> stage(const FileText& text, const std::string& place) {
  struct stat old {};

  const bool isThere = ::stat(place.c_str(), &old) == 0;
  if (isThere && ::access(place.c_str(), W_OK) != 0) {
    return failed(text.path, errno);  // write-protected: a new file in its place would get round it
  }
  for (int attempt = 0; attempt < kMostNames; ++attempt) {
    const std::string passing =
        place + "." + std::to_string(::getpid()) + "." + std::to_string(attempt) + ".part";
    const int file = ::open(passing.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kNewFile);
    if (file < 0 && errno == EEXIST) {
      continue;
    }
    if (file < 0) {
      return failed(text.path, errno);
    }
    StagedFile staged(place, passing);
    if (isThere) {
      (void)::fchmod(file, old.st_mode & 07777U);
    }
    if (const std::optional<int> reason = writeAndClose(file, text.content, true)) {
      return failed(text.path, *reason);
    }
    return staged;
  }
  return failed(text.path, EEXIST);
}

//! A device or a pipe: nothing there is replaced.
std::optional<base::Error> writeInto(const FileText& text) {
  const int file = ::open(text.path.c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0) {
    return failed(text.path, errno);
  }
  const std::optional<int> reason = writeAndClose(file, text.content, false);
  return reason.has_value() ? std::optional(failed(text.path, *reason)) : std::nullopt;
}

}  // namespace

base::Result<std::size_t> writeFiles(const std::vector<FileText>& files) {
  struct Waiting {
    StagedFile file;
    const FileText* text;
  };

  std::vector<Waiting> waiting;
  for (const FileText& text : files) {
    std::error_code ignored;
    const fs::file_status status = fs::status(text.path, ignored);
    if (fs::is_directory(status)) {
      return failed(text.path, EISDIR);
    }
    if (fs::exists(status) && !fs::is_regular_file(status)) {
      if (std::optional<base::Error> error = writeInto(text)) {
        return *std::move(error);
      }
      continue;
    }
    base::Result<StagedFile> staged = stage(text, placeOf(text.path));
    if (!staged.ok()) {
      return staged.error();
    }
    waiting.push_back({std::move(staged).value(), &text});
  }
  for (Waiting& one : waiting) {
    if (const std::optional<int> reason = one.file.takePlace()) {
      return failed(one.text->path, *reason);
    }
  }
  return files.size();
}

bool isSameFile(const std::string& a, const std::string& b) {
  std::error_code error;
  return fs::equivalent(a, b, error) && !error;
}

}  // namespace liftarm::cli
