// verify, limit, converge, ensemble and stability on the command line.
#include <CLI/CLI.hpp>

#include <memory>

#include "app/command_line/command_line.h"
#include "app/commands/commands.h"

namespace voussoir::app::command_line
{

namespace
{

void add_verify(CLI::App& program, std::function<int()>& chosen)
{
    auto arguments = std::make_shared<commands::VerifyArguments>();
    CLI::App* command =
        program.add_subcommand("verify", "Run the benchmarks of the papers: error against run time");
    command->add_option("name", arguments->names, "Benchmarks (all)")->type_name("NAME");
    command->add_flag("--list", arguments->list, "List the benchmarks, run nothing");
    command->add_flag("--sweep", arguments->sweep,
                      "Also vary time steps, methods and stiffnesses; CPU times as medians of 3");
    command->add_option("--seed", arguments->seed, "Of the benchmarks that draw their points")
        ->capture_default_str();
    command->add_option("--json", arguments->json, "Write the results as JSON to a file (- is standard output)")
        ->type_name("FILE");
    CLI::Option* folder = command
                              ->add_option("-o,--output", arguments->folder,
                                           "Folder for the page, and with --sweep for the diagrams")
                              ->type_name("DIR");
    command->add_flag("--tables", arguments->tables, "A page of tables with one diagram, as docs/ keeps it")
        ->needs(folder);
    command->callback(
        [arguments, &chosen] { chosen = [arguments] { return commands::verify_command(*arguments); }; });
}

void add_stability(CLI::App& program, std::function<int()>& chosen)
{
    auto arguments = std::make_shared<commands::StabilityArguments>();
    CLI::App* command =
        program.add_subcommand("stability", "Stiff and extreme scenes, each in its own process: a failure map");
    command->add_option("name", arguments->names, "Scenes or cells (all)")->type_name("NAME");
    command->add_flag("--list", arguments->list, "List the cells, run nothing");
    command->add_option("--jobs", arguments->jobs, "Number of cells run in parallel")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str();
    command
        ->add_option("--tolerance-factor", arguments->tolerance_factor,
                     "Factor on the tolerance of every cell, to find the margin")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    command->add_option("--json", arguments->json, "Write the results as JSON to a file (- is standard output)")
        ->type_name("FILE");
    CLI::Option* folder = command
                              ->add_option("-o,--output", arguments->folder,
                                           "Folder for stability.md, the maps as pictures and stability.json")
                              ->type_name("DIR");
    command->add_flag("--tables", arguments->tables, "A page of tables with one map, as docs/ keeps it")
        ->needs(folder);
    command->callback(
        [arguments, &chosen] { chosen = [arguments] { return commands::stability_command(*arguments); }; });
}

/// A repeatable option whose values are separated by commas.
template <typename Value>
CLI::Option* add_list(CLI::App& command, const std::string& name, std::vector<Value>& values,
                      const std::string& help)
{
    return command.add_option(name, values, help)->delimiter(',')->allow_extra_args(false);
}

/// What converge varies.
void add_series(CLI::App& command, commands::ConvergeArguments& arguments)
{
    add_list(command, "--time-steps", arguments.time_steps,
             "Dynamic time steps (the case's x 4, 2, 1, 1/2, 1/4; of a threshold x 2, 1, 1/2)")
        ->type_name("TIME,...");
    add_list(
        command, "--stiffness-factors", arguments.stiffness_factors,
        "Factors on the case's contact stiffness (0.25, 0.5, 1, 2, 4; of a threshold 1, 2); 1 alone omits the "
        "series")
        ->type_name("FACTOR,...");
    add_list(command, "--integrators", arguments.integrators,
             "Beside the case's own: newmark, energy_decaying (the latter, but not of a threshold)")
        ->type_name("NAME,...");
}

/// What converge compares, and what counts as a collapse.
void add_quantities(CLI::App& command, commands::ConvergeArguments& arguments)
{
    CLI::Option* quantity = add_list(command, "--quantity", arguments.quantities,
                                     "Quantities to compare: POINT.u, .ux, .d (relative to the foot), .v ... or "
                                     "largest, with :history, :peak or :end");
    quantity->type_name("NAME,...");
    CLI::Option* threshold =
        command.add_option("--threshold", arguments.threshold,
                           "Compare the value at which the structure collapses, found between "
                           "one at which it stands and one at which it collapses; any key that --set takes, or "
                           "several between commas");
    threshold->type_name("KEY=STANDS..COLLAPSES")->excludes(quantity);
    command.add_option("--bracket", arguments.bracket, "Width of the bracket of a threshold")
        ->type_name("FRACTION")
        ->needs(threshold)
        ->capture_default_str();
    command
        .add_option("--tolerance", arguments.tolerance, "Wanted error, by which the conclusion chooses a setting")
        ->type_name("FRACTION")
        ->capture_default_str();
    command
        .add_option("--collapse-displacement", arguments.collapse_displacement,
                    "Displacement of a block, as a multiple of its size or a length, that is taken as collapse; "
                    "none: no collapse criterion")
        ->type_name("SIZES|LENGTH|none")
        ->capture_default_str();
}

void add_converge(CLI::App& program, std::function<int()>& chosen)
{
    auto arguments = std::make_shared<commands::ConvergeArguments>();
    CLI::App* command = program.add_subcommand(
        "converge", "Error against run time of your own case: time step and contact stiffness");
    command->add_option("case", arguments->case_file, "The case file (YAML)")->required()->type_name("CASE");
    add_quantities(*command, *arguments);
    add_series(*command, *arguments);
    add_overrides(*command, arguments->overrides);
    command
        ->add_option("--threads", arguments->threads,
                     "Number of threads; CPU times are then totals over all threads")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str();
    command->add_option("--json", arguments->json, "Write the results as JSON to a file (- is standard output)")
        ->type_name("FILE");
    command->add_option("-o,--output", arguments->folder, "Folder for the page and the diagrams")
        ->type_name("DIR");
    command->add_flag("-q,--quiet", arguments->quiet, "Print faults only");
    command->callback(
        [arguments, &chosen] { chosen = [arguments] { return commands::converge_command(*arguments); }; });
}

void add_ensemble(CLI::App& program, std::function<int()>& chosen)
{
    auto arguments = std::make_shared<commands::EnsembleArguments>();
    CLI::App* command = program.add_subcommand(
        "ensemble", "Nearly identical runs of your own case: medians and spread at time steps h and h/2");
    command->add_option("case", arguments->case_file, "The case file (YAML)")->required()->type_name("CASE");
    command
        ->add_option("--vary", arguments->vary,
                     "The varied key and its values, one for each member: blocks[0].house.imperfection.seed=1,2,3")
        ->required()
        ->type_name("KEY=VALUE,VALUE,...");
    command->add_option("--open", arguments->open, "Joints open by more than this are counted")
        ->type_name("LENGTH")
        ->capture_default_str();
    command
        ->add_option("--stiffness-factor", arguments->stiffness_factor,
                     "Also with the case's contact stiffness times this factor; 1 omits it")
        ->check(CLI::Range(1e-3, 1e3))
        ->capture_default_str();
    add_overrides(*command, arguments->overrides);
    command->add_option("--jobs", arguments->jobs, "Number of runs in parallel, each on one thread")
        ->check(CLI::Range(1, 1024))
        ->capture_default_str();
    command->add_option("--json", arguments->json, "Write the results as JSON to a file (- is standard output)")
        ->type_name("FILE");
    command->add_option("-o,--output", arguments->folder, "Folder for the page and the diagram")->type_name("DIR");
    command->add_flag("-q,--quiet", arguments->quiet, "Print faults only");
    command->callback(
        [arguments, &chosen] { chosen = [arguments] { return commands::ensemble_command(*arguments); }; });
}

void add_limit(CLI::App& program, std::function<int()>& chosen)
{
    auto arguments = std::make_shared<commands::LimitArguments>();
    CLI::App* command = program.add_subcommand(
        "limit", "Limit analysis of your own case: the acceleration at which its stones become a mechanism");
    command->add_option("case", arguments->case_file, "The case file (YAML)")->required()->type_name("CASE");
    add_list(*command, "--towards", arguments->towards, "Direction in which the stones are pushed")
        ->required()
        ->type_name("X,Y,Z");
    add_overrides(*command, arguments->overrides);
    command->add_option("--json", arguments->json, "Write the results as JSON to a file (- is standard output)")
        ->type_name("FILE");
    command->add_option("-o,--output", arguments->folder, "Folder for the page")->type_name("DIR");
    command->add_flag("-q,--quiet", arguments->quiet, "Print faults only");
    command->callback(
        [arguments, &chosen] { chosen = [arguments] { return commands::limit_command(*arguments); }; });
}

}  // namespace

void add_study_commands(CLI::App& program, std::function<int()>& chosen)
{
    add_verify(program, chosen);
    add_limit(program, chosen);
    add_converge(program, chosen);
    add_ensemble(program, chosen);
    add_stability(program, chosen);
}

}  // namespace voussoir::app::command_line
