// Channels matched to a target spectrum.

#include <algorithm>

#include "records/processing/steps.h"
#include "records/synthetic/matching.h"

namespace voussoir::records::processing
{

void apply(const Match& step, const std::string& place, ProcessedRecord& record)
{
    for (Channel& channel : record.channels) {
        synthetic::MatchReport report;
        try {
            channel = synthetic::match_spectrum(channel, step.target, step.settings, report);
        } catch (const InputError& error) {
            throw InputError(place, error.faults.front().found, error.faults.front().expected);
        }
        const std::string of = channel.component.empty() ? "" : "component \"" + channel.component + "\" ";
        record.sentences.push_back(of + "matched to " + step.target.name + " from " +
                                   figure(step.settings.shortest) + " to " + figure(step.settings.longest) +
                                   " s: within " + figure(100 * report.worst) + " % (worst at " +
                                   figure(report.worst_period) + " s), time step " + figure(channel.time_step) +
                                   " s, at rest at the end");
    }
}

}  // namespace voussoir::records::processing
