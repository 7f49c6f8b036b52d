// Where a fuzzer writes its files.
#pragma once

#include <filesystem>
#include <string>

#include <unistd.h>

// Removed when the fuzzer ends; in memory where the system has such a folder.
class FuzzFolder
{
public:
  FuzzFolder()
      : path_(std::filesystem::path(std::filesystem::exists("/dev/shm") ? "/dev/shm" : "/tmp") /
              ("interlock_fuzz_" + std::to_string(getpid())))
  {
    std::filesystem::create_directories(path_);
  }
  ~FuzzFolder()
  {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
  }
  FuzzFolder(const FuzzFolder&) = delete;
  FuzzFolder& operator=(const FuzzFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

private:
  std::filesystem::path path_;
};
