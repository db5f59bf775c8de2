//! Overlays with a mistake anywhere: refused with a place, or understood, and never a panic.

use super::{enumeration, message};
use crate::diag::{Diagnostics, Style, render};
use crate::read::{Loaded, read, read_overlay};
use crate::roots::resolve;
use crate::source::Sources;

/// One of everything.
const SAMPLE: &str = "<mavlink-overlay version='1' for='a.xml'>\
<enums><enum name='L'><entry value='0' name='L_A'/></enum></enums>\
<refine enum='E' bitmask='true'/><note message='M' field='f'>x</note>\
<message name='M'><bind name='x' field='p' enum='E' if='p' is='1'/>\
<view name='V' words='a[i] b[i]' item='s' items='ss' count='n'>\
<key name='k' field='c[i]' units='ms' invalid='9'/><invalid field='c[i]' value='9'/><invalid value='0'/>\
<bits name='l' at='0' width='4' enum='L'/><bits name='r' at='4' width='1' repeat='4' stride='2'/>\
<reserved at='5' width='1'/><reserved at='7' width='1'/><reserved at='9' width='1'/><reserved at='11' width='1'/>\
<bits name='v' at='12' width='12' signed='true' scale='1/100' bias='-3' units='V' exact='mV'/>\
<switch field='c[i]'><case value='1..=2 30..'><bits name='y' at='24' width='8'/></case>\
<default><bits name='z' at='24' width='8'/></default></switch></view>\
<view name='W' words='d[*] f' item='w' if='p' is='1'><bits name='t' at='0' width='8'/>\
<switch bits='t'><case value='0..'><bits name='u' at='8' width='24'/></case></switch></view>\
</message></mavlink-overlay>";

/// The problems of an overlay; it must be refused if and only if one is an error, and each must have a place.
fn problems(overlay: &str) -> usize {
    let (mut sources, mut diagnostics, mut loaded) = (Sources::default(), Diagnostics::default(), Loaded::default());
    "a".clone_into(&mut loaded.name);
    let fields =
        ["uint16_t[4] a", "uint16_t[4] b", "uint8_t[4] c", "uint8_t[2] d", "uint8_t n", "uint8_t p", "uint16_t f"];
    let dialect = enumeration("E", &["E_A=1", "E_B=2", "E_C=4"]) + &message(1, "M", &fields);
    let id = sources.add("a.xml", format!("<mavlink>{dialect}</mavlink>"));
    loaded.files.push(read(id, &sources, &mut diagnostics).into());
    let id = sources.add("a.overlay.xml", overlay);
    loaded.overlays.push(read_overlay(id, &sources, &mut diagnostics).into());
    let model = resolve(&loaded, &sources, &mut diagnostics);
    assert_eq!(model.is_none(), diagnostics.has_errors(), "{overlay}");
    for problem in diagnostics.iter() {
        let drawn = render(problem, &sources, Style::Plain);
        assert!(problem.span.is_some() && drawn.contains("--> a."), "{drawn}");
    }
    diagnostics.len()
}

#[test]
fn no_single_change_breaks_anything() {
    assert_eq!(problems(SAMPLE), 0);
    for (at, was) in SAMPLE.char_indices() {
        for put in ["", "'", "9", "é"] {
            problems(&format!("{}{put}{}", &SAMPLE[..at], &SAMPLE[at + was.len_utf8()..]));
        }
    }
}

#[test]
fn no_number_is_too_large() {
    let numbers = SAMPLE.match_indices(|letter: char| letter.is_ascii_digit());
    for (at, was) in numbers {
        for put in ["18446744073709551615", "340282366920938463463374607431768211456", "-9223372036854775808", "1e18"] {
            problems(&format!("{}{put}{}", &SAMPLE[..at], &SAMPLE[at + was.len()..]));
        }
    }
}
