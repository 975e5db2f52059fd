// A user of voussoir::records: the peak of an accelerogram, found twice.
#include <voussoir/records.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

int main(int argument_count, char** arguments)
{
    if (argument_count != 2) return 2;
    const voussoir::records::Record record = voussoir::records::read_record(arguments[1], {});
    const voussoir::records::Channel& channel = record.channels.at(0);
    double largest = 0;  // m/s2
    for (const double value : channel.samples) largest = std::max(largest, std::abs(value));
    const double peak = voussoir::records::measures::measures_of(channel).peak_acceleration;
    std::printf("%s: %zu samples, PGA %.3f m/s2\n", record.format.c_str(), channel.samples.size(), peak);
    return largest > 0 && std::abs(peak - largest) < 1e-9 ? 0 : 1;
}
