#pragma once
/// libmpm: a material point simulator for shocked solids in plane strain, in axial symmetry and in three
/// dimensions. Include this.
///
///   Scene        what is simulated, as plain data; example/collapse.cpp
///   Simulation   runs it, whole or step by step; example/gauges.cpp, with a body and a measurement of one's
///   own Observer     watches a run          RunResult    what it leaves behind Body, fill   geometry of
///   one's own  Measurement  an observable of one's own    Stepper  a step of one's own
#include <Eigen/LU>  // inverse() and determinant() of matrices, for callers that use them

#include "libmpm/body/fill.hpp"
#include "libmpm/core/errors.hpp"
#include "libmpm/material/material.hpp"
#include "libmpm/measure/measurement.hpp"
#include "libmpm/observer.hpp"
#include "libmpm/result.hpp"
#include "libmpm/scene/parameters.hpp"
#include "libmpm/scene/scene.hpp"
#include "libmpm/simulation.hpp"
#include "libmpm/step/stepper.hpp"
