// voussoir-problems: takes step problems out of runs and judges the fast open-close iteration by the plain one.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <fstream>
#include <map>
#include <set>

#include "app/problems/judge.h"
#include "app/problems/problem_file.h"
#include "app/problems/tables.h"
#include "app/problems/take.h"
#include "app/problems/whole.h"
#include "app/reader/case_file.h"
#include "importers/process/program_start.h"
#include "libdda/errors.h"
#include "libdda/text/printable.h"

namespace
{

using namespace voussoir;
namespace problems = app::problems;

constexpr const char* program_name = "voussoir-problems";

void say(const std::string& line)
{
    std::printf("%s\n", text::printable(line).c_str());
    std::fflush(stdout);
}

void write_json(const std::string& json, const std::string& file)
{
    std::ofstream stream(file, std::ios::binary);
    stream << json << std::flush;
    if (!stream) throw InputError(file, "the file cannot be written", "choose another location");
}

problems::Corpus load_all(const std::vector<std::string>& files)
{
    problems::Corpus corpus;
    for (const std::string& file : files) problems::add(problems::load(file), corpus);
    std::set<std::string> names;
    for (const problems::StoredStep& problem : corpus.problems)
        if (!names.insert(problem.name).second)
            throw InputError(problem.name, "two problems have this name", "take one of them with --name");
    return corpus;
}

/// Problems of one case follow each other as they were taken: each case is read once for all of them.
int judge(const std::vector<std::string>& files, const std::string& json, const problems::JudgeOptions& options)
{
    const problems::Corpus corpus = load_all(files);
    std::size_t width = 8;
    for (const problems::StoredStep& problem : corpus.problems) width = std::max(width, problem.name.size());
    say(problems::head_line(static_cast<int>(width)));
    std::map<std::size_t, app::Case> cases;
    std::vector<problems::Judgement> found;
    for (const problems::StoredStep& problem : corpus.problems) {
        if (!cases.contains(problem.case_index)) {
            cases.clear();
            cases.emplace(problem.case_index, problems::read(corpus.cases[problem.case_index]));
        }
        found.push_back(problems::judge(cases.at(problem.case_index), problem, options));
        say(problems::line_of(found.back(), static_cast<int>(width)));
    }
    say(problems::summary_of(found));
    if (!json.empty()) write_json(problems::json_of(found, options), json);
    return problems::passes(found, options) ? 0 : 1;
}

int take(const problems::TakeArguments& arguments, const std::string& output)
{
    const problems::Corpus corpus = problems::take(arguments);
    problems::save(corpus, output);
    say(std::to_string(corpus.problems.size()) + " problems written to " + output);
    return 0;
}

int join(const std::vector<std::string>& files, const std::string& output)
{
    const problems::Corpus corpus = load_all(files);
    problems::save(corpus, output);
    say(std::to_string(corpus.problems.size()) + " problems written to " + output);
    return 0;
}

int whole(const std::string& file, const std::vector<std::string>& settings)
{
    const problems::WholeComparison both = problems::compare_whole(app::reader::read_case(file, settings));
    std::printf("%s\n", problems::lines_of(both).c_str());
    return both.passes() ? 0 : 1;
}

/// What the command line says.
struct Arguments {
    problems::TakeArguments take;
    std::string case_file, output, json;
    std::vector<std::string> files;
    problems::JudgeOptions options;
};

CLI::App* add_take(CLI::App& program, Arguments& all)
{
    CLI::App* take = program.add_subcommand("take", "run a case and store the states before chosen steps");
    take->add_option("CASE", all.take.file, "case file; it may name no other files")->required();
    take->add_option("-o,--output", all.output, "file of step problems to write")->required();
    take->add_option("--name", all.take.name, "of the problems; that of the case file if absent");
    take->add_option("--at", all.take.at, "times of the run [s]: the first step that begins no earlier")
        ->delimiter(',');
    take->add_option("--every", all.take.every, "each step whose number this divides");
    take->add_option("--of", all.take.of, "of these only steps with one of these tags")->delimiter(',');
    take->add_option("--most", all.take.most, "problems");
    take->add_option("--set", all.take.settings, "KEY=VALUE, as of voussoir run")->take_all();
    return take;
}

int run(int argc, char** argv)
{
    CLI::App program("Step problems, and how the fast open-close iteration does on them.", program_name);
    program.require_subcommand(1);
    Arguments all;
    CLI::App* taking = add_take(program, all);
    CLI::App* judging = program.add_subcommand("judge", "make each step by the fast and by the plain iteration");
    judging->add_option("FILE", all.files, "files of step problems")->required();
    judging->add_option("--json", all.json, "file to write the same to");
    judging->add_option("--large-from", all.options.large_from, "blocks, from which the laws alone judge");
    judging->add_option("--iterations", all.options.iterations,
                        "that the fast iteration may take; else the case's");
    judging->add_option("--most-iterations", all.options.most_in_all,
                        "that the fast iteration may take in all problems together");
    judging->add_option("--most-not-unique", all.options.most_not_unique,
                        "problems that may have two steps; else one in twenty");
    CLI::App* joining = program.add_subcommand("join", "write the problems of several files into one");
    joining->add_option("FILE", all.files, "files of step problems")->required();
    joining->add_option("-o,--output", all.output, "file of step problems to write")->required();
    CLI::App* comparing = program.add_subcommand("whole", "a whole run by both iterations");
    comparing->add_option("CASE", all.case_file, "case file")->required();
    comparing->add_option("--set", all.take.settings, "KEY=VALUE, as of voussoir run")->take_all();
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? 0 : 2;
    }
    if (taking->parsed()) return take(all.take, all.output);
    if (judging->parsed()) return judge(all.files, all.json, all.options);
    if (joining->parsed()) return join(all.files, all.output);
    return whole(all.case_file, all.take.settings);
}

}  // namespace

int main(int argc, char** argv)
{
    importers::process::begin_program();
    try {
        return run(argc, argv);
    } catch (const InputError& error) {
        importers::process::complain(program_name, error.what());
        return 2;
    } catch (const std::exception& error) {
        importers::process::complain(program_name, error.what());
        return 1;
    }
}
