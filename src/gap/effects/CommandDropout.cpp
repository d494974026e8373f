#include "gap/effects/Effect.h"

namespace plumbline::gap {

/// Lost cycles. Which ones is a matter of the record, not of the plant: see diagnosis/LostCycles.h.
const Effect commandDropout{
    .id = "command_dropout",
    .order = 20,
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
    .drawing = {.where = DrawRange::Where::all, .low = 0.03, .high = 0.15},
};
MAKE_EFFECT(commandDropout);

}  // namespace plumbline::gap
