#pragma once
/// libmpm: a material point simulator for shocked solids in plane strain. Include this.
#include "libmpm/core/errors.hpp"
#include "libmpm/material/material.hpp"
#include "libmpm/scene/parameters.hpp"
#include "libmpm/scene/scene.hpp"
#include "libmpm/simulation.hpp"
