#pragma once

#include <sys/resource.h>

#include <csignal>

namespace support {

/// While it lives, no file of this process can grow beyond `bytes`: a full disk that needs no
/// privileges. Writes then fail with EFBIG where a full disk says ENOSPC; the program's path is the
/// same.
class SmallDisk {
public:
  explicit SmallDisk(rlim_t bytes) {
    old_handler_ = std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &old_limit_);
    rlimit limit = old_limit_;
    limit.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~SmallDisk() {
    setrlimit(RLIMIT_FSIZE, &old_limit_);
    std::signal(SIGXFSZ, old_handler_);
  }
  SmallDisk(SmallDisk const&) = delete;
  SmallDisk& operator=(SmallDisk const&) = delete;

private:
  rlimit old_limit_{};
  void (*old_handler_)(int) = SIG_DFL;
};

} // namespace support
