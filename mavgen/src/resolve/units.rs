//! Units, which other tools convert and show: they know those of MAVLink's schema only. One that is spelled in another way,
//! `m/s^2`, `msec`, `Degrees`, `µs`, is recognised.
//!
//! A unit is a product of factors with exponents. Two texts mean the same unit if they have the same factors, each by its symbol,
//! its name, or its symbol in other letter case. Only where that leads nowhere it is a slip of the pen: there a short symbol is not
//! taken for another, because `l/min` is not nearly `g/min`.

use super::suggest;
use crate::collect::CollectVec as _;
use crate::diag::{Code, Diagnostic, Diagnostics, nearest};
use crate::order;
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
    suggest::report_by(problem, &mut || meant(&units.value), diagnostics);
}

/// What people call factors beside their symbols, in the singular and in small letters.
const NAMES: [(&str, &str); 23] = [
    ("s", "sec second"),
    ("min", "min minute"),
    ("h", "hr hour"),
    ("m", "meter metre"),
    ("g", "gram"),
    ("rad", "rad radian"),
    ("deg", "deg degree °"),
    ("V", "volt"),
    ("A", "amp ampere"),
    ("W", "watt"),
    ("J", "joule"),
    ("Hz", "hertz"),
    ("K", "kelvin"),
    ("degC", "c degc °c celsius"),
    ("Pa", "pascal"),
    ("bar", "bar"),
    ("gauss", "gauss"),
    ("T", "tesla"),
    ("%", "percent pct"),
    ("pix", "px pixel"),
    ("bytes", "byte"),
    ("bits", "bit"),
    ("L", "liter litre"),
];

/// What may stand before a name, for each prefix of a symbol.
#[rustfmt::skip]
const PREFIXES: [(&str, &str); 9] = [
    ("n", "nano n"), ("u", "micro u"), ("m", "milli m"), ("c", "centi c"), ("d", "deci d"), ("da", "deca"), ("h", "hecto h"),
    ("k", "kilo k"), ("M", "mega"),
];

/// What is written for a quotient.
const QUOTIENTS: [(&str, &str); 3] = [("mps", "m/s"), ("cmps", "cm/s"), ("dps", "deg/s")];

/// A name of one letter takes no prefix: `cc` is no hundredth of a degree.
const SHORTEST_PREFIXED: usize = 2;

/// A slip in a shorter symbol makes another symbol.
const SHORTEST_SLIP: usize = 4;

/// No unit is so long.
const LONGEST: usize = 40;

/// The unit of the schema that a text most likely stands for.
fn meant(text: &str) -> Option<&'static str> {
    let text = Some(text.trim()).filter(|text| text.len() <= LONGEST)?;
    let quotient = QUOTIENTS.iter().find(|(short, _)| text.eq_ignore_ascii_case(short)).map(|&(_, unit)| unit);
    let wanted = factors(quotient.unwrap_or(text));
    let same = || known().find(|unit| wanted.is_some() && factors(unit) == wanted);
    same().or_else(|| nearest(text, known().filter(|unit| is_slip(text, unit))))
}

/// Whether all that differs is a word that is long enough to be misspelled.
fn is_slip(text: &str, unit: &str) -> bool {
    let parts = |text: &'_ str| text.split(['/', '*']).map(str::to_ascii_lowercase).collect_vec();
    let (wrong, right) = (parts(text), parts(unit));
    let is_long = |(wrong, right): (&String, &String)| wrong == right || right.len() >= SHORTEST_SLIP;
    wrong.len() == right.len() && wrong.iter().zip(&right).all(is_long)
}

/// The symbols of a unit, each with its exponent; nothing if something in it is none.
fn factors(text: &str) -> Option<Vec<(&'static str, i32)>> {
    let text = text.replace(['µ', 'μ'], "u").replace("**", "^").replace('²', "^2").replace('³', "^3");
    let text = text.replace('/', " / ").replace(['*', '·', '.', '_'], " ");
    let (mut factors, mut sign) = (Vec::new(), 1);
    for word in text.split_whitespace() {
        if word == "/" || word == "per" {
            sign = -1;
            continue;
        }
        let (symbol, exponent) = factor(word)?;
        match factors.iter_mut().find(|(known, _)| *known == symbol) {
            Some((_, sum)) => *sum += sign * exponent,
            None => factors.push((symbol, sign * exponent)),
        }
        sign = 1;
    }
    if factors.iter().any(|(symbol, _)| *symbol == "degC") {
        // `degrees C`
        factors.retain(|(symbol, _)| *symbol != "deg");
    }
    order::sort_by_key(&mut factors, |(symbol, _)| *symbol);
    Some(factors)
}

/// A symbol and its exponent: `s^2`, `s2`, `s^-2`. Digits of a symbol itself, as in `degE7`, are none.
fn factor(word: &str) -> Option<(&'static str, i32)> {
    if let Some(symbol) = symbol(word) {
        return Some((symbol, 1));
    }
    let base = word.trim_end_matches(|last: char| last.is_ascii_digit());
    let exponent: i32 = word.strip_prefix(base)?.parse().ok().filter(|exponent| (1..=9).contains(exponent))?;
    let (base, sign) = base.strip_suffix('-').map_or((base, 1), |base| (base, -1));
    Some((symbol(base.strip_suffix('^').unwrap_or(base))?, sign * exponent))
}

