#include "runner/catalog/writer.hpp"

#include <SQLiteCpp/Exception.h>
#include <sqlite3.h>

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <future>
#include <mutex>
#include <thread>
#include <unordered_set>

#include "runner/catalog/catalog_error.hpp"
#include "runner/catalog/connection.hpp"

namespace mpmstudy {
namespace {

struct Task {
  std::function<void(Store&)> work;
  std::function<void(std::exception_ptr)> answer;  ///< after the commit; null pointer: all is well
};

}  // namespace

struct CatalogWriter::Impl {
  std::filesystem::path path;
  WriterOptions options;
  Store store;

  std::atomic<bool> any_lost{false};  ///< lost is not empty
  mutable std::mutex lost_mutex;
  std::unordered_set<std::string> lost;  // guarded by lost_mutex; jobs that others have taken up

  std::mutex mutex;
  std::condition_variable wake;
  std::deque<Task> queue;     // guarded by mutex
  std::exception_ptr broken;  // guarded by mutex
  bool closing = false;       // guarded by mutex
  std::thread thread;         // last: it uses everything above

  Impl(const std::filesystem::path& results, WriterOptions given)
      : path(catalog_path(results)), options(std::move(given)), store(results, options.store) {
    thread = std::thread([this] { serve(); });
  }

  ~Impl() {
    {
      std::lock_guard lock(mutex);
      closing = true;
    }
    wake.notify_one();
    thread.join();
  }

  void post(Task task) {
    {
      std::lock_guard lock(mutex);
      if (broken) std::rethrow_exception(broken);
      queue.push_back(std::move(task));
    }
    wake.notify_one();
  }

  /// Runs work on the writer's thread; gives back its value once it is committed.
  template <class Work>
  auto ask(Work work) {
    using Value = std::invoke_result_t<Work&, Store&>;
    auto promise = std::make_shared<std::promise<Value>>();
    auto future = promise->get_future();
    if constexpr (std::is_void_v<Value>) {
      post({std::move(work), [promise](std::exception_ptr error) {
              error ? promise->set_exception(error) : promise->set_value();
            }});
    } else {
      auto value = std::make_shared<Value>();
      post({[value, work = std::move(work)](Store& s) mutable { *value = work(s); },
            [promise, value](std::exception_ptr error) {
              error ? promise->set_exception(error) : promise->set_value(std::move(*value));
            }});
    }
    return future.get();
  }

  /// Runs work on the writer's thread; its error breaks the writer.
  template <class Work>
  void tell(Work work) {
    post({std::move(work), [this](std::exception_ptr error) {
            if (error) fail(error);
          }});
  }

  void fail(std::exception_ptr error) {
    std::lock_guard lock(mutex);
    if (!broken) broken = error;
  }

  std::exception_ptr translated() {
    try {
      throw;
    } catch (const SQLite::Exception& error) {
      const int code = error.getErrorCode();
      const char* advice = code == SQLITE_FULL    ? "; make room and run again: what is committed stays"
                           : code == SQLITE_BUSY  ? "; another process has held the catalog for too long"
                           : code == SQLITE_IOERR ? "; the disk refuses, check it and run again"
                                                  : "";
      return std::make_exception_ptr(
          CatalogError(path.string() + ": cannot be written (" + error.what() + ")" + advice));
    } catch (...) {
      return std::current_exception();
    }
  }

  void serve() {
    auto last_beat = std::chrono::steady_clock::now();
    auto last_move = last_beat - options.move_log;  // the first one soon: the tables
    while (true) {
      std::deque<Task> batch;
      {
        std::unique_lock lock(mutex);
        const auto work = [this] { return closing || !queue.empty(); };
        const bool beat = !wake.wait_for(lock, options.heartbeat, work);
        batch.swap(queue);
        if (batch.empty() && !beat) break;
      }
      if (!batch.empty()) commit(batch);
      if (const auto now = std::chrono::steady_clock::now(); now - last_beat >= options.heartbeat) {
        last_beat = now;
        try_alone([this](Store& s) {
          s.heartbeat();
          note_lost(s.lost());
        });
        if (now - last_move >= options.move_log) {
          last_move = now;
          store.move_log();
        }
      }
    }
    try_alone([](Store& s) { s.leave(); });
    store.move_log();
  }

