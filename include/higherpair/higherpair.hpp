#pragma once

/// The library's front door: everything that a program needs to analyse a mechanism. See docs/library.md.

#include "higherpair/cam/motion_law.hpp"         // IWYU pragma: export
#include "higherpair/drawing/picture.hpp"        // IWYU pragma: export
#include "higherpair/front/check.hpp"            // IWYU pragma: export
#include "higherpair/front/contacts.hpp"         // IWYU pragma: export
#include "higherpair/front/design.hpp"           // IWYU pragma: export
#include "higherpair/front/export.hpp"           // IWYU pragma: export
#include "higherpair/front/fit.hpp"              // IWYU pragma: export
#include "higherpair/front/measure.hpp"          // IWYU pragma: export
#include "higherpair/front/mobility.hpp"         // IWYU pragma: export
#include "higherpair/front/model.hpp"            // IWYU pragma: export
#include "higherpair/front/motion.hpp"           // IWYU pragma: export
#include "higherpair/front/pictures.hpp"         // IWYU pragma: export
#include "higherpair/front/sensitivity.hpp"      // IWYU pragma: export
#include "higherpair/front/sweep.hpp"            // IWYU pragma: export
#include "higherpair/io/diagnostic.hpp"          // IWYU pragma: export
#include "higherpair/mechanism/description.hpp"  // IWYU pragma: export
