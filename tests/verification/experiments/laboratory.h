// Measured experiments: where their files lie, tables read from them, and what a study of many cases needs. The
// data are not ours to ship; without them the tests are skipped.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/plots/diagram.h"

namespace voussoir::verification
{

/// The folder of an experiment beside the test data. Its files may be absent.
std::filesystem::path laboratory_folder(const std::string& experiment);

/// A text table with a head of names.
struct LaboratoryTable {
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;

    /// Number in column `name` of a row. @throws InputError when there is none
    double number(std::size_t row, const std::string& name) const;
    /// Word in column `name` of a row. @throws InputError when there is no such column
    const std::string& word(std::size_t row, const std::string& name) const;
};

/// Values parted by commas or blanks, gzipped or not. @throws InputError when the file cannot be read
LaboratoryTable read_laboratory_table(const std::filesystem::path& file);

/// Calls `one` with 0 to count - 1, side by side in as many threads as VOUSSOIR_EXPERIMENT_THREADS says (2).
void for_each_case(int count, const std::function<void(int)>& one);

/// The middle one of values, or the mean of the two in the middle; 0 of none.
double median_of(std::vector<double> values);

/// What lies above a share of the values, 0 to 1.
double quantile_of(std::vector<double> values, double share);

/// One half of some cases to fit on, the other to judge by.
template <class Case>
struct Halves {
    std::vector<Case> fitted, judged;
};

/// Every second case.
template <class Case>
Halves<Case> halves_of(const std::vector<Case>& cases)
{
    Halves<Case> halves;
    for (std::size_t i = 0; i < cases.size(); ++i)
        (i % 2 == 0 ? halves.fitted : halves.judged).push_back(cases[i]);
    return halves;
}

/// Draws a figure into the folder that VOUSSOIR_EXPERIMENT_FIGURES names, if it does.
void draw_if_asked(const app::plots::Figure& figure);

}  // namespace voussoir::verification
