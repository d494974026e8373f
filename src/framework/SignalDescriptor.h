#pragma once

namespace plumbline {

/// The descriptor of the StopSignal that catches signals now, readable from the first one on; -1: none does.
/// For waits deep within long work, as StopSignal::throwIfCaught() is for its loops.
int signalDescriptor();

}  // namespace plumbline
