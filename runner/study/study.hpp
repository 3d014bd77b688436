#pragma once
/// A study file, read, checked and expanded. Pure: reads one file, touches nothing else.
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "libmpm/scene/scene.hpp"
#include "runner/study/figure_kinds.hpp"
#include "runner/study/ladder_request.hpp"

namespace mpmstudy {

class Units;

/// A fit that the study asks for (analysis/fit.hpp).
struct FitRequest {
  std::string x;      ///< a swept quantity, e.g. "cavity_radius"
  std::string y;      ///< a result column, e.g. "collapsibility"
  std::string model;  ///< "linear", "quadratic", "power", "exponential"
};

/// What a figure of fields shows of three axes; of two axes it is the whole.
struct FieldView {
  enum class Of { slice, largest, mean };
  Of of = Of::slice;  ///< the particles at a place; the largest value along an axis; the mean by volume
  int axis = 2;       ///< the one that is looked along: 0 is x, 2 is z
  double at = 0;      ///< of a slice: where on that axis [m]
  bool operator==(const FieldView&) const = default;
};

/// A figure that the study asks for ([[figure]]).
struct FigureRequest {
  std::string name;  ///< file stem, e.g. "area-of-radius"
  std::string title;
  FigureKind kind{};
  std::string x;       ///< a quantity, where the kind has one; of xy also a result
  std::string y;       ///< a result column, or a field: "pressure", "plastic_work", ...; of a map a quantity
  std::string colour;  ///< of a map: a result
  bool log_x = false, log_y = false;  ///< by the logarithm
  FieldView view;                     ///< of fields
};

/// A critical value that the study looks for ([search]): the smallest `critical` that has `outcome`.
struct SearchRequest {
  std::string critical;  ///< a quantity that [parameters] leaves out, e.g. "impact_speed"
  std::string outcome;   ///< "ejected", ...
  double lower = 0;      ///< the bracket to start from, SI of `critical`, lower < upper; scenes hold `lower`
  double upper = 0;
  double tolerance = 0;  ///< width of the bracket at which the search ends, > 0, SI of `critical`
  std::string place;     ///< where `between` is said: "studies/a.toml:22:13"
};

/// A surface through a result, to which the study adds runs where they tell most ([surface]).
struct SurfaceRequest {
  std::string of;           ///< a result column, e.g. "collapsibility"
  double tolerance = 0;     ///< > 0: how far a run may be from the surface
  bool is_share = true;     ///< of the range of the result in the runs; else in the SI unit of the result
  std::int64_t budget = 0;  ///< runs at most, those of the design among them
  std::int64_t batch = 0;   ///< runs of a round, however many workers there are
  /// Where more runs may be: one scene per place, in the order of their sequence; scenes of the design may be
  /// among them.
  std::vector<mpm::Scene> candidates;
};

/// What a run of the study should come to ([expect]). Only tests/stability looks at it.
struct Expectation {
  enum class Outcome {
    holds,    ///< ends, with an energy error below the limit
    breaks,   ///< a health limit stops it, and says `reason`
    refused,  ///< it is no valid scene, for `reason`
  };
  Outcome outcome = Outcome::holds;
  double energy_error = 0.01;  ///< largest one allowed [1]
  std::string reason;          ///< words of the message; empty where it holds
  std::string why;             ///< why the case is hard
};

/// Bad input. what() is "file:line:column: key = value: what is wrong; what is allowed". Exit code 2.
class StudyError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The unit in which a study's file writes a quantity: number in it = (SI - offset) / slope.
struct WrittenUnit {
  std::string text;  ///< "um"
  double slope = 1, offset = 0;
};

using WrittenUnits = std::map<std::string, WrittenUnit>;  ///< by name of the quantity

/// A parameter that the study has a name for and no table has (Scene::labels has its value in each job).
struct OwnParameter {
  std::string name;
  std::string unit;   ///< SI
  std::string place;  ///< where it is said: "studies/a.toml:12:16"
};

/// Points of a sweep that are no jobs, because [sweep] says invalid = "skip".
struct SkippedPoints {
  std::string why;    ///< "require = \"a > b\" does not hold", "cavity_radius cannot be run"
  std::string first;  ///< the first such point, or what is wrong with it
  std::uint64_t points = 0;
};

struct Study {
  std::filesystem::path path;
  std::string name;
  std::string title;
  mpm::SceneKind kind{};
  std::vector<std::string> swept;  ///< names of the swept quantities and choices, in file order
  /// Of a sampled mode: the value of each swept quantity [SI] below which a share of its values lies.
  std::map<std::string, std::function<double(double share)>> distributions;
  std::vector<std::vector<std::string>> together;  ///< of swept: those whose values go together
  std::vector<std::string> given;   ///< names of everything the file sets, swept or not; the rest is default
  std::vector<std::string> places;  ///< of given, where each is said: "studies/a.toml:12:16", "--set"
  std::vector<OwnParameter> own;    ///< parameters of the study's own, in file order
  WrittenUnits units;               ///< of what is given with a unit and of what is searched
  std::vector<mpm::Scene> scenes;   ///< one per job, in the order of the sweep, every one without mistakes
  std::vector<SkippedPoints> skipped;  ///< in addition to the scenes
  std::string points_file;             ///< of [sweep], from the folder of the study file; "": none
  std::vector<mpm::Gauge> gauges;      ///< of every scene, by name
  LadderRequest ladder;                ///< under every scene, whose cell is one end of it
  std::string material_place;  ///< where the material is named; its constants stand for what is not given
  std::string ladder_place;    ///< where more than one cell is asked for; "": nowhere
  std::optional<SearchRequest> search;
  std::optional<SurfaceRequest> surface;
  std::vector<FitRequest> fits;
  std::vector<FigureRequest> figures;
  std::optional<Expectation> expectation;
  std::vector<std::string> warnings;  ///< what the reader has seen that is no error, a line each
};

struct ReadOptions {
  std::vector<std::pair<std::string, std::string>> set;  ///< --set key=value, over the file
  double cells = 1;  ///< every cell_size of the file times this: a whole set of studies, coarser or finer
  std::uint64_t most_jobs = 1'000'000;  ///< more is a StudyError that names --yes
};

/// Throws StudyError; collects every mistake of the file into one message, a line each.
Study read_study(const std::filesystem::path&, const ReadOptions& = {});
/// For those who read many: the unit database takes longer to load than a study to read.
Study read_study(const std::filesystem::path&, const ReadOptions&, const Units&);

}  // namespace mpmstudy
