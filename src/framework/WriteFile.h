#pragma once
#include <string>
#include <string_view>

namespace plumbline {

/// Writes the whole file under another name, syncs it to the disk and renames it: a reader never sees
/// half of it, nor does anybody after a loss of power. A device or pipe (/dev/stdout) is written as it is.
/// Throws std::runtime_error "cannot write PATH: REASON".
void writeFile(const std::string& path, const std::string& content);

/// Writes all of a text to an open file. False, with errno: it takes no more.
bool writeAll(int fd, std::string_view text);

/// Makes a file, or the names in a folder, outlast a loss of power. False, with errno: the disk does not take
/// it.
bool syncToDisk(const std::string& path);

}  // namespace plumbline
