#include <cmath>
#include <numbers>
#include <string>

#include "figure/csv_table.h"
#include "figures.h"
#include "material/fresnel.h"
#include "material/metal.h"
#include "reference.h"

namespace caustic {

void chartReflectance(FigureContext& context) {
    constexpr Real ior = 1.5;
    CsvTable table({"curve", "angle", "reflectance"});
    const std::pair<std::string, Metal> metals[] = {
        {"gold", Metal::gold()}, {"silver", Metal::silver()}, {"copper", Metal::copper()}};
    for (int step = 0; step <= 900; ++step) {
        const Real angle = step / 10.0;
        const Real cosine = step == 900 ? 0 : std::cos(angle * std::numbers::pi / 180);
        const Polarised polarised = referenceDielectric(cosine, ior);
        table.addRow("into glass", angle, fresnelDielectric(cosine, ior));
        table.addRow("into glass: across", angle, polarised.across);
        table.addRow("into glass: within", angle, polarised.within);
        table.addRow("into glass: Schlick", angle, schlick(cosine, ior));
        table.addRow("out of glass", angle, fresnelDielectric(cosine, 1 / ior));
        table.addRow("out of glass: Schlick", angle, schlick(cosine, 1 / ior));
        for (const auto& [name, metal] : metals) {
            const Color r = fresnelConductor(cosine, metal.eta, metal.k);
            table.addRow(name + " red", angle, r.x());
            table.addRow(name + " green", angle, r.y());
            table.addRow(name + " blue", angle, r.z());
        }
    }
    table.save(context.output("reflectance.csv"));
    context.chart("measures/reflectance.gp", "reflectance.png");
}

}  // namespace caustic
