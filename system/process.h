/// Running other programs so that they do no harm and leave nothing behind.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace lumaknot {

/// A private folder under the system's temporary one, removed with its contents.
class PrivateFolder {
 public:
  PrivateFolder();
  ~PrivateFolder();
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// A program to run: without a shell, in a folder of its own, with an environment of only PATH,
/// HOME and TMPDIR in that folder, a UTF-8 C locale and `environment`.
struct Command {
  std::vector<std::string> arguments;  ///< the program, as an absolute path, first
  std::filesystem::path folder;
  std::vector<std::string> environment;  ///< "NAME=value"
};

/// The result of a program.
struct ProcessResult {
  int exit_code = 0;       ///< 128 + the signal's number when a signal ended it
  bool timed_out = false;  ///< it was killed at its deadline
  double seconds = 0;      ///< wall time
  std::string log;         ///< its output, both streams, the last 64 KiB

  bool succeeded() const { return exit_code == 0 && !timed_out; }
};

/// A running program in its own process group, which is killed when this object is destroyed.
class Process {
 public:
  /// Starts `command`. Throws std::runtime_error when that fails.
  explicit Process(const Command& command);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// Waits until the program ends, or kills its group at `limit` after its start. Throws
  /// Interrupted, with the group killed, when the user asked to stop.
  ProcessResult wait(std::chrono::duration<double> limit);

  /// Its output so far, the last 64 KiB.
  std::string log() const;

  bool running() const;

  /// Sends a signal to the program alone.
  void signal(int number) const;

 private:
  void kill_group();

  std::chrono::steady_clock::time_point start_;
  std::filesystem::path log_path_;
  int pid_ = -1, pid_fd_ = -1;
};

/// The user pressed Ctrl-C or otherwise asked to stop.
struct Interrupted : std::exception {
  const char* what() const noexcept override { return "interrupted"; }
};

/// During its lifetime, SIGINT and SIGTERM end every Process::wait() instead of this program.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
};

/// Throws Interrupted when the user asked to stop while an InterruptGuard exists.
void check_interrupted();

/// The parts of `text` between separators, one more than there are separators.
std::vector<std::string_view> split(std::string_view text, char separator);

/// Runs `command` from start to end.
ProcessResult run(const Command& command, std::chrono::duration<double> limit);

/// The program `name` as an absolute path: itself when it contains a slash, else looked up in PATH.
/// Empty if absent.
std::filesystem::path find_program(const std::string& name);

/// The program `name`, which is built with this one: next to it or (test programs) one folder above
/// it, else in PATH. Empty if absent.
std::filesystem::path program_beside(const std::string& name);

}  // namespace lumaknot
