#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "runner/finish/preface.hpp"
#include "runner/study/study.hpp"

namespace mpmstudy {

/// A study in the form that is shown, and the options that make it so: " --cells 1.4"; "": as its file is.
struct ReportedStudy {
  Study study;
  std::string options;
};

/// One HTML page of everything that a catalog has on these studies: the preface, if there is any, then for
/// each study the reading it rests on (the comment at the head of its file), figures (drawn anew), animations
/// of its snapshots, its jobs with their errors, fits, brackets and costs. Tables and figures are of the jobs
/// of this form of the study: what else the catalog has under its name is not shown. Every number is taken
/// from the catalog as it is asked for. Throws what draw_figures throws, and CatalogError.
std::string report_page(const std::vector<ReportedStudy>&, const std::filesystem::path& results,
                        const Preface& = {});

}  // namespace mpmstudy
