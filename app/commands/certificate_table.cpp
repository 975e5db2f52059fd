#include <fmt/format.h>

#include <set>

#include "app/commands/certificate.h"
#include "app/commands/outputs.h"
#include "app/commands/say.h"
#include "app/words/csv_cell.h"

namespace voussoir::app::commands
{
namespace
{

const char* words_of(importers::assembly::Touch touch)
{
    switch (touch) {
        case importers::assembly::Touch::face:
            return "";
        case importers::assembly::Touch::tilted:
            return "tilted: edge contact only";
        case importers::assembly::Touch::corner:
            return "a corner touches";
        case importers::assembly::Touch::edge:
            break;
    }
    return "two edges cross";
}

std::string ground_words(const importers::assembly::Assembly& assembly)
{
    if (assembly.ground_given) return fmt::format("{} foundations", assembly.ground.size());
    return fmt::format("ground: the {} stone{} at the lowest level", assembly.ground.size(),
                       assembly.ground.size() == 1 ? "" : "s");
}

/// Wraps words at 110 columns; further lines are indented.
void print_wrapped(const std::string& first, const std::string& indent, const std::string& words)
{
    constexpr std::size_t width = 110;
    std::string line = first;
    bool empty = true;
    for (std::size_t start = 0; start < words.size();) {
        const std::size_t end = std::min(words.find(' ', start), words.size());
        const std::string word = words.substr(start, end - start);
        if (!empty && line.size() + 1 + word.size() > width) {
            say(line);
            line = indent;
            empty = true;
        }
        line += (empty ? "" : " ") + word;
        empty = false;
        start = end + 1;
    }
    say(line);
}

}  // namespace

void print_contact_graph(const importers::assembly::Assembly& assembly)
{
    if (assembly.stones.size() < 2) return;
    double area = 0;
    for (const importers::assembly::StoneContact& contact : assembly.contacts) area += contact.area;
    say(fmt::format(
        "contact graph: {} over {:.6g} m2, {} group{}, {}",
        assembly.contacts.size() == 1 ? "1 pair touches" : fmt::format("{} pairs touch", assembly.contacts.size()),
        area, assembly.components.size(), assembly.components.size() == 1 ? "" : "s", ground_words(assembly)));
    if (assembly.contacts.empty()) return;
    say(fmt::format("  {:<24} {:<24} {:>10} {:>8} {:>13}", "stone", "stone", "area m2", "patches",
                    "smallest gap"));
    for (std::size_t i = 0; i < std::min(assembly.contacts.size(), max_rows); ++i) {
        const importers::assembly::StoneContact& contact = assembly.contacts[i];
        say(fmt::format("  {:<24} {:<24} {:>10.4g} {:>8} {:>11.1e} m {}", assembly.stones[contact.a].name,
                        assembly.stones[contact.b].name, contact.area, contact.patches, contact.smallest_gap,
                        words_of(contact.touch)));
    }
    if (assembly.contacts.size() > max_rows)
        say(fmt::format("  and {} more pairs: --json and contact_graph.csv (-o DIR) have them all",
                        assembly.contacts.size() - max_rows));
}

void print_findings(const importers::assembly::Assembly& assembly)
{
    if (assembly.stones.empty()) return;
    if (assembly.findings.empty()) {
        say("no faults were found in the assembly of the stones");
        return;
    }
    say("findings:");
    for (const importers::assembly::AssemblyFinding& finding : assembly.findings) {
        print_wrapped(finding.harmless ? "  note: " : "  finding: ", "    ", finding.what);
        print_wrapped("    -> ", "       ", finding.advice);
    }
}

void write_contact_graph(const importers::assembly::Assembly& assembly, const std::filesystem::path& file)
{
    std::string text =
        "stone_a,stone_b,kind,area_m2,facing_area_m2,smallest_gap_m,patches,normal_x,normal_y,normal_z\n";
    const auto name = [&](int stone) { return words::csv_cell(assembly.stones[stone].name); };
    for (const importers::assembly::StoneContact& c : assembly.contacts)
        text += fmt::format("{},{},contact,{:.9g},{:.9g},{:.6g},{},{:.9g},{:.9g},{:.9g}\n", name(c.a), name(c.b),
                            c.area, c.facing_area, c.smallest_gap, c.patches, c.normal.x(), c.normal.y(),
                            c.normal.z());
    for (const importers::assembly::StoneGap& g : assembly.gaps)
        text += fmt::format("{},{},gap,0,{:.9g},{:.6g},{},,,\n", name(g.a), name(g.b), g.area, g.width,
                            g.polygons.size());
    write_own_file(file, text);
}

}  // namespace voussoir::app::commands
