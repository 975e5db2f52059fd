#include "app/problems/problem_file.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "app/results/counts.h"
#include "app/results/hdf5_file.h"
#include "app/results/packed.h"
#include "app/results/state_checks.h"
#include "app/results/state_fields.h"
#include "libdda/errors.h"

namespace voussoir::app::problems
{

namespace
{

using results::Hdf5File;
using Whole = std::int64_t;

// What the file is, and the layout of a state in it: its digit rises when that changes.
constexpr const char* kind = "step problems of voussoir 1, state 6";

std::string joined(const std::vector<std::string>& texts, const char* between)
{
    std::string whole;
    for (const std::string& text : texts) whole += (whole.empty() ? "" : between) + text;
    return whole;
}

std::vector<std::string> divided(const std::string& whole, const std::string& between)
{
    std::vector<std::string> texts;
    for (std::size_t start = 0; start < whole.size();) {
        const std::size_t end = std::min(whole.find(between, start), whole.size());
        texts.push_back(whole.substr(start, end - start));
        start = end + between.size();
    }
    return texts;
}

/// Bytes as whole numbers, the last filled up with zeros: HDF5 has no texts with zeros in them.
std::vector<Whole> numbers_of(const std::string& bytes)
{
    std::vector<Whole> numbers((bytes.size() + sizeof(Whole) - 1) / sizeof(Whole), 0);
    if (!bytes.empty()) std::memcpy(numbers.data(), bytes.data(), bytes.size());
    return numbers;
}

std::string bytes_of(const std::vector<Whole>& numbers)
{
    return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Whole)};
}

Whole checksum(const std::string& bytes)
{
    return static_cast<Whole>(results::fnv1a(bytes));
}

std::string case_at(std::size_t index)
{
    return "/cases/" + std::to_string(index);
}

template <typename T, typename Member>
std::vector<T> column(const Corpus& corpus, const Member& member)
{
    std::vector<T> values;
    for (const StoredStep& problem : corpus.problems) values.push_back(member(problem));
    return values;
}

/// The states one after another. @param ends where each of them ends in `bytes`
void write_states(const Corpus& corpus, Hdf5File& file)
{
    results::Packer packer;
    std::vector<Whole> ends;
    for (const StoredStep& problem : corpus.problems) {
        results::state_fields(packer, problem.state);
        ends.push_back(static_cast<Whole>(packer.bytes.size()));
    }
    const std::vector<Whole> numbers = numbers_of(packer.bytes);
    file.write("/problems/state_end", ends);
    file.write("/problems/states", numbers);
    file.write("/problems/checksum", std::vector<Whole>{checksum(bytes_of(numbers))});
}

[[noreturn]] void refuse_damaged(const std::filesystem::path& path)
{
    throw InputError(path.string(), "a file of step problems that was damaged", "take them again");
}

/// The bytes of state i. @param ends as written
std::string_view state_bytes(const std::string& bytes, const std::vector<Whole>& ends, std::size_t i)
{
    const Whole first = i == 0 ? 0 : ends[i - 1], end = ends[i];
    if (first < 0 || end < first || static_cast<std::uint64_t>(end) > bytes.size()) return {};
    return std::string_view(bytes).substr(static_cast<std::size_t>(first), static_cast<std::size_t>(end - first));
}

bool is_sound(const StoredStep& problem, std::size_t cases)
{
    return problem.case_index < cases && std::isfinite(problem.time_step) && problem.time_step > 0 &&
           results::is_count(problem.increment) && std::isfinite(problem.force_tolerance) &&
           problem.force_tolerance > 0 && results::is_sound(problem.state);
}

/// The columns of the table of problems.
struct Columns {
    std::vector<std::string> names, tags;
    std::vector<Whole> cases, increments, ends;
    std::vector<double> time_steps, tolerances;

    explicit Columns(const Hdf5File& file)
        : names(file.read_texts("/problems/name")),
          tags(file.read_texts("/problems/tags")),
          cases(file.read<Whole>("/problems/case")),
          increments(file.read<Whole>("/problems/increment")),
          ends(file.read<Whole>("/problems/state_end")),
          time_steps(file.read<double>("/problems/time_step")),
          tolerances(file.read<double>("/problems/force_tolerance"))
    {
    }
    bool are_alike() const
    {
        const std::size_t n = names.size();
        return tags.size() == n && cases.size() == n && increments.size() == n && ends.size() == n &&
               time_steps.size() == n && tolerances.size() == n;
    }
};

void read_cases(const Hdf5File& file, Corpus& corpus)
{
    for (std::size_t i = 0; file.has(case_at(i)); ++i)
        corpus.cases.push_back(
            {file.read_text(case_at(i)), divided(file.text_attribute(case_at(i), "settings"), "\n")});
}

}  // namespace

void save(const Corpus& corpus, const std::filesystem::path& path)
{
    Hdf5File file = Hdf5File::create(path);
    file.attribute("/", "kind", std::string(kind));
    file.make_group("/cases");
    for (std::size_t i = 0; i < corpus.cases.size(); ++i) {
        file.write_text(case_at(i), corpus.cases[i].text);
        file.attribute(case_at(i), "settings", joined(corpus.cases[i].overrides, "\n"));
    }
    file.make_group("/problems");
    file.write_texts("/problems/name", column<std::string>(corpus, [](auto& p) { return p.name; }));
    file.write_texts("/problems/tags", column<std::string>(corpus, [](auto& p) { return joined(p.tags, ", "); }));
    file.write("/problems/case", column<Whole>(corpus, [](auto& p) { return static_cast<Whole>(p.case_index); }));
    file.write("/problems/increment", column<Whole>(corpus, [](auto& p) { return p.increment; }));
    file.write("/problems/time_step", column<double>(corpus, [](auto& p) { return p.time_step; }));
    file.write("/problems/force_tolerance", column<double>(corpus, [](auto& p) { return p.force_tolerance; }));
    write_states(corpus, file);
    file.close();
}

Corpus load(const std::filesystem::path& path)
{
    const Hdf5File file = Hdf5File::open(path);
    if (file.text_attribute("/", "kind") != kind)
        throw InputError(path.string(), "no step problems of this version", "take them again");
    Corpus corpus;
    read_cases(file, corpus);
    const Columns columns(file);
    const std::string bytes = bytes_of(file.read<Whole>("/problems/states"));
    if (!columns.are_alike() || file.read<Whole>("/problems/checksum") != std::vector<Whole>{checksum(bytes)})
        refuse_damaged(path);
    for (std::size_t i = 0; i < columns.names.size(); ++i) {
        StoredStep problem;
        problem.name = columns.names[i];
        problem.case_index = static_cast<std::size_t>(columns.cases[i]);
        problem.time_step = columns.time_steps[i];
        problem.increment = columns.increments[i];
        problem.force_tolerance = columns.tolerances[i];
        problem.tags = divided(columns.tags[i], ", ");
        results::Unpacker unpacker(state_bytes(bytes, columns.ends, i));
        results::state_fields(unpacker, problem.state);
        if (!unpacker.done() || !is_sound(problem, corpus.cases.size())) refuse_damaged(path);
        corpus.problems.push_back(std::move(problem));
    }
    return corpus;
}

}  // namespace voussoir::app::problems