/// The symbol that a word is, names, or would be in other letter case.
fn symbol(word: &str) -> Option<&'static str> {
    let lower = word.to_lowercase();
    let singular = lower.strip_suffix('s').unwrap_or(&lower);
    let exact = symbols().find(|symbol| *symbol == word);
    let named = || named(&lower).or_else(|| named(singular));
    exact.or_else(named).or_else(|| symbols().find(|symbol| symbol.eq_ignore_ascii_case(word)))
}

/// The symbol of a name, with or without a prefix.
fn named(name: &str) -> Option<&'static str> {
    let base = |name: &str| NAMES.iter().find(|(_, names)| names.split(' ').any(|known| known == name));
    let prefixed = PREFIXES.iter().flat_map(|(letter, prefixes)| prefixes.split(' ').map(move |one| (letter, one)));
    let prefixed = prefixed.filter_map(|(letter, prefix)| {
        let rest = name.strip_prefix(prefix).filter(|rest| rest.len() >= SHORTEST_PREFIXED)?;
        Some(format!("{letter}{}", base(rest)?.0))
    });
    let mut spelled = base(name).map(|(symbol, _)| (*symbol).to_owned()).into_iter().chain(prefixed);
    spelled.find_map(|spelled| symbols().find(|symbol| *symbol == spelled))
}

/// The symbols that the units of the schema are made of.
fn symbols() -> impl Iterator<Item = &'static str> {
    known().flat_map(|unit| unit.split(['/', '*'])).filter_map(|factor| factor.split('^').next())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_schema_has_78() {
        assert_eq!(known().collect::<std::collections::HashSet<_>>().len(), 78);
        assert!(known().all(|unit| !unit.is_empty()));
    }

    /// What is written, and what it means.
    const SPELLINGS: [(&str, &str); 68] = [
        ("m/s^2", "m/s/s"),
        ("m/s2", "m/s/s"),
        ("m/s²", "m/s/s"),
        ("m/s**2", "m/s/s"),
        ("m s^-2", "m/s/s"),
        ("m.s-2", "m/s/s"),
        ("meters/sec/sec", "m/s/s"),
        ("meters per second", "m/s"),
        ("M/S", "m/s"),
        ("mps", "m/s"),
        ("degrees", "deg"),
        ("degree", "deg"),
        ("Deg", "deg"),
        ("°", "deg"),
        ("°/s", "deg/s"),
        ("deg/sec", "deg/s"),
        ("dps", "deg/s"),
        ("centidegrees", "cdeg"),
        ("cdegrees/s", "cdeg/s"),
        ("degE-7", "degE7"),
        ("radians", "rad"),
        ("Radians/second", "rad/s"),
        ("msec", "ms"),
        ("milliseconds", "ms"),
        ("MS", "ms"),
        ("usec", "us"),
        ("µs", "us"),
        ("microseconds", "us"),
        ("seconds", "s"),
        ("sec", "s"),
        ("us ", "us"),
        ("meters", "m"),
        ("metres", "m"),
        ("Meter", "m"),
        ("centimeters", "cm"),
        ("cm2", "cm^2"),
        ("mAH", "mAh"),
        ("mah", "mAh"),
        ("milliamps", "mA"),
        ("Amps", "A"),
        ("amperes", "A"),
        ("volts", "V"),
        ("Volts", "V"),
        ("v", "V"),
        ("millivolts", "mV"),
        ("percent", "%"),
        ("pct", "%"),
        ("centipercent", "c%"),
        ("celsius", "degC"),
        ("°C", "degC"),
        ("deg C", "degC"),
        ("degrees Celsius", "degC"),
        ("degc", "degC"),
        ("centidegC", "cdegC"),
        ("hertz", "Hz"),
        ("hz", "Hz"),
        ("RPM", "rpm"),
        ("Gauss", "gauss"),
        ("milligauss", "mgauss"),
        ("millibar", "mbar"),
        ("hectopascals", "hPa"),
        ("byte", "bytes"),
        ("bit/s", "bits/s"),
        ("pixels", "pix"),
        ("px", "pix"),
        ("liters", "L"),
        ("litres/hour", "L/h"),
        ("gaus", "gauss"),
    ];

    #[test]
    fn a_unit_is_itself() {
        for unit in known() {
            assert!(factors(unit).is_some_and(|factors| !factors.is_empty()), "{unit}");
            assert_eq!(meant(unit).and_then(factors), factors(unit), "{unit}");
        }
    }

    /// No two units of the schema are one here, but for the litre, which has two symbols.
    #[test]
    fn units_are_told_apart() {
        for (index, unit) in known().enumerate() {
            for other in known().skip(index + 1) {
                assert_ne!(factors(unit), factors(other), "{unit} {other}");
            }
        }
    }

    #[test]
    fn names_and_prefixes_lead_to_symbols() {
        for (symbol, names) in NAMES {
            let prefixes = [""].into_iter().chain(PREFIXES.iter().map(|(letter, _)| *letter));
            let mut spelled = prefixes.map(|prefix| format!("{prefix}{symbol}"));
            assert!(spelled.any(|spelled| symbols().any(|symbol| symbol == spelled)), "{names} names nothing");
        }
    }

    #[test]
    fn spellings_that_people_use() {
        for (text, unit) in SPELLINGS {
            assert_eq!(meant(text).and_then(factors), factors(unit), "{text}: {:?}", meant(text));
        }
    }

    /// Another quantity is no suggestion.
    #[test]
    fn what_the_schema_does_not_have() {
        let long = "m ".repeat(100);
        for text in
            [&*long, "", "l/min", "ft", "ft/s", "feet", "kts", "mph", "cc", "km/h", "1/s", "min", "/", "N", "m^9", "?"]
        {
            assert_eq!(meant(text), None, "{text}");
        }
    }
}
