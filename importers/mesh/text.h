// Text as the readers of this folder take it apart: lines, points, places, faults.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libdda/errors.h"
#include "libdda/text/numbers.h"
#include "libdda/text/utf.h"
#include "libdda/text/words.h"

namespace voussoir::importers::mesh
{

/// Three finite numbers from the words `first`, `first`+1, `first`+2 into `x`; false where they are not there.
template <class Vector>
bool parse_point(const std::vector<std::string_view>& word, std::size_t first, Vector& x)
{
    for (std::size_t i = 0; i < 3; ++i) {
        const std::optional<double> value =
            first + i < word.size() ? text::parse_finite(word[first + i]) : std::optional<double>();
        if (!value) return false;
        x[static_cast<int>(i)] = *value;
    }
    return true;
}

/// Line by line; "\n", "\r\n" and "\r" end a line.
class Lines
{
 public:
    explicit Lines(std::string_view text) : rest_(text) {}
    bool next(std::string_view& line);
    int number() const { return number_; }  // of the last line, counted from 1

 private:
    std::string_view rest_;
    int number_ = 0;
};

/// "arch.dae:17", the line that holds the byte `offset` of the text.
std::string line_place(const std::string& place, std::string_view text, std::ptrdiff_t offset);

/// Faults of one file, at most twenty of them.
class FaultList
{
 public:
    explicit FaultList(std::string place) : place_(std::move(place)) {}
    void add(int line, std::string found, std::string expected);
    bool full() const { return faults_.size() >= 20; }
    void throw_if_any() const;

 private:
    std::string place_;
    std::vector<Fault> faults_;
};

}  // namespace voussoir::importers::mesh
