// SPDX-License-Identifier: MIT
#include "engine/formats/gzip.hpp"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <new>
#include <span>
#include <string>
#include <utility>

namespace geodrome::input {
namespace {

constexpr const char* remedy = "make the file again, or unpack it with gunzip to see what it says";

/// zlib's stream of one file of gzip, member after member.
class Inflater {
 public:
  explicit Inflater(std::string_view packed) : packed_(packed) {
    constexpr int gzip_only = 16 + MAX_WBITS;
    if (inflateInit2(&stream_, gzip_only) != Z_OK) throw std::bad_alloc();
  }
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  /// Fills a part of the block and says how far it came.
  int next(std::span<char> block, std::size_t& written) {
    constexpr std::size_t most = std::numeric_limits<uInt>::max();
    // zlib counts in 32 bits and takes its input without const.
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed_.data()));
    stream_.avail_in = static_cast<uInt>(std::min(packed_.size(), most));
    stream_.next_out = reinterpret_cast<Bytef*>(block.data());
    stream_.avail_out = static_cast<uInt>(block.size());
    const std::size_t before = stream_.avail_in;
    const int state = inflate(&stream_, Z_NO_FLUSH);
    packed_.remove_prefix(before - stream_.avail_in);
    written = block.size() - stream_.avail_out;
    return state;
  }
  std::string_view rest() const { return packed_; }
  void start_member() { inflateReset(&stream_); }

 private:
  z_stream stream_{};
  std::string_view packed_;
};

/// True if another member follows; rejects anything else but zeros, with which archives are filled up.
bool has_another_member(const SourceFile& file, std::string_view rest) {
  if (is_gzip(rest)) return true;
  if (rest.find_first_not_of('\0') != rest.npos)
    reject(file, InputFault::syntax,
           std::to_string(rest.size()) + " bytes that are no gzip follow the compressed content", remedy);
  return false;
}

}  // namespace

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1F\x8B"); }

void unpack_gzip(SourceFile& file, std::size_t limit) {
  Inflater inflater(file.bytes);
  std::string unpacked;
  char block[1 << 16];
  for (bool more = true; more;) {
    std::size_t written = 0;
    const int state = inflater.next(block, written);
    if (unpacked.size() + written > limit)
      reject(file, InputFault::unsupported,
             std::to_string(file.bytes.size()) + " compressed bytes hold more than " + std::to_string(limit),
             "unpack it with gunzip if that is as it should be");
    unpacked.append(block, written);
    if (state == Z_MEM_ERROR) throw std::bad_alloc();
    if (state == Z_BUF_ERROR || (state == Z_OK && written == 0 && inflater.rest().empty()))
      reject(file, InputFault::truncated,
             "the compressed content ends too early, after " + std::to_string(unpacked.size()) + " bytes unpacked",
             remedy);
    if (state != Z_OK && state != Z_STREAM_END)
      reject(file, InputFault::syntax,
             "the compressed content is damaged, after " + std::to_string(unpacked.size()) + " bytes unpacked", remedy);
    if (state != Z_STREAM_END) continue;
    more = has_another_member(file, inflater.rest());
    if (more) inflater.start_member();
  }
  if (unpacked.empty()) reject(file, InputFault::empty, "the compressed file holds 0 bytes");
  file.bytes = std::move(unpacked);
  file.unpacked = true;
}

}  // namespace geodrome::input
