//! Units, which other tools convert and show: they know those of MAVLink's schema only.

mod spelling;

use super::suggest;
use crate::diag::{Code, Diagnostic, Diagnostics};
use crate::syntax::Text;

/// The values of `SI_Unit` in pymavlink's `mavschema.xsd`, which its option `--strict-units` enforces.
const KNOWN: &str = "\
    s ds cs ms us ns Hz MHz \
    km dam m m^2 m/s m/s/s m/s*5 dm dm/s cm cm^2 cm/s mm mm/s mm/h \
    rad rad/s mrad/s deg deg/2 ddeg/s deg/s cdeg cdeg/s degE5 degE7 rpm \
    V cV mV A cA mA mAh Ah mT gauss mgauss hJ W \
    K degC cdegC mG g kg Pa hPa kPa mbar \
    % d% c% dB dBm \
    KiB KiB/s MiB MiB/s bytes bytes/s bits/s pix dpix \
    g/min cm^3/min L/h cm^3 l L";

fn known() -> impl Iterator<Item = &'static str> {
    KNOWN.split(' ')
}

/// Reports a unit that the schema does not have; no text is no unit.
pub(super) fn check(units: &Option<Text>, diagnostics: &mut Diagnostics) {
    let Some(units) = units.as_ref().filter(|units| !units.value.is_empty()) else { return };
    if known().any(|known| known == units.value) {
        return;
    }
    let message = format!("unit `{}` is not one of MAVLink's", units.value);
    let problem = Diagnostic::new(Code::Units, units.span, message).label("ground stations do not know it");
    suggest::report_by(problem, &mut || spelling::meant(&units.value), diagnostics);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_schema_has_78() {
        assert_eq!(known().collect::<std::collections::HashSet<_>>().len(), 78);
        assert!(known().all(|unit| !unit.is_empty()));
    }
}
