// Preloaded library that kills its process at a system call chosen by a test.
//
// State that must survive a killed program goes to disk by a few system calls. KUSABI_MORTAL=N
// kills the process at the Nth of these calls on a file whose name contains KUSABI_MORTAL_FILE:
// before the call if N is odd, otherwise during it (half of the bytes are written) or right after
// it. KUSABI_MORTAL_RANK is the rank of an MPI job, 0 by default. Clocks are not used, so the speed
// of the machine does not matter.
#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <dlfcn.h>
#include <sys/uio.h>
#include <unistd.h>

namespace {

std::string variable(const char* name, const char* usual) {
  const char* const value = std::getenv(name);
  return value != nullptr ? value : usual;
}

std::string rank() {
  return variable("OMPI_COMM_WORLD_RANK", variable("PMI_RANK", "0").c_str());
}

// Number of the system calls counted; 0: the process is not killed.
long chosen_call() {
  static const bool is_mortal = variable("KUSABI_MORTAL_RANK", "0") == rank();
  static const long number = is_mortal ? std::atol(variable("KUSABI_MORTAL", "0").c_str()) : 0;
  return number;
}

enum class Fate { lives, dies_before, dies_within };

Fate fate(const std::string& file) {
  static long calls = 0;
  static const std::string part = variable("KUSABI_MORTAL_FILE", "");
  if (chosen_call() == 0 || file.find(part) == std::string::npos) return Fate::lives;
  if (++calls != chosen_call()) return Fate::lives;
  return calls % 2 == 1 ? Fate::dies_before : Fate::dies_within;
}

Fate fate(int descriptor) {
  if (chosen_call() == 0) return Fate::lives;
  const auto link = "/proc/self/fd/" + std::to_string(descriptor);
  std::array<char, 4096> name{};
  const auto length = readlink(link.c_str(), name.data(), name.size());
  return length <= 0 ? Fate::lives
                     : fate(std::string(name.data(), static_cast<std::size_t>(length)));
}

[[noreturn]] void die() {
  kill(getpid(), SIGKILL);
  for (;;) pause();
}

template <class Function>
Function real(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

// Executes the call, or kills the process.
template <class Subject, class Call, class Part>
auto lived_through(Subject subject, Call call, Part part) {
  const auto own = fate(subject);
  if (own == Fate::dies_within) part();
  if (own != Fate::lives) die();
  return call();
}

}  // namespace

// Declared as in the C library, except for names of parameters.
// NOLINTBEGIN(readability-inconsistent-declaration-parameter-name)
extern "C" {

ssize_t write(int descriptor, const void* bytes, size_t count) {
  static const auto its = real<decltype(&write)>("write");
  return lived_through(
      descriptor, [&] { return its(descriptor, bytes, count); },
      [&] { its(descriptor, bytes, count / 2); });
}

ssize_t writev(int descriptor, const iovec* pieces, int count) {
  static const auto its = real<decltype(&writev)>("writev");
  return lived_through(
      descriptor, [&] { return its(descriptor, pieces, count); },
      [&] { its(descriptor, pieces, 1); });
}

ssize_t pwrite(int descriptor, const void* bytes, size_t count, off_t at) {
  static const auto its = real<decltype(&pwrite)>("pwrite");
  return lived_through(
      descriptor, [&] { return its(descriptor, bytes, count, at); },
      [&] { its(descriptor, bytes, count / 2, at); });
}

int fsync(int descriptor) {
  static const auto its = real<decltype(&fsync)>("fsync");
  const auto call = [&] { return its(descriptor); };
  return lived_through(descriptor, call, call);
}

int fdatasync(int descriptor) {
  static const auto its = real<decltype(&fdatasync)>("fdatasync");
  const auto call = [&] { return its(descriptor); };
  return lived_through(descriptor, call, call);
}

int ftruncate(int descriptor, off_t size) noexcept {
  static const auto its = real<int (*)(int, off_t)>("ftruncate");
  const auto call = [&] { return its(descriptor, size); };
  return lived_through(descriptor, call, call);
}

int rename(const char* from, const char* to) noexcept {
  static const auto its = real<int (*)(const char*, const char*)>("rename");
  const auto call = [&] { return its(from, to); };
  return lived_through(std::string(to), call, call);
}

int remove(const char* name) noexcept {
  static const auto its = real<int (*)(const char*)>("remove");
  const auto call = [&] { return its(name); };
  return lived_through(std::string(name), call, call);
}
}
// NOLINTEND(readability-inconsistent-declaration-parameter-name)
