#include "app/words/stones_in_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

namespace voussoir::app::words
{
namespace
{

constexpr std::string_view digits = "0123456789";
constexpr std::size_t most_parts = 5;

/// Where "_c07" begins in a name; npos: it has none.
std::size_t place_of_course(const std::string& name)
{
    for (std::size_t at = name.find("_c"); at != std::string::npos; at = name.find("_c", at + 1))
        if (at > 0 && at + 2 < name.size() && digits.find(name[at + 2]) != std::string_view::npos) return at;
    return std::string::npos;
}

/// Without what tells stones of one place across from each other: "arch_1_voussoir_07" of
/// "arch_1_voussoir_07_b02".
std::string without_place_across(const std::string& name)
{
    const std::size_t at = name.rfind("_b");
    const bool is_across = at != std::string::npos && at > 0 && at + 2 < name.size() &&
                           name.find_first_not_of(digits, at + 2) == std::string::npos;
    return is_across ? name.substr(0, at) : name;
}

/// Where the number begins that a name ends with; its size: there is none.
std::size_t place_of_number(const std::string& name)
{
    const std::size_t last = name.find_last_not_of(digits);
    return last == std::string::npos ? name.size() : last + 1;
}

/// The digits by which a stone is counted in its part: of its course, or else those its name ends with.
std::string_view count_in(const std::string& name, std::size_t course)
{
    const std::string_view text = name;
    if (course != std::string::npos) {
        const std::size_t end = std::min(text.find_first_not_of(digits, course + 2), text.size());
        return text.substr(course + 2, end - course - 2);
    }
    return text.substr(place_of_number(name));
}

/// Shorter numbers are smaller, so that "9" comes before "10".
bool is_smaller(const std::string& a, const std::string& b)
{
    const auto value = [](const std::string& text) {
        return text.substr(std::min(text.find_first_not_of('0'), text.size()));
    };
    const std::string one = value(a), other = value(b);
    return one.size() != other.size() ? one.size() < other.size() : one < other;
}

/// What of a part is spoken of.
struct Share {
    int stones = 0, all = 0;
    bool has_courses = false;
    std::string lowest, highest;  // course, or number; empty: none is in the names
};

std::string in_words(const std::string& part, const Share& share, const std::string& quote)
{
    std::string of = quote + part + quote;
    if (share.all == 1) return of;
    if (share.stones == share.all) return fmt::format("all {} stones of {}", share.all, of);
    std::string words = fmt::format("{} of {} stones of {}", share.stones, share.all, of);
    if (share.highest.empty()) return words;
    const auto shown = [&](const std::string& count) {
        return share.has_courses ? count.substr(std::min(count.find_first_not_of('0'), count.size() - 1)) : count;
    };
    const std::string kind = share.has_courses ? "in course" : "numbered";
    if (share.lowest == share.highest) return fmt::format("{} {} {}", words, kind, shown(share.lowest));
    return fmt::format("{} {}{} {} to {}", words, kind, share.has_courses ? "s" : "", shown(share.lowest),
                       shown(share.highest));
}

std::string listed(const std::vector<std::string>& texts)
{
    std::string list;
    for (std::size_t i = 0; i < texts.size(); ++i)
        list.append(i == 0 ? "" : i + 1 == texts.size() ? " and " : ", ").append(texts[i]);
    return list;
}

void add_stone(const std::string& name, Share& share)
{
    ++share.stones;
    const std::size_t course = place_of_course(name);
    const std::string whole = course == std::string::npos ? without_place_across(name) : name;
    const std::string count(count_in(whole, course));
    share.has_courses = course != std::string::npos;
    if (count.empty()) return;
    if (share.lowest.empty() || is_smaller(count, share.lowest)) share.lowest = count;
    if (share.highest.empty() || is_smaller(share.highest, count)) share.highest = count;
}

/// Those with most of the stones first.
std::vector<std::pair<std::string, Share>> shares_of(const std::vector<int>& blocks,
                                                     const std::vector<std::string>& names)
{
    std::map<std::string, Share> shares;
    for (const int block : blocks) {
        const std::string& name = names[static_cast<std::size_t>(block)];
        add_stone(name, shares[part_of(name)]);
    }
    for (const std::string& name : names)
        if (const auto known = shares.find(part_of(name)); known != shares.end()) ++known->second.all;
    std::vector<std::pair<std::string, Share>> sorted(shares.begin(), shares.end());
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const auto& a, const auto& b) { return a.second.stones > b.second.stones; });
    return sorted;
}

}  // namespace

std::string part_of(const std::string& name)
{
    const std::size_t course = place_of_course(name);
    if (course != std::string::npos) return name.substr(0, course);
    std::string whole = without_place_across(name);
    const std::size_t number = place_of_number(whole);
    if (number == 0 || number == whole.size()) return whole;
    const bool is_parted = std::string_view("_.- ").find(whole[number - 1]) != std::string_view::npos;
    const std::size_t end = is_parted ? number - 1 : number;
    return end > 0 ? whole.substr(0, end) : whole;
}

std::string stones_in_words(const std::vector<int>& blocks, const std::vector<std::string>& names,
                            std::size_t most, const std::string& quote)
{
    std::vector<std::string> texts;
    if (blocks.size() <= most) {
        for (const int block : blocks)
            texts.push_back(fmt::format("{0}{1}{0}", quote, names[static_cast<std::size_t>(block)]));
        return listed(texts);
    }
    const std::vector<std::pair<std::string, Share>> shares = shares_of(blocks, names);
    const std::size_t told = shares.size() <= most_parts + 1 ? shares.size() : most_parts;
    // Single stones first: "keystone and 5 of 14 stones of voussoir", not the other way round.
    for (const bool single : {true, false})
        for (std::size_t i = 0; i < told; ++i)
            if ((shares[i].second.all == 1) == single)
                texts.push_back(in_words(shares[i].first, shares[i].second, quote));
    int rest = 0;
    for (std::size_t i = told; i < shares.size(); ++i) rest += shares[i].second.stones;
    if (rest > 0) texts.push_back(fmt::format("{} stones of {} other parts", rest, shares.size() - told));
    return listed(texts);
}

}  // namespace voussoir::app::words
