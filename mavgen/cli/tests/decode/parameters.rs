//! Parameters, whose values are seldom of the type of their field.

use serde_json::{Value, json};

use crate::bench::Bench;

const PARAMETERS: &str = r#"<mavlink>
  <messages>
    <message id="22" name="PARAM_VALUE">
      <description/>
      <field type="char[16]" name="param_id"/>
      <field type="float" name="param_value"/>
      <field type="uint8_t" name="param_type"/>
      <field type="uint16_t" name="param_count"/>
      <field type="uint16_t" name="param_index"/>
    </message>
    <message id="322" name="PARAM_EXT_VALUE">
      <description/>
      <field type="char[128]" name="param_value"/>
      <field type="uint8_t" name="param_type"/>
    </message>
  </messages>
</mavlink>
"#;

fn value(bench: &mut Bench, bytes: [u8; 4], ty: u8) -> Vec<u8> {
    let id = b"TANK\0\0\0\0\0\0\0\0\0\0\0\0";
    bench.frame(22, &[&bytes[..], &[1, 0, 0, 0], id, &[ty]].concat())
}

/// What there is beside the fields, in text.
fn beside(bench: &Bench, frame: &[u8]) -> String {
    let text = bench.printed_without(&[], frame);
    text.split_once('\n').unwrap().1.to_owned()
}

#[test]
fn no_integer_is_lost_in_a_float() {
    let mut bench = Bench::of(PARAMETERS);
    for (integer, shown, json_shown) in [
        (-1_i32, "NaN(0xffffffff)", json!("NaN(0xffffffff)")),
        (-2, "NaN(0xfffffffe)", json!("NaN(0xfffffffe)")),
        (7, "1e-44", json!(1e-44)),
    ] {
        let frame = value(&mut bench, integer.to_le_bytes(), 6);
        let text = bench.printed_without(&[], &frame);
        assert!(text.contains(&format!("param_value: {shown}, param_type: 6,")), "{text}");
        assert!(text.ends_with(&format!("\n    parameter: bytewise {integer}\n")), "{text}");
        let json: Value = serde_json::from_str(&bench.printed_without(&["--format", "json"], &frame)).unwrap();
        assert_eq!(json["message"]["param_value"], json_shown);
        assert_eq!(json["views"], json!({"parameter": {"bytewise": integer}}));
        let csv = ["--format", "csv", "--message", "PARAM_VALUE", "--fields", "param_value,parameter"];
        let csv = bench.printed_without(&csv, &frame);
        let (head, row) = csv.split_once('\n').unwrap();
        assert!(head.ends_with(",param_value,parameter.bytewise,parameter.cast"), "{head}");
        assert!(row.ends_with(&format!(",{shown},{integer},\n")), "{row}");
    }
}

#[test]
fn both_readings_are_shown_where_both_are_possible() {
    let mut bench = Bench::of(PARAMETERS);
    for (bytes, ty, expected) in [
        (7_f32.to_le_bytes(), 6, "    parameter: bytewise 1088421888, cast 7\n"),
        (0_f32.to_le_bytes(), 5, "    parameter: bytewise 0, cast 0\n"),
        (1_f32.to_le_bytes(), 1, "    parameter: cast 1\n"),
        (0.25_f32.to_le_bytes(), 1, ""),
        (0.25_f32.to_le_bytes(), 9, ""),
        (0.25_f32.to_le_bytes(), 0, ""),
        (7_f32.to_le_bytes(), 77, ""),
    ] {
        let frame = value(&mut bench, bytes, ty);
        assert_eq!(beside(&bench, &frame), expected, "{ty}");
    }
}

#[test]
fn values_in_bytes_are_shown() {
    let mut bench = Bench::of(PARAMETERS);
    for (bytes, ty, expected) in [
        (&256_i32.to_le_bytes()[..], 6, "    parameter: bytewise 256\n"),
        (&0.25_f32.to_le_bytes(), 9, "    parameter: bytewise 0.25\n"),
        (&(-0.1_f64).to_le_bytes(), 10, "    parameter: bytewise -0.1\n"),
        (&u64::MAX.to_le_bytes(), 7, "    parameter: bytewise 18446744073709551615\n"),
        (b"abc", 11, ""),
    ] {
        let mut payload = [0; 129];
        payload[..bytes.len()].copy_from_slice(bytes);
        payload[128] = ty;
        let frame = bench.frame(322, &payload);
        assert_eq!(beside(&bench, &frame), expected, "{ty}");
    }
}
