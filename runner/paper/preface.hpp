#pragma once
/// The paper's part of a report: its claims, judged, as a section of the page, a table and JSON.
#include "runner/finish/preface.hpp"

namespace mpmstudy {

/// Judges all claims and puts them into the catalog; shows those of the studies that are reported, and says
/// on stderr of which studies there are none. A study that bears the name of one of the paper's and has other
/// physics is no evidence: its claims say in what it differs. Throws CatalogError if there is no catalog,
/// std::runtime_error for a snapshot that cannot be read.
Preface claims_preface(const PrefaceRequest&);

}  // namespace mpmstudy
