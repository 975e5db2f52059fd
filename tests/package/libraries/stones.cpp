// A user of voussoir::importers: the blocks of a wall, certified, have its volume.
#include <voussoir/importers.h>

#include <cmath>
#include <cstdio>

namespace exact = voussoir::importers::exact;
namespace patterns = voussoir::importers::patterns;

int main()
{
    const patterns::Wall drawn{.length = 2, .height = 1, .thickness = 0.5};  // m
    double volume = 0;                                                       // m3
    int stones = 0;
    for (const patterns::MasonryBlock& block : patterns::wall(drawn)) {
        const exact::Certificate certificate = exact::certify(patterns::to_surface(block));
        if (!certificate.convex) return 1;
        volume += certificate.moments.volume;
        ++stones;
    }
    std::printf("%d stones, %.6f m3\n", stones, volume);
    return stones > 4 && std::abs(volume - 1) < 1e-9 ? 0 : 1;
}
