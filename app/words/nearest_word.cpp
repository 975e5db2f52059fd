#include "app/words/nearest_word.h"

#include <algorithm>

#include "libdda/text/words.h"

namespace voussoir::app::words
{

int edit_distance(std::string_view a, std::string_view b)
{
    std::vector<int> before_last(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = static_cast<int>(j);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before_last = last;
        last = row;
        row[0] = static_cast<int>(i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
        }
    }
    return row[b.size()];
}

std::string nearest_word(std::string_view word, const std::vector<std::string>& known)
{
    constexpr std::size_t longest = 64;  // nobody mistypes longer words, and the distance is quadratic
    constexpr std::size_t most = 5000;   // nor is a list of more words searched for every slip
    if (word.size() > longest || known.size() > most) return {};
    std::string nearest;
    // Nothing is near a word of one or two letters but the other letter case.
    int nearest_distance = word.size() <= 2 ? 1 : static_cast<int>((word.size() + 1) / 3) + 1;
    for (const std::string& candidate : known) {
        if (candidate.size() > longest) continue;
        const int distance = edit_distance(text::lower_case(word), text::lower_case(candidate));
        if (distance < nearest_distance) {
            nearest_distance = distance;
            nearest = candidate;
        }
    }
    return nearest;
}

std::string suggestion(std::string_view word, const std::vector<std::string>& known)
{
    const std::string nearest = nearest_word(word, known);
    if (!nearest.empty()) return "did you mean " + nearest + "?";
    constexpr std::size_t most = 16;
    std::vector<std::string> different;  // a key may be asked for in two places
    for (const std::string& each : known)
        if (std::find(different.begin(), different.end(), each) == different.end()) different.push_back(each);
    std::string list;
    for (std::size_t i = 0; i < std::min(different.size(), most); ++i) list += (i > 0 ? ", " : "") + different[i];
    if (different.size() > most) list += ", ...";
    return list.empty() ? "there is none to choose from" : "known here: " + list;
}

}  // namespace voussoir::app::words
