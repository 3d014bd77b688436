#pragma once
#include "libmpm/verification/problems/scenes.hpp"

/// Scenes that several tests share.
namespace scenes = mpm::verification::scenes;
