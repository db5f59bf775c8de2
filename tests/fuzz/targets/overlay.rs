//! Any text as an overlay of a small dialect: refused with a place, or it becomes Rust that parses.

#![no_main]

/// Something for every construct to be about: scalars and arrays of every width, an enum, flags.
const DIALECT: &str = "<mavlink><enums>\
<enum name='E'><entry value='0' name='E_A'/><entry value='1' name='E_B'/></enum>\
<enum name='F' bitmask='true'><entry value='1' name='F_A'/><entry value='4' name='F_B'/></enum></enums><messages>\
<message id='1' name='M'><description>.</description><field type='uint32_t[4]' name='a'>.</field>\
<field type='uint32_t[4]' name='b'>.</field><field type='uint8_t[4]' name='c'>.</field><field type='uint8_t[2]' name='d'>.</field>\
<field type='uint8_t' name='n'>.</field><field type='uint8_t' name='p' enum='E'>.</field><field type='uint16_t' name='f'>.</field>\
<field type='uint64_t' name='l'>.</field><field type='float' name='x'>.</field></message></messages></mavlink>";

libfuzzer_sys::fuzz_target!(|text: &str| mavlink_fuzz::compile(DIALECT, Some(text)));
