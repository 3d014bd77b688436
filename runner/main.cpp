/// mpmstudy: parameter studies of shock problems by the material point method.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>

#include "libmpm/io/vtkhdf.hpp"
#include "libmpm/simulation.hpp"
#include "runner/catalog/catalog_error.hpp"
#include "runner/cli/bench.hpp"
#include "runner/cli/check.hpp"
#include "runner/cli/cli.hpp"
#include "runner/cli/explain.hpp"
#include "runner/cli/export.hpp"
#include "runner/cli/figures.hpp"
#include "runner/cli/forget.hpp"
#include "runner/cli/gc.hpp"
#include "runner/cli/merge.hpp"
#include "runner/cli/plan.hpp"
#include "runner/cli/predict.hpp"
#include "runner/cli/query.hpp"
#include "runner/cli/report.hpp"
#include "runner/cli/retry.hpp"
#include "runner/cli/run.hpp"
#include "runner/cli/sensitivity.hpp"
#include "runner/cli/show.hpp"
#include "runner/cli/status.hpp"
#include "runner/cli/usage.hpp"
#include "runner/cli/verify.hpp"
#include "runner/cli/watch.hpp"
#include "runner/exec/git_revision.hpp"
#include "runner/exec/signals.hpp"
#include "runner/finish/finish_study.hpp"
#include "runner/paper/preface.hpp"
#include "runner/study/characters.hpp"

namespace {

/// Verbs in the order in which help lists them: a new verb is one file in runner/cli and one line here.
void setup_verbs(CLI::App& app) {
  mpmstudy::setup_check(app);
  mpmstudy::setup_plan(app);
  const auto simulate = [](const mpm::Scene& scene, mpm::Observer& observer) {
    return mpm::run(scene, observer);
  };
  mpmstudy::setup_run(app, {simulate, mpm::write_vtkhdf, mpmstudy::finish_study});
  mpmstudy::setup_show(app);
  mpmstudy::setup_predict(app);
  mpmstudy::setup_sensitivity(app);
  mpmstudy::setup_status(app);
  mpmstudy::setup_watch(app);
  mpmstudy::setup_explain(app);
  mpmstudy::setup_retry(app);
  mpmstudy::setup_verify(app, {simulate, mpm::write_vtkhdf, {}});
  mpmstudy::setup_merge(app);
  mpmstudy::setup_forget(app);
  mpmstudy::setup_gc(app);
  mpmstudy::setup_query(app);
  mpmstudy::setup_export(app);
  mpmstudy::setup_figures(app);
  mpmstudy::setup_report(app, {"the paper's claims", mpmstudy::claims_preface});
  mpmstudy::setup_bench(app);
}

int run(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::RuntimeError& end) {
    return end.get_exit_code();
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? mpmstudy::exit_ok : mpmstudy::exit_usage;
  } catch (const mpmstudy::StudyError& error) {
    fmt::print(stderr, "{}\n", mpmstudy::printable_lines(error.what()));
    return mpmstudy::exit_usage;
  } catch (const mpmstudy::CatalogError& error) {
    fmt::print(stderr, "{}\n", mpmstudy::printable_lines(error.what()));
    return mpmstudy::exit_usage;
  } catch (const std::exception& error) {
    fmt::print(stderr, "mpmstudy: {}\n", mpmstudy::printable_lines(error.what()));
    return mpmstudy::exit_failed;
  }
  fmt::print(stderr, "{}", app.help());
  return mpmstudy::exit_usage;
}

/// Output that is lost is a failure, also when all went well until then (`mpmstudy query ... > file` on a
/// full disk). Verbs do not check what they write; the state of the streams is checked here once. std::cout
/// writes through stdio, so it goes first.
int check_output(int exit_code) {
  errno = 0;
  const bool streamed = static_cast<bool>(std::cout.flush());
  const bool written = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (streamed && written) return exit_code;
  const int error = errno;
  if (mpmstudy::output_closed()) {  // `mpmstudy run -v | head -3`: the run was not asked to end
    fmt::print(stderr,
               "mpmstudy: the reader of standard output has gone; the run went on without printing\n");
    return exit_code;
  }
  fmt::print(stderr, "mpmstudy: standard output could not be written{}\n",
             error != 0 ? fmt::format(" ({})", std::strerror(error)) : "");
  return exit_code == mpmstudy::exit_ok ? mpmstudy::exit_failed : exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  // Warnings and results that go to one file stand there in the order in which they were printed.
  std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  CLI::App app("Parameter studies of shock problems by the material point method", "mpmstudy");
  app.set_version_flag("--version",
                       fmt::format("mpmstudy {}, commit {}, physics version {}", MPMSTUDY_VERSION,
                                   mpmstudy::git_revision(), mpm::physics_version));
  app.require_subcommand(0, 1);
  setup_verbs(app);
  app.failure_message(mpmstudy::usage_message);
  return check_output(run(app, argc, argv));
}