  void note_lost(const std::vector<std::string>& keys) {
    if (keys.empty()) return;
    std::lock_guard lock(lost_mutex);
    lost.insert(keys.begin(), keys.end());
    any_lost = true;
  }
  void forget_lost(const std::string& key) {
    if (!any_lost) return;
    std::lock_guard lock(lost_mutex);
    lost.erase(key);
    any_lost = !lost.empty();
  }

  /// A heartbeat, or the entry that this process has ended: if it cannot be written, the next write of a
  /// result
  /// reports the error.
  template <class Work>
  void try_alone(Work work) noexcept {
    try {
      store.begin();
      work(store);
      store.commit();
    } catch (...) {
      store.rollback();
    }
  }

  /// One transaction for all; a task that throws is undone alone.
  void commit(std::deque<Task>& batch) {
    std::vector<std::exception_ptr> errors(batch.size());
    try {
      store.begin();
      for (std::size_t i = 0; i < batch.size(); ++i) {
        store.begin_part();
        try {
          batch[i].work(store);
          store.commit_part();
        } catch (...) {
          errors[i] = translated();
          store.rollback_part();
        }
      }
      store.commit();
    } catch (...) {
      const auto error = translated();
      store.rollback();
      fail(error);
      errors.assign(batch.size(), error);
    }
    for (std::size_t i = 0; i < batch.size(); ++i) batch[i].answer(errors[i]);
  }
};

CatalogWriter::CatalogWriter(const std::filesystem::path& results, WriterOptions options) try
    : impl_(std::make_unique<Impl>(results, std::move(options))) {
} catch (const SQLite::Exception& error) {
  throw CatalogError(catalog_path(results).string() + ": cannot be written (" + error.what() + ")");
}

CatalogWriter::~CatalogWriter() = default;

Registration CatalogWriter::register_study(const std::string& name, const std::string& title,
                                           std::vector<Job> jobs, bool retry_failed, StudySource source,
                                           Selection selection) {
  return impl_->ask(
      [=, jobs = std::move(jobs), source = std::move(source), selection = std::move(selection)](Store& s) {
        return s.register_study(name, title, jobs, retry_failed, source, selection);
      });
}

JobReservation CatalogWriter::reserve(const std::string& key) {
  impl_->forget_lost(key);
  return impl_->ask([key](Store& s) { return s.reserve(key); });
}

std::int64_t CatalogWriter::crashed(const std::string& key) {
  return impl_->ask([key](Store& s) { return s.crashed(key); });
}

bool CatalogWriter::complete(FinishedJob job) {
  return impl_->ask([job = std::move(job)](Store& s) { return s.complete(job); });
}

bool CatalogWriter::lost(const std::string& key) const {
  if (!impl_->any_lost) return false;
  std::lock_guard lock(impl_->lost_mutex);
  return impl_->lost.contains(key);
}

bool CatalogWriter::holds(const std::string& key) {
  return impl_->ask([key](Store& s) { return s.holds(key); });
}

void CatalogWriter::release(const std::string& key, const std::string& reason) {
  impl_->tell([key, reason](Store& s) { s.release(key, reason); });
}

std::int64_t CatalogWriter::sweep_files() {
  return impl_->ask([](Store& s) { return s.sweep_files(); });
}

void CatalogWriter::flush() {
  impl_->ask([](Store&) {});
  std::lock_guard lock(impl_->mutex);
  if (impl_->broken) std::rethrow_exception(impl_->broken);
}

JobStatus CatalogWriter::add_finer(const std::string& study, const Job& rung, bool retry_failed) {
  return impl_->ask([=](Store& s) { return s.add_finer(study, rung, retry_failed); });
}

void CatalogWriter::replace_intervals(const std::string& study, std::vector<IntervalRow> rows) {
  impl_->ask([study, rows = std::move(rows)](Store& s) { s.replace_intervals(study, rows); });
}

void CatalogWriter::replace_fits(const std::string& study, std::vector<FitRow> rows) {
  impl_->ask([study, rows = std::move(rows)](Store& s) { s.replace_fits(study, rows); });
}

void CatalogWriter::replace_brackets(const std::string& study, std::vector<BracketRow> rows) {
  impl_->ask([study, rows = std::move(rows)](Store& s) { s.replace_brackets(study, rows); });
}

void CatalogWriter::replace_claims(std::vector<Claim> rows) {
  impl_->ask([rows = std::move(rows)](Store& s) { s.replace_claims(rows); });
}

}  // namespace mpmstudy
