#pragma once
#include "gap/effects/Effect.h"

namespace plumbline::gap {

/// Lost cycles. Which ones is a matter of the record, not of the plant: see diagnosis/LostCycles.h.
inline const Effect commandDropout{
    .id = "command_dropout",
    .unit = "1",
    .sites = {Site::everywhere},
    .lower = 0,
    .upper = 0.5,
    .starts = {0.05},
    .decoded = true,
    .sentence = "Some commands are lost on the way; the last one holds.",
    .exposedBy = "fast moves",
    .apply =
        [](Plant& plant, const Place& place, double value, int) {
          plant.dropout = value;
          (void)place;
        },
};

}  // namespace plumbline::gap
