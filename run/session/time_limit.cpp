// Durations by their units; squeue is called if the environment has no end time.
#include "run/session/time_limit.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "run/output/wrong_input.hpp"

namespace kusabi::run {
namespace {

constexpr double minute = 60;
constexpr double hour = 60 * minute;
constexpr double day = 24 * hour;

// Removes the number at the beginning of a text. @return the number
std::optional<double> take_number(std::string_view& text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || !std::isfinite(number) || number < 0) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number;
}

std::optional<double> unit_of(char letter) {
  switch (letter) {
    case 's':
      return 1;
    case 'm':
      return minute;
    case 'h':
      return hour;
    case 'd':
      return day;
    default:
      return std::nullopt;
  }
}

// Remaining time in the format of squeue: "MM:SS", "HH:MM:SS", "D-HH:MM:SS".
std::optional<double> seconds_of_squeue(std::string_view text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.remove_suffix(1);
  double days = 0;
  if (const auto dash = text.find('-'); dash != std::string_view::npos) {
    auto before = text.substr(0, dash);
    const auto number = take_number(before);
    if (!number || !before.empty()) return std::nullopt;
    days = *number;
    text.remove_prefix(dash + 1);
  }
  double seconds = 0;
  for (bool first = true; first || !text.empty(); first = false) {
    if (!first) {
      if (text.front() != ':') return std::nullopt;
      text.remove_prefix(1);
    }
    const auto number = take_number(text);
    if (!number) return std::nullopt;
    seconds = minute * seconds + *number;
  }
  return day * days + seconds;
}

std::string printed_by(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), &pclose);
  std::string text;
  std::array<char, 256> piece{};
  while (pipe) {
    const auto count = std::fread(piece.data(), 1, piece.size(), pipe.get());
    if (count == 0) break;
    text.append(piece.data(), count);
  }
  return text;
}

}  // namespace

std::optional<double> seconds_in(std::string_view text) {
  double seconds = 0;
  double last_unit = std::numeric_limits<double>::infinity();
  for (bool first = true; first || !text.empty(); first = false) {
    const auto number = take_number(text);
    if (!number) return std::nullopt;
    if (first && text.empty()) {
      seconds = *number;
      break;
    }
    const auto unit = text.empty() ? std::nullopt : unit_of(text.front());
    if (!unit || *unit >= last_unit) return std::nullopt;
    text.remove_prefix(1);
    seconds += *unit * *number;
    last_unit = *unit;
  }
  if (!(seconds > 0) || !std::isfinite(seconds)) return std::nullopt;
  return seconds;
}

double margin_before_the_end(double left) {
  constexpr double maximum = 2 * minute;
  constexpr double share = 0.1;
  return std::clamp(share * left, 0.0, maximum);
}

double seconds_to_write(std::uint64_t results) {
  constexpr double each = 1e-4;
  return each * static_cast<double>(results);
}

double seconds_of_slurm_job(const Environment& environment, const Shell& shell, double now) {
  const auto* const job = environment("SLURM_JOB_ID");
  if (job == nullptr) {
    throw WrongInput(
        "--time-limit slurm: not in a Slurm job (SLURM_JOB_ID is not set); expected a duration "
        "such as 1h30m");
  }
  const auto less_margin = [](double left) {
    return std::max(0.0, left - margin_before_the_end(left));
  };
  if (const auto* const end = environment("SLURM_JOB_END_TIME")) {
    std::string_view text(end);
    if (const auto at = take_number(text); at && text.empty()) return less_margin(*at - now);
  }
  std::string_view digits(job);
  const auto number = take_number(digits);  // only a number is passed to the shell
  const auto left = number && digits.empty()
                        ? shell(fmt::format("squeue -h -j {} -o %L 2>/dev/null", job))
                        : std::string();
  if (const auto seconds = seconds_of_squeue(left)) return less_margin(*seconds);
  throw WrongInput(
      fmt::format("--time-limit slurm: the end of job {} is unknown (SLURM_JOB_END_TIME is not "
                  "set, and squeue prints '{}'); expected a duration such as 1h30m",
                  job, left.substr(0, left.find('\n'))));
}

double seconds_of_slurm_job() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return seconds_of_slurm_job([](const char* name) { return std::getenv(name); }, printed_by,
                              std::chrono::duration<double>(now).count());
}

using Clock = std::chrono::steady_clock;

double JobEnd::read(Session& session) {
  const double left = session.from_first_rank([] { return seconds_of_slurm_job(); });
  set(left);
  return left;
}

void JobEnd::set(double seconds) {
  at_ = Clock::now() +
        std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

double JobEnd::remaining_seconds() const {
  const std::chrono::duration<double> left = *at_ - Clock::now();
  return left.count();
}

void JobEnd::reserve_time_to_write(std::function<double(std::uint64_t results)> seconds_to_write,
                                   engine::AnalysisOptions& analysis_options) const {
  const auto found = std::make_shared<std::uint64_t>(0);
  analysis_options.watch = [found, watch = analysis_options.watch](
                               engine::Goal goal, const engine::ShownObjective& shown) {
    const auto show = watch ? watch(goal, shown) : std::function<void(const engine::Progress&)>();
    return [found, show](const engine::Progress& progress) {
      *found = progress.found;
      if (show) show(progress);
    };
  };
  analysis_options.interrupt = [end = *this, found, seconds_to_write = std::move(seconds_to_write),
                                asked = analysis_options.interrupt] {
    if (*found != 0 && end.remaining_seconds() <= seconds_to_write(*found))
      return engine::Interrupt::stop;
    return asked();
  };
}

}  // namespace kusabi::run
