#include "runner/exec/isolation.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstring>
#include <fstream>
#include <mutex>
#include <system_error>

#include "runner/exec/stopwatch.hpp"
#include "runner/exec/wire.hpp"

extern "C" {  // not declared by the header of glibc 2.36
#include <sys/pidfd.h>
}

namespace mpmstudy {
namespace {

using Clock = std::chrono::steady_clock;

/// How long a job may go on after its time is over [s].
constexpr double patience = 2;

enum class Kind : std::uint8_t { progress, attempt, ended, note };

class Socket {
 public:
  explicit Socket(int number) : number_(number) {}
  ~Socket() { reset(); }
  Socket(Socket&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Socket& operator=(Socket&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  int get() const { return number_; }
  void reset() {
    if (number_ >= 0) close(number_);
    number_ = -1;
  }

 private:
  int number_;
};

std::array<Socket, 2> socket_pair(int type) {
  int ends[2];
  if (socketpair(AF_UNIX, type | SOCK_CLOEXEC, 0, ends) != 0)
    throw std::system_error(errno, std::generic_category(), "a process for a job");
  return {Socket(ends[0]), Socket(ends[1])};
}

/// False if the other end is gone.
bool send_all(int socket, const void* data, std::size_t size) {
  const auto* next = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t sent = send(socket, next, size, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    next += sent;
    size -= static_cast<std::size_t>(sent);
  }
  return true;
}

bool send_message(int socket, Kind kind, const void* data, std::size_t size) {
  std::array<char, 1 + sizeof(std::uint64_t)> head;
  head[0] = static_cast<char>(kind);
  const std::uint64_t length = size;
  std::memcpy(head.data() + 1, &length, sizeof length);
  return send_all(socket, head.data(), head.size()) && send_all(socket, data, size);
}

/// A message of one piece, with a socket that goes with it.
bool send_request(int server, const std::string& order, int socket) {
  iovec data{const_cast<char*>(order.data()), order.size()};
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> control{};
  msghdr message{};
  message.msg_iov = &data, message.msg_iovlen = 1;
  message.msg_control = control.data(), message.msg_controllen = control.size();
  cmsghdr* head = CMSG_FIRSTHDR(&message);
  head->cmsg_level = SOL_SOCKET, head->cmsg_type = SCM_RIGHTS, head->cmsg_len = CMSG_LEN(sizeof(int));
  std::memcpy(CMSG_DATA(head), &socket, sizeof socket);
  return sendmsg(server, &message, MSG_NOSIGNAL) == static_cast<ssize_t>(order.size());
}

/// The socket of the job asked for, or -1 when the runner is gone.
int receive_request(int server, std::string& order) {
  ssize_t size = 0;
  do {
    size = recv(server, nullptr, 0, MSG_PEEK | MSG_TRUNC);
  } while (size < 0 && errno == EINTR);
  if (size <= 0) return -1;
  order.resize(static_cast<std::size_t>(size));
  iovec data{order.data(), order.size()};
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> control{};
  msghdr message{};
  message.msg_iov = &data, message.msg_iovlen = 1;
  message.msg_control = control.data(), message.msg_controllen = control.size();
  if (recvmsg(server, &message, MSG_CMSG_CLOEXEC) != size) return -1;
  const cmsghdr* head = CMSG_FIRSTHDR(&message);
  if (head == nullptr) return -1;
  int socket = -1;
  std::memcpy(&socket, CMSG_DATA(head), sizeof socket);
  return socket;
}

/// The bound counts from what the process has now: it begins with the memory of the program.
void bound_memory(std::uint64_t bytes) {
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const rlim_t limit = pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) + bytes;
  const rlimit bound{limit, limit};
  setrlimit(RLIMIT_AS, &bound);
}

/// The process of one job.
[[noreturn]] void be_job(const std::string& bytes, const Simulate& simulate, const WriteSnapshot& write,
                         const std::filesystem::path& results, int socket) {
  const Order order = order_from_bytes(bytes);
  const Job job{order.key, order.scene, {}, 0};
  bool gone = false;
  const AttemptContext context{
      simulate,
      write,
      results,
      order.limits,
      [&] { return gone; },
      [&](const mpm::Progress& p) { gone = !send_message(socket, Kind::progress, &p, sizeof p); },
      [] { return 1; },
      order.checkpoint_s,
      [] { return false; },
      [&](const std::string& text) { send_message(socket, Kind::note, text.data(), text.size()); }};
  if (order.limits.memory > 0) bound_memory(order.limits.memory);
  const std::string answer = to_bytes(attempt_job(job, context));
  send_message(socket, Kind::attempt, answer.data(), answer.size());
  _exit(0);
}

/// Waits for the job, kills it when the runner wants no more of it, tells how it ended.
[[noreturn]] void be_guard(pid_t job, int socket) {
  const int process = pidfd_open(job, 0);
  std::array<pollfd, 2> watched{{{socket, POLLIN, 0}, {process, POLLIN, 0}}};
  while (poll(watched.data(), watched.size(), -1) < 0 && errno == EINTR) {
  }
  if (watched[1].revents == 0) kill(job, SIGKILL);
  int status = 0;
  waitpid(job, &status, 0);
  send_message(socket, Kind::ended, &status, sizeof status);
  _exit(0);
}

std::string how(int status) {
  if (WIFSIGNALED(status))
    return fmt::format("signal {} ({})", WTERMSIG(status), sigdescr_np(WTERMSIG(status)));
  return fmt::format("exit code {}", WEXITSTATUS(status));
}

/// The runner's end of a job's socket.
class WireAnswer {
 public:
  explicit WireAnswer(Socket socket) : socket_(std::move(socket)) {}

