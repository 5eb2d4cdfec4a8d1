#include "system/process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/signalfd.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string_view>

namespace lumaknot {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(std::string_view what, int error) {
  throw std::runtime_error(fmt::format("{}: {}", what, std::strerror(error)));
}

sigset_t stop_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  return signals;
}

/// A file descriptor, closed with its owner.
struct Descriptor {
  int fd;
  explicit Descriptor(int number) : fd(number) {}
  ~Descriptor() {
    if (fd >= 0) ::close(fd);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
};

/// Pointers to the strings' characters and a null at the end, as exec wants them.
std::vector<char*> c_strings(std::vector<std::string>& strings) {
  std::vector<char*> pointers;
  pointers.reserve(strings.size() + 1);
  for (std::string& s : strings) pointers.push_back(s.data());
  pointers.push_back(nullptr);
  return pointers;
}

std::vector<std::string> environment_of(const Command& command) {
  const std::string folder = command.folder.string();
  std::vector<std::string> all{"PATH=/usr/local/bin:/usr/bin:/bin", "HOME=" + folder,
                               "TMPDIR=" + folder, "LC_ALL=C.UTF-8"};
  all.insert(all.end(), command.environment.begin(), command.environment.end());
  return all;
}

/// posix_spawn's settings: own process group, default signal handling, `folder` as the current
/// directory, both output streams into `log`, empty input.
struct SpawnSettings {
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;

  SpawnSettings(const fs::path& folder, const fs::path& log) {
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
    posix_spawn_file_actions_adddup2(&actions, 1, 2);
    posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
    posix_spawn_file_actions_addclosefrom_np(&actions, 3);
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
    posix_spawnattr_setpgroup(&attributes, 0);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes, &none);
  }
  ~SpawnSettings() {
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;
};

int exit_code_of(int status) {
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

PrivateFolder::PrivateFolder() {
  std::string name = (fs::temp_directory_path() / "lumaknot-XXXXXX").string();
  if (!::mkdtemp(name.data())) fail(name, errno);
  path_ = name;
}

PrivateFolder::~PrivateFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

Process::Process(const Command& command)
    : start_(std::chrono::steady_clock::now()),
      log_path_(command.folder /
                (fs::path(command.arguments.front()).filename().string() + ".log")) {
  std::vector<std::string> arguments = command.arguments, environment = environment_of(command);
  const SpawnSettings settings(command.folder, log_path_);
  const int error =
      ::posix_spawn(&pid_, arguments.front().c_str(), &settings.actions, &settings.attributes,
                    c_strings(arguments).data(), c_strings(environment).data());
  if (error) fail(command.arguments.front() + " can't be started", error);
  pid_fd_ = int(::syscall(SYS_pidfd_open, pid_, 0));
  if (pid_fd_ < 0) {
    const int why = errno;
    kill_group();
    fail("pidfd_open", why);
  }
}

Process::~Process() {
  kill_group();
  if (pid_fd_ >= 0) ::close(pid_fd_);
}

void Process::kill_group() {
  if (pid_ < 0) return;
  ::kill(-pid_, SIGKILL);
  ::waitpid(pid_, nullptr, 0);
  pid_ = -1;
}

bool Process::running() const {
  pollfd ended{pid_fd_, POLLIN, 0};
  return pid_ >= 0 && ::poll(&ended, 1, 0) == 0;
}

void Process::signal(int number) const {
  if (pid_ >= 0) ::kill(pid_, number);
}

ProcessResult Process::wait(std::chrono::duration<double> limit) {
  const sigset_t signals = stop_signals();
  const Descriptor stop(::signalfd(-1, &signals, SFD_CLOEXEC));
  std::array<pollfd, 2> events{{{pid_fd_, POLLIN, 0}, {stop.fd, POLLIN, 0}}};
  const auto elapsed = [this] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_);
  };
  while (events[0].revents == 0 && elapsed() < limit) {
    const double milliseconds = std::ceil((limit - elapsed()).count() * 1000);
    ::poll(events.data(), events.size(), int(std::clamp(milliseconds, 0.0, 1e6)));
    if (events[1].revents == 0) continue;
    kill_group();  // the signal stays pending: every other wait sees it too
    throw Interrupted();
  }
  ProcessResult ended;
  ended.timed_out = events[0].revents == 0;
  siginfo_t info{};
  if (!ended.timed_out) {
    int status = 0;
    ::waitid(P_PID, id_t(pid_), &info, WEXITED | WNOWAIT);  // keeps the group's number reserved
    ::kill(-pid_, SIGKILL);                                 // its remaining children
    ::waitpid(pid_, &status, 0);
    pid_ = -1;
    ended.exit_code = exit_code_of(status);
  } else {
    kill_group();
    ended.exit_code = 128 + SIGKILL;
  }
  ended.seconds = elapsed().count();
  ended.log = log();
  return ended;
}

std::string Process::log() const {
  constexpr std::streamoff kMax = 65'536;
  std::ifstream stream(log_path_, std::ios::binary | std::ios::ate);
  if (!stream) return {};
  const std::streamoff size = stream.tellg();
  stream.seekg(std::max<std::streamoff>(0, size - kMax));
  return {std::istreambuf_iterator<char>(stream), {}};
}

void check_interrupted() {
  sigset_t pending{};
  ::sigpending(&pending);
  if (::sigismember(&pending, SIGINT) == 1 || ::sigismember(&pending, SIGTERM) == 1) {
    throw Interrupted();
  }
}

InterruptGuard::InterruptGuard() {
  const sigset_t signals = stop_signals();
  ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
}

InterruptGuard::~InterruptGuard() {
  const sigset_t signals = stop_signals();
  ::pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
}

ProcessResult run(const Command& command, std::chrono::duration<double> limit) {
  return Process(command).wait(limit);
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (auto end = text.find(separator); end != text.npos; end = text.find(separator)) {
    parts.push_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  parts.push_back(text);
  return parts;
}

fs::path find_program(const std::string& name) {
  const auto runs = [](const fs::path& p) {
    std::error_code ignored;
    return fs::is_regular_file(p, ignored) && ::access(p.c_str(), X_OK) == 0;
  };
  if (name.find('/') != std::string::npos) return runs(name) ? fs::absolute(name) : fs::path();
  const char* path = std::getenv("PATH");
  for (const std::string_view part : split(path ? path : "", ':')) {
    const fs::path candidate = fs::path(part) / name;
    if (candidate.is_absolute() && runs(candidate)) return candidate;
  }
  return {};
}

std::filesystem::path program_beside(const std::string& name) {
  std::error_code error;
  const std::filesystem::path folder =
      std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  for (const auto& place : {folder / name, folder.parent_path() / name}) {
    if (!error && std::filesystem::exists(place)) return place;
  }
  return find_program(name);
}

}  // namespace lumaknot
