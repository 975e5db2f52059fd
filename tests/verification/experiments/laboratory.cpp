#include "tests/verification/experiments/laboratory.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <thread>

#include "app/plots/plots.h"
#include "libdda/errors.h"
#include "records/source_file.h"

namespace voussoir::verification
{
namespace
{

std::vector<std::string> words_of(std::string_view line)
{
    std::vector<std::string> words;
    for (std::size_t at = 0; at < line.size();) {
        const std::size_t end = std::min(line.find_first_of(", \t", at), line.size());
        if (end > at) words.emplace_back(line.substr(at, end - at));
        at = end + 1;
    }
    return words;
}

int threads_of_cases()
{
    const char* given = std::getenv("VOUSSOIR_EXPERIMENT_THREADS");
    return given != nullptr ? std::max(1, std::atoi(given)) : 2;
}

}  // namespace

std::filesystem::path laboratory_folder(const std::string& experiment)
{
    const char* folder = std::getenv("VOUSSOIR_DATA");
    const std::filesystem::path data = folder != nullptr ? folder : VOUSSOIR_DEFAULT_DATA;
    return data / ".." / "experiments" / experiment;
}

const std::string& LaboratoryTable::word(std::size_t row, const std::string& name) const
{
    const auto column = std::find(columns.begin(), columns.end(), name);
    if (column == columns.end()) throw InputError({{name, "no column of this name", "the published files"}});
    return rows.at(row).at(static_cast<std::size_t>(column - columns.begin()));
}

double LaboratoryTable::number(std::size_t row, const std::string& name) const
{
    const std::string& text = word(row, name);
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (end == text.c_str() || *end != 0) throw InputError({{name, text, "a number"}});
    return value;
}

LaboratoryTable read_laboratory_table(const std::filesystem::path& file)
{
    records::SourceFile source;
    records::load_source_file(file, source);
    LaboratoryTable table;
    for (const std::string_view line : source.lines) {
        std::vector<std::string> words = words_of(line);
        if (words.empty()) continue;
        if (table.columns.empty())
            table.columns = std::move(words);
        else if (words.size() != table.columns.size())
            throw InputError({{source.name, std::string(line), "as many values as the head has names"}});
        else
            table.rows.push_back(std::move(words));
    }
    return table;
}

void for_each_case(int count, const std::function<void(int)>& one)
{
    std::atomic<int> next = 0;
    const auto work = [&] {
        for (int i = next++; i < count; i = next++) one(i);
    };
    std::vector<std::thread> others;
    for (int t = 1; t < threads_of_cases(); ++t) others.emplace_back(work);
    work();
    for (std::thread& other : others) other.join();
}

double quantile_of(std::vector<double> values, double share)
{
    if (values.empty()) return 0;
    std::sort(values.begin(), values.end());
    const double place = share * static_cast<double>(values.size() - 1);
    const std::size_t below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (place - std::floor(place)) * (values[above] - values[below]);
}

double median_of(std::vector<double> values)
{
    return quantile_of(std::move(values), 0.5);
}

void draw_if_asked(const app::plots::Figure& figure)
{
    const char* folder = std::getenv("VOUSSOIR_EXPERIMENT_FIGURES");
    if (folder != nullptr && app::plots::can_draw_figures()) app::plots::draw_figures({figure}, folder);
}

}  // namespace voussoir::verification
