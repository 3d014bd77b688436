#pragma once
#include "runner/bench/exact/scenes.hpp"

/// Scenes that several tests share.
namespace scenes = mpmstudy::scenes;