  /// Reads what is there, waits at most this long. False when the other end is closed.
  bool read(std::chrono::milliseconds wait) {
    pollfd watched{socket_.get(), POLLIN, 0};
    if (poll(&watched, 1, static_cast<int>(wait.count())) <= 0) return true;
    std::array<char, 1 << 16> block;
    const ssize_t got = recv(socket_.get(), block.data(), block.size(), 0);
    if (got < 0 && errno == EINTR) return true;
    if (got <= 0) return false;
    bytes_.append(block.data(), static_cast<std::size_t>(got));
    return true;
  }
  /// The next whole message.
  bool next(Kind& kind, std::string& payload) {
    constexpr std::size_t head = 1 + sizeof(std::uint64_t);
    if (bytes_.size() < head) return false;
    std::uint64_t length = 0;
    std::memcpy(&length, bytes_.data() + 1, sizeof length);
    if (bytes_.size() - head < length) return false;
    kind = static_cast<Kind>(bytes_[0]);
    payload = bytes_.substr(head, length);
    bytes_.erase(0, head + length);
    return true;
  }
  /// The guard then kills the job.
  void give_up() { shutdown(socket_.get(), SHUT_WR); }

 private:
  Socket socket_;
  std::string bytes_;
};

}  // namespace

struct JobServer::Impl {
  Socket server{-1};
  pid_t process = -1;
  std::mutex mutex;  ///< one request at a time
};

namespace {

/// The server process: a request at a time, until the runner closes the socket.
[[noreturn]] void serve(int server, const Simulate& simulate, const WriteSnapshot& write,
                        const std::filesystem::path& results) {
  // Ctrl-C goes to every process of the terminal; what a stop means for a job is decided by the runner.
  ignore_stop_signals();
  signal(SIGCHLD, SIG_IGN);  // guards are not waited for
  std::string order;
  for (int socket = receive_request(server, order); socket >= 0; socket = receive_request(server, order)) {
    if (fork() == 0) {
      close(server);
      signal(SIGCHLD, SIG_DFL);
      const pid_t job = fork();
      if (job == 0) be_job(order, simulate, write, results, socket);
      be_guard(job, socket);
    }
    close(socket);
  }
  _exit(0);
}

}  // namespace

JobServer::JobServer(const Simulate& simulate, const WriteSnapshot& write,
                     const std::filesystem::path& results)
    : impl_(std::make_unique<Impl>()) {
  auto ends = socket_pair(SOCK_SEQPACKET);
  impl_->process = fork();
  if (impl_->process < 0) throw std::system_error(errno, std::generic_category(), "a process for jobs");
  if (impl_->process == 0) {
    ends[0].reset();
    serve(ends[1].get(), simulate, write, results);
  }
  impl_->server = std::move(ends[0]);
}

JobServer::~JobServer() {
  impl_->server.reset();
  waitpid(impl_->process, nullptr, 0);
}

Attempt JobServer::attempt(const Job& job, const AttemptContext& context) {
  auto ends = socket_pair(SOCK_STREAM);
  {
    std::lock_guard lock(impl_->mutex);
    if (!send_request(impl_->server.get(),
                      to_bytes(Order{job.key, job.scene, context.limits, context.checkpoint_s}),
                      ends[1].get()))
      return {Attempt::End::storage, {}, "the process that starts jobs is gone"};
  }
  ends[1].reset();
  WireAnswer answer(std::move(ends[0]));

  std::optional<Attempt> attempt;
  mpm::Progress at{};
  const auto start = Clock::now();
  Stopwatch watch;
  const double limit = context.limits.seconds;
  bool given_up = false, late = false;
  std::string crash = "the end of the one that started it";
  Kind kind{};
  std::string payload;
  while (answer.read(std::chrono::milliseconds(50))) {
    while (answer.next(kind, payload)) {
      if (kind == Kind::attempt) attempt = attempt_from_bytes(payload);
      if (kind == Kind::note) context.note(payload);
      if (kind == Kind::progress && payload.size() == sizeof(mpm::Progress)) {
        std::memcpy(&at, payload.data(), sizeof at);
        context.progress(at);
      }
      if (kind == Kind::ended && payload.size() == sizeof(int)) {
        int status = 0;
        std::memcpy(&status, payload.data(), sizeof status);
        crash = how(status);
      }
    }
    const double seconds = watch.seconds();
    late = limit > 0 && seconds > limit + patience;
    if (!given_up && (late || context.stopping())) {
      answer.give_up();
      given_up = true;
    }
  }
  if (attempt) return *attempt;
  Attempt lost;
  lost.job.key = job.key;
  lost.job.wall_s = std::chrono::duration<double>(Clock::now() - start).count();
  lost.job.status = JobStatus::failed;
  lost.job.result.status = mpm::RunStatus::failed;
  lost.job.result.particles = at.particles;
  lost.job.result.steps = at.step;
  if (late) {
    lost.job.failure = FailureKind::timeout;
    lost.job.reason =
        fmt::format("ran longer than {} s and had to be killed (step {}, t = {} s)", limit, at.step, at.time);
  } else if (given_up) {
    lost.end = Attempt::End::stopped;
  } else {
    lost.end = Attempt::End::crashed;
    lost.job.failure = FailureKind::crash;
    lost.why = fmt::format("its process ended by {} (step {}, t = {} s)", crash, at.step, at.time);
  }
  return lost;
}

}  // namespace mpmstudy
