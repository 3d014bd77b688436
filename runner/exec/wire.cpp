#include "runner/exec/wire.hpp"

#include <cstring>
#include <stdexcept>
#include <type_traits>

#include "libmpm/scene/parameters.hpp"
#include "runner/plan/composition_text.hpp"
#include "runner/plan/gauge_text.hpp"

namespace mpmstudy {
namespace {

class Writer {
 public:
  template <class T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
  void operator()(const T& value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); }
  void operator()(const std::string& text) {
    (*this)(text.size());
    bytes += text;
  }
  template <class T>
  void operator()(const std::optional<T>& value) {
    (*this)(value.has_value());
    if (value) (*this)(*value);
  }
  std::string bytes;
};

class Reader {
 public:
  explicit Reader(const std::string& bytes) : bytes_(bytes) {}
  template <class T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
  void operator()(T& value) { std::memcpy(&value, take(sizeof value), sizeof value); }
  void operator()(std::string& text) {
    std::size_t size = 0;
    (*this)(size);
    text.assign(take(size), size);
  }
  template <class T>
  void operator()(std::optional<T>& value) {
    bool there = false;
    (*this)(there);
    if (!there) return value.reset();
    (*this)(value.emplace());
  }
  void check_end() const {
    if (left() > 0) throw std::runtime_error("a message between processes is too long");
  }
  std::size_t left() const { return bytes_.size() - next_; }

 private:
  const char* take(std::size_t size) {
    if (size > left()) throw std::runtime_error("a message between processes is cut off");
    next_ += size;
    return bytes_.data() + next_ - size;
  }
  const std::string& bytes_;
  std::size_t next_ = 0;
};

void numbers(Writer& a, const std::vector<double>& values) {
  a(values.size());
  for (const double value : values) a(value);
}
void numbers(Reader& a, std::vector<double>& values) {
  std::size_t size = 0;
  a(size);
  if (size > a.left()) throw std::runtime_error("a message between processes is damaged");
  values.resize(size);
  for (double& value : values) a(value);
}

// Members in one order for both ways: a is a Writer or a Reader, x what it goes over.
void members(auto& a, auto& x) requires requires { x.void_area; }
{ a(x.time), a(x.area), a(x.void_area); }
void members(auto& a, auto& x) requires requires { x.checksum; }
{ a(x.time), a(x.step), a(x.path), a(x.bytes), a(x.checksum), a(x.modified_ns); }
void members(auto& a, auto& x) requires requires { x.value; }
{ a(x.name), a(x.value), a(x.unit), a(x.error); }

void members(auto& a, auto& x) requires requires { x.times; }
{ a(x.name), a(x.unit), numbers(a, x.times), numbers(a, x.values); }

template <class T>
void rows(Writer& a, const std::vector<T>& values) {
  a(values.size());
  for (const auto& value : values) members(a, value);
}
template <class T>
void rows(Reader& a, std::vector<T>& values) {
  std::size_t size = 0;
  a(size);
  if (size > a.left()) throw std::runtime_error("a message between processes is damaged");
  values.resize(size);
  for (auto& value : values) members(a, value);
}

/// Rows of the parameter table that the scene's kind has; what they are made of, not what they make.
void parameters(Writer& a, const mpm::Scene& scene) {
  for (const auto& q : mpm::quantities())
    if (!q.derived && q.belongs_to(scene.kind)) a(q.get(scene));
  for (const auto& c : mpm::choices())
    if (c.belongs_to(scene.kind)) a(c.get(scene));
}
void parameters(Reader& a, mpm::Scene& scene) {
  for (const auto& q : mpm::quantities())
    if (double value = 0; !q.derived && q.belongs_to(scene.kind)) a(value), q.set(scene, value);
  for (const auto& c : mpm::choices())
    if (std::size_t value = 0; c.belongs_to(scene.kind)) a(value), c.set(scene, value);
}

void gauges(Writer& a, const std::vector<mpm::Gauge>& values) { a(gauges_text(values)); }
void gauges(Reader& a, std::vector<mpm::Gauge>& values) {
  std::string text;
  a(text);
  values = gauges_from_text(text);
}

void composition(Writer& a, const mpm::Scene& scene) { a(composition_text(scene)); }
void composition(Reader& a, mpm::Scene& scene) {
  std::string text;
  a(text);
  set_composition(scene, text);
}

void whole_order(auto& a, auto& order) {
  a(order.key), a(order.limits.seconds), a(order.limits.memory), a(order.checkpoint_s);
  a(order.scene.kind), a(order.scene.material.name);
  parameters(a, order.scene);
  composition(a, order.scene);
  numbers(a, order.scene.measures.snapshots);
  gauges(a, order.scene.measures.gauges);
}

void whole_attempt(auto& a, auto& attempt) {
  a(attempt.end), a(attempt.why);
  auto& job = attempt.job;
  a(job.key), a(job.status), a(job.reason), a(job.failure), a(job.wall_s), a(job.cpu_s);
  rows(a, job.snapshots);
  auto& r = job.result;
  a(r.status), a(r.reason), a(r.particles), a(r.steps), a(r.energy_error), a(r.outcome);
  a(r.initial_area), a(r.final_area), a(r.final_area_error), a(r.collapsibility), a(r.collapsibility_error);
  rows(a, r.area_history);
  rows(a, r.histories);
  rows(a, r.metrics);
}

}  // namespace

std::string to_bytes(const Attempt& attempt) {
  Writer writer;
  whole_attempt(writer, attempt);
  return std::move(writer.bytes);
}

Attempt attempt_from_bytes(const std::string& bytes) {
  Reader reader(bytes);
  Attempt attempt;
  whole_attempt(reader, attempt);
  reader.check_end();
  return attempt;
}

std::string to_bytes(const Order& order) {
  Writer writer;
  whole_order(writer, order);
  return std::move(writer.bytes);
}

Order order_from_bytes(const std::string& bytes) {
  Reader reader(bytes);
  Order order;
  whole_order(reader, order);
  reader.check_end();
  return order;
}

}  // namespace mpmstudy
