// SPDX-License-Identifier: MIT
#pragma once

#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

namespace geodrome {

/// A few strings that one process tells another.
using Message = std::vector<std::string>;

/// Writes a message to a pipe: its length in bytes, then each string after its length. False if nobody reads.
inline bool send(int descriptor, const Message& message) {
  std::string bytes(sizeof(std::uint64_t), '\0');
  for (const std::string& text : message) {
    const std::uint64_t length = text.size();
    bytes.append(reinterpret_cast<const char*>(&length), sizeof length).append(text);
  }
  const std::uint64_t size = bytes.size() - sizeof(std::uint64_t);
  std::memcpy(bytes.data(), &size, sizeof size);
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count = write(descriptor, bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    done += static_cast<std::size_t>(count);
  }
  return true;
}

/// Puts the messages of a pipe together from what can be read.
class MessageReader {
 public:
  /// Reads once; false at the end of the pipe.
  bool read_from(int descriptor) {
    char buffer[1 << 16];
    const ssize_t count = read(descriptor, buffer, sizeof buffer);
    if (count < 0) return errno == EINTR;
    bytes_.append(buffer, static_cast<std::size_t>(count));
    return count > 0;
  }

  /// The next message that is complete.
  std::optional<Message> next() {
    if (bytes_.size() < sizeof(std::uint64_t) || bytes_.size() - sizeof(std::uint64_t) < number_at(0)) return {};
    const std::size_t end = sizeof(std::uint64_t) + number_at(0);
    Message message;
    for (std::size_t at = sizeof(std::uint64_t); at < end;) {
      const std::uint64_t length = number_at(at);
      message.push_back(bytes_.substr(at + sizeof length, length));
      at += sizeof length + length;
    }
    bytes_.erase(0, end);
    return message;
  }

 private:
  std::uint64_t number_at(std::size_t place) const {
    std::uint64_t number = 0;
    std::memcpy(&number, bytes_.data() + place, sizeof number);
    return number;
  }

  std::string bytes_;
};

}  // namespace geodrome
