// SPDX-License-Identifier: MIT
// Unfinished matrices that a run goes on with. The first byte: 1, 2, 4 put right the checksums of trailer, fingerprint
// and rows, which no mutation hits; 8 cuts the rest in two, the second part being the saved footer.
#include <xxhash.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>

#include "engine/formats/npy_matrix.hpp"
#include "geodrome/engine/matrix_file.hpp"
#include "tests/fuzzing/target.hpp"
#include "tests/support/temporary_folder.hpp"

namespace geodrome::fuzzing {
namespace {

constexpr std::uint64_t rows = 3, columns = 4;

struct Files {
  geodrome::testing::TemporaryFolder folder;
  std::filesystem::path out = folder / "d.npy", partial = folder / "d.npy.partial",
                        footer = folder / "d.npy.partial-footer";

  void clear() const {
    for (const auto& file : {out, partial, footer}) unlink(file.c_str());
  }
};

const Files& files() {
  static const Files all;
  return all;
}

MatrixFile::Spec spec() {
  MatrixFile::Spec spec;
  spec.out = files().out;
  spec.rows = rows, spec.columns = columns;
  spec.fingerprint = R"({"input":"abc","seed":1,"solver":{"name":"exact","delta":0.5}})";
  return spec;
}

std::vector<double> row_values(std::uint64_t row) { return {0.5 * static_cast<double>(row), 1, INFINITY, 2}; }

// The layout as partial_footer.hpp and npy.hpp state it.
constexpr std::size_t header_bytes = 128, row_bytes = 8 * columns, trailer_bytes = 64,
                      footer_offset = header_bytes + rows * row_bytes;

template <class Number>
Number number_at(const std::string& bytes, std::size_t at) {
  Number number;
  std::memcpy(&number, bytes.data() + at, sizeof number);
  return number;
}

void put(std::string& bytes, std::size_t at, std::uint64_t number) {
  std::memcpy(bytes.data() + at, &number, sizeof number);
}

void put_right_rows(std::string& bytes) {
  if (bytes.size() < footer_offset + 8 * rows) return;
  for (std::size_t row = 0; row < rows; ++row)
    put(bytes, footer_offset + 8 * row,
        XXH3_64bits_withSeed(bytes.data() + header_bytes + row * row_bytes, row_bytes, row));
}

void put_right_fingerprint(std::string& bytes) {
  const std::size_t trailer = bytes.size() - trailer_bytes, length = number_at<std::uint64_t>(bytes, trailer + 32);
  const std::size_t begin = footer_offset + 8 * rows;
  if (bytes.size() < trailer_bytes + begin || length > trailer - begin) return;
  put(bytes, trailer + 40, XXH3_64bits(bytes.data() + begin, length));
}

void put_right(std::string& bytes, const Choices& choices) {
  if (choices.bit(2)) put_right_rows(bytes);
  if (bytes.size() < trailer_bytes) return;
  if (choices.bit(1)) put_right_fingerprint(bytes);
  const std::size_t trailer = bytes.size() - trailer_bytes;
  if (choices.bit(0)) put(bytes, trailer + 48, XXH3_64bits(bytes.data() + trailer, 48));
}

void write(const std::filesystem::path& file, std::string_view bytes) {
  std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

bool same(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

/// Goes on with the matrix; what was there stays, what was not is written.
void finish(MatrixFile& matrix) {
  std::vector<std::vector<double>> values;
  std::uint64_t done = 0;
  for (std::uint64_t row = 0; row < rows; ++row) {
    done += matrix.has(row);
    values.push_back(matrix.has(row) ? matrix.read(row) : row_values(row));
  }
  demand(done == matrix.rows_done(), "rows that are there are counted");
  for (std::uint64_t row = 0; row < rows; ++row)
    if (!matrix.has(row)) matrix.write(row, values[row]);
  matrix.finish();
  NpyMatrix finished(files().out);
  demand(finished.rows() == rows && finished.columns() == columns, "a matrix that was gone on with has its shape");
  for (std::uint64_t row = 0; row < rows; ++row)
    demand(same(finished.read(row), values[row]), "a matrix that was gone on with has its rows");
  demand(!std::filesystem::exists(files().partial) && !std::filesystem::exists(files().footer), "nothing else is left");
}

}  // namespace

void check_partial(std::string_view input) {
  const Choices choices(input);
  std::string bytes(rest_of(input));
  std::string footer;
  if (choices.bit(3))
    footer = bytes.substr(std::min(bytes.size(), footer_offset)), bytes.resize(bytes.size() - footer.size());
  put_right(choices.bit(3) ? footer : bytes, choices);
  files().clear();
  write(files().partial, bytes);
  if (choices.bit(3)) write(files().footer, footer);
  auto matrix = read_or_refusal(files().out.string(), bytes, [&] { return MatrixFile::open(spec(), true); });
  if (matrix) return finish(*matrix);
  demand(bytes_of(files().partial).starts_with(bytes), "a partial that is refused stays as it is");
}

std::vector<std::string> partial_seeds() {
  std::vector<std::string> seeds;
  for (std::uint64_t written = 0; written <= rows; ++written) {
    files().clear();
    {
      MatrixFile matrix = MatrixFile::open(spec(), false);
      for (std::uint64_t row = 0; row < written; ++row) matrix.write(row, row_values(row));
    }
    seeds.push_back(std::string(1, static_cast<char>(written)) + bytes_of(files().partial));
    seeds.push_back(std::string(1, '\x0F') + bytes_of(files().partial));
  }
  files().clear();
  seeds.push_back(std::string(1, '\0') + std::string(512, '\0'));
  return seeds;
}

}  // namespace geodrome::fuzzing
