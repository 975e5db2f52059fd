#include "importers/mesh/text.h"

#include <algorithm>

namespace voussoir::importers::mesh
{

bool Lines::next(std::string_view& line)
{
    if (rest_.empty()) return false;
    ++number_;
    const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
    line = rest_.substr(0, end);
    const std::size_t mark = rest_.substr(end).starts_with("\r\n") ? 2 : 1;
    rest_.remove_prefix(std::min(end + mark, rest_.size()));
    return true;
}

std::string line_place(const std::string& place, std::string_view text, std::ptrdiff_t offset)
{
    if (offset < 0) return place;
    const std::string_view before = text.substr(0, std::min<std::size_t>(offset, text.size()));
    return place + ":" + std::to_string(1 + std::count(before.begin(), before.end(), '\n'));
}

void FaultList::add(int line, std::string found, std::string expected)
{
    if (!full()) faults_.push_back({place_ + ":" + std::to_string(line), std::move(found), std::move(expected)});
}

void FaultList::throw_if_any() const
{
    if (!faults_.empty()) throw InputError(faults_);
}

}  // namespace voussoir::importers::mesh
