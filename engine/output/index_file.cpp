// SPDX-License-Identifier: MIT
#include "engine/output/index_file.hpp"

#include <xxhash.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <nlohmann/json.hpp>
#include <vector>

#include "engine/formats/input_file.hpp"
#include "engine/formats/number_text.hpp"
#include "engine/formats/remedies.hpp"
#include "engine/formats/source_file.hpp"
#include "engine/formats/text.hpp"
#include "engine/formats/text_stream.hpp"
#include "engine/output/atomic_file.hpp"

namespace geodrome {
namespace {

using Json = nlohmann::json;

static_assert(std::endian::native == std::endian::little, "index files are written in the machine's own byte order");

constexpr std::array<char, 8> index_magic = {'G', 'E', 'O', 'I', 'N', 'D', 'E', 'X'};
constexpr std::uint32_t format_version = 1;

struct Preamble {
  std::array<char, 8> magic;
  std::uint32_t version, reserved;
  std::uint64_t identity_bytes, identity_checksum, payload_bytes, payload_checksum;
  std::uint64_t reserved_too;
  std::uint64_t checksum;  ///< of all that stands before it
};
static_assert(sizeof(Preamble) == 64);

std::uint64_t checksum_of(const Preamble& preamble) { return XXH3_64bits(&preamble, offsetof(Preamble, checksum)); }

std::string text_of(const IndexIdentity& identity) {
  return Json{{"solver", identity.solver},     {"options", identity.options}, {"seed", identity.seed},
              {"vertices", identity.vertices}, {"faces", identity.faces},     {"mesh", identity.mesh}}
      .dump();
}

/// Throws nlohmann's exceptions for a text that `text_of` did not write.
IndexIdentity identity_from(const std::string& text) {
  const Json json = Json::parse(text);
  const auto whole = [&](const char* name) { return json.at(name).get_ref<const Json::number_unsigned_t&>(); };
  IndexIdentity identity;
  json.at("solver").get_to(identity.solver), json.at("options").get_to(identity.options);
  json.at("mesh").get_to(identity.mesh);
  identity.seed = whole("seed"), identity.vertices = whole("vertices"), identity.faces = whole("faces");
  return identity;
}

std::string mesh_text(const IndexIdentity& identity) {
  return std::to_string(identity.vertices) + " vertices, " + std::to_string(identity.faces) + " faces, hash " +
         input::printable(identity.mesh);
}

std::string option_differences(const IndexIdentity& was, const IndexIdentity& is) {
  std::string text;
  constexpr int most = 8;
  int told = 0;
  const auto add = [&](const std::string& name, const std::string& old, const std::string& now) {
    if (old == now || ++told > most) return;
    append_word(text, input::printable(name) + " was " + input::printable(old) + " and is " + input::printable(now));
  };
  const auto value = [](const IndexIdentity& identity, const std::string& name) {
    const auto found = identity.options.find(name);
    return found == identity.options.end() ? "absent" : found->second;
  };
  std::map<std::string, std::string> names = was.options;
  names.insert(is.options.begin(), is.options.end());
  for (const auto& [name, ignored] : names) add(name, value(was, name), value(is, name));
  return told > most ? text + ", ..." : text;
}

/// The bytes of a file, of which there may be none.
std::string read_whole(const std::filesystem::path& path) {
  const input::InputFile file(path);
  std::string bytes(file.size(), '\0');
  file.read_at(0, bytes.data(), bytes.size());
  file.demand_unchanged();
  return bytes;
}

/// Takes an index apart, and refuses what is wrong with it.
class Reader {
 public:
  explicit Reader(const std::filesystem::path& path) : path_(path) {
    std::error_code error;
    if (std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error))
      refuse(InputFault::io, "is no regular file", "name another one");
    bytes_ = read_whole(path);
    read_preamble();
    read_identity();
  }

  void demand_same(const IndexIdentity& now) const {
    const std::string mine = "remove it, or name another file";
    if (identity_.solver != now.solver)
      refuse(InputFault::unsupported,
             "is the index of another solver: " + input::printable(identity_.solver) + ", not " + now.solver, mine);
    if (const std::string what = option_differences(identity_, now); !what.empty())
      refuse(InputFault::unsupported, "is the index of " + now.solver + " with other options: " + what, mine);
    if (mesh_text(identity_) != mesh_text(now))
      refuse(InputFault::unsupported,
             "is the index of another mesh: " + mesh_text(identity_) + "; this one has " + mesh_text(now), mine);
    if (identity_.seed != now.seed)
      refuse(InputFault::unsupported,
             "was built with another seed: " + std::to_string(identity_.seed) + ", not " + std::to_string(now.seed),
             mine);
  }

