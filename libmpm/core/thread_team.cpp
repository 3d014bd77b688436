#include "libmpm/core/thread_team.hpp"

#include <algorithm>

#include "libmpm/core/thread_clock.hpp"

namespace mpm {
namespace {

// Parts of ThreadTeam::work_.
constexpr std::uint32_t open = 1, joined = 2, number = 1 << 12;

}  // namespace

ThreadTeam::~ThreadTeam() { resize(1); }

void ThreadTeam::resize(int threads) {
  const auto wanted = static_cast<std::size_t>(std::max(threads, 1) - 1);
  if (wanted == helpers_.size()) return;
  end_ = true;
  offer();
  for (std::thread& helper : helpers_) helper.join();
  helpers_.clear();
  end_ = false;
  work_ = 0;
  for (std::size_t k = 0; k < wanted; ++k) helpers_.emplace_back([this] { help(); });
}

void ThreadTeam::offer() {
  returned_.store(0, std::memory_order_relaxed);
  work_.store((work_.load(std::memory_order_relaxed) / number + 1) * number | open,
              std::memory_order_release);
  work_.notify_all();
}

void ThreadTeam::run(std::size_t parts, const std::function<void(std::size_t)>& part) {
  part_ = &part;
  parts_ = parts;
  next_.store(0, std::memory_order_relaxed);
  if (helpers_.empty() || parts < 2) return do_parts();
  offer();
  do_parts();
  const std::uint32_t came = work_.fetch_and(~open, std::memory_order_acq_rel) % number / joined;
  for (std::uint32_t r = 0; (r = returned_.load(std::memory_order_acquire)) < came;)
    returned_.wait(r, std::memory_order_acquire);
}

void ThreadTeam::do_parts() {
  for (std::size_t k = 0; (k = next_.fetch_add(1, std::memory_order_relaxed)) < parts_;) (*part_)(k);
}

void ThreadTeam::help() {
  double told = 0;
  for (std::uint32_t seen = 0;;) {
    work_.wait(seen, std::memory_order_acquire);
    std::uint32_t now = work_.load(std::memory_order_acquire);
    const bool mine = (now & open) && now / number != seen / number;
    if (end_) return;
    if (!mine || !work_.compare_exchange_weak(now, now + joined, std::memory_order_acq_rel)) {
      if (!mine) seen = now;
      continue;
    }
    do_parts();
    const double spent = thread_cpu_seconds();
    seconds_.fetch_add(spent - told, std::memory_order_relaxed);
    told = spent;
    seen = now + joined;
    returned_.fetch_add(1, std::memory_order_release);
    returned_.notify_one();
  }
}

}  // namespace mpm
