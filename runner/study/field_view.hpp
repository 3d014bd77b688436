#pragma once
/// How a figure of fields shows what has three axes: as a slice, or what is seen along an axis.
#include "runner/study/figure_kinds.hpp"
#include "runner/study/mistakes.hpp"
#include "runner/study/requests.hpp"
#include "runner/study/study.hpp"
#include "runner/study/units.hpp"

namespace mpmstudy {

/// `slice = { z = "1 um" }`, or `projection = { largest = "z" }`, `{ mean = "z" }`; the slice at z = 0 where
/// the figure has neither.
FieldView read_field_view(const Table& figure, const FigureKindRow&, const RequestContext&, const Units&,
                          Mistakes&);

}  // namespace mpmstudy
