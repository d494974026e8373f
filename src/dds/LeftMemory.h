#pragma once
#include <chrono>
#include <cstddef>
#include <string>

namespace plumbline::dds {

/// Removes the shared memory of this user's processes that were killed, 8 MB each, which would otherwise stay
/// until the machine is restarted; returns the number of pieces. Fast DDS (RobustExclusiveLock) holds a lock
/// on the file NAME_el next to each piece as long as its process lives. Pieces younger than `age` stay: they
/// may not be locked yet.
std::size_t removeLeftMemory(const std::string& folder = "/dev/shm",
                             std::chrono::seconds age = std::chrono::seconds(60)) noexcept;

}  // namespace plumbline::dds