  TextInput checked_content() && {
    const std::string_view payload = std::string_view(bytes_).substr(payload_begin());
    if (XXH3_64bits(payload.data(), payload.size()) != preamble_.payload_checksum) refuse_damaged("its content");
    return TextInput(std::move(bytes_), payload_begin());
  }

 private:
  [[noreturn]] void refuse(InputFault fault, const std::string& what, const Remedy& remedy) const {
    throw InputError(fault, path_.string() + ": " + what, remedy);
  }
  [[noreturn]] void refuse_damaged(const std::string& part) const {
    refuse(InputFault::syntax, "is damaged: the checksum of " + part + " is another", rebuild_);
  }

  std::size_t payload_begin() const { return sizeof(Preamble) + preamble_.identity_bytes; }

  void read_preamble() {
    const std::uint64_t size = bytes_.size();
    std::array<char, sizeof(Preamble)> bytes{};
    std::ranges::copy(std::string_view(bytes_).substr(0, bytes.size()), bytes.begin());
    preamble_ = std::bit_cast<Preamble>(bytes);
    const std::size_t begun = std::min<std::uint64_t>(size, index_magic.size());
    if (std::memcmp(bytes.data(), index_magic.data(), begun) != 0)
      refuse(InputFault::syntax, "is no index file", remedies::other_index());
    if (size < sizeof(Preamble)) refuse(InputFault::truncated, "ends within its first bytes", rebuild_);
    if (preamble_.version != format_version)
      refuse(InputFault::unsupported,
             "has format version " + std::to_string(preamble_.version) + ", this program reads " +
                 std::to_string(format_version),
             rebuild_);
    if (preamble_.checksum != checksum_of(preamble_)) refuse_damaged("its first bytes");
    // Lengths that no file has would wrap around in the sum.
    constexpr std::uint64_t longest = std::uint64_t{1} << 62;
    if (std::max(preamble_.identity_bytes, preamble_.payload_bytes) > longest) refuse_damaged("its first bytes");
    const std::uint64_t due = sizeof(Preamble) + preamble_.identity_bytes + preamble_.payload_bytes;
    if (size == due) return;
    const std::string sizes = std::to_string(size) + " bytes instead of " + std::to_string(due);
    refuse(size < due ? InputFault::truncated : InputFault::syntax, "has " + sizes, rebuild_);
  }

  void read_identity() {
    const std::string text = bytes_.substr(sizeof(Preamble), preamble_.identity_bytes);
    if (XXH3_64bits(text.data(), text.size()) != preamble_.identity_checksum) refuse_damaged("what it belongs to");
    try {
      identity_ = identity_from(text);
    } catch (const Json::exception&) {
      refuse_damaged("what it belongs to");
    }
  }

  static constexpr const char* rebuild_ = "remove it: it is built anew then";
  std::filesystem::path path_;
  std::string bytes_;
  Preamble preamble_{};
  IndexIdentity identity_;
};

}  // namespace

IndexIdentity identity_of(const SurfaceMesh& mesh, const PluginInfo& plugin, const OptionValues& options,
                          std::uint64_t seed) {
  const auto hash = [](const auto& values) {
    return input::content_hash({reinterpret_cast<const char*>(values.data()), values.size_bytes()});
  };
  IndexIdentity identity{plugin.full_name(), {}, seed, mesh.vertex_count(), mesh.face_count(), {}};
  for (const OptionInfo& option : plugin.options) {
    const bool is_number = option.type == OptionType::integer || option.type == OptionType::number;
    identity.options[option.name] = is_number ? number_text(options.number(option.name)) : options.text(option.name);
  }
  identity.mesh = input::content_hash(hash(mesh.positions()) + hash(mesh.triangles()) + hash(mesh.face_weights()));
  return identity;
}

std::uint64_t write_index(const std::filesystem::path& file, const IndexIdentity& identity,
                          const std::function<void(std::ostream&)>& save) {
  const std::string text = text_of(identity);
  TextOutput stream(std::ios::binary);
  stream << std::string(sizeof(Preamble), '\0') << text;
  save(stream);
  std::string bytes = std::move(stream).str();
  const std::string_view payload = std::string_view(bytes).substr(sizeof(Preamble) + text.size());
  Preamble preamble{index_magic,
                    format_version,
                    0,
                    text.size(),
                    XXH3_64bits(text.data(), text.size()),
                    payload.size(),
                    XXH3_64bits(payload.data(), payload.size()),
                    0,
                    0};
  preamble.checksum = checksum_of(preamble);
  std::memcpy(bytes.data(), &preamble, sizeof preamble);
  write_atomically(file, bytes);
  return bytes.size();
}

TextInput open_index(const std::filesystem::path& file, const IndexIdentity& identity) {
  Reader reader(file);
  reader.demand_same(identity);
  return std::move(reader).checked_content();
}

}  // namespace geodrome
