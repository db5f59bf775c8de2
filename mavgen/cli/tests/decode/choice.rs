//! `--fields`, `--views` and `--no-view`.

use serde_json::{Value, json};

use crate::bench::Bench;

fn stream(bench: &mut Bench) -> Vec<u8> {
    [bench.sprayer(), bench.nozzles(0), bench.nozzles(1)].concat()
}

#[test]
fn some_fields() {
    let mut bench = Bench::new();
    let stream = stream(&mut bench);
    assert_eq!(bench.printed(&["--fields", "level"], &stream), "1/2 #0 SPRAYER { level: 300 cm }\n");
    assert_eq!(
        bench.printed(&["--fields", "count,nozzles.status.angle"], &stream),
        "1/2 #1 NOZZLES { count: 2 }\n    nozzles[0]: angle -0.50 deg\n    nozzles[1]: status unknown\n\
         1/2 #2 NOZZLES { count: 2 }\n    nozzles[0]: angle -0.50 deg\n    nozzles[1]: status unknown\n"
    );
    let json = bench.printed(&["--fields", "f*", "--format", "json"], &stream);
    let json: Value = serde_json::from_str(&json).unwrap();
    let message =
        json!({"type": "SPRAYER", "flags": "SPRAY_FLAGS_LEAK | SPRAY_FLAGS_COLD | 0x40", "flow": [null, 0.1]});
    assert_eq!((&json["message"], &json["units"], &json["views"]), (&message, &json!({"flow": "g/min"}), &json!({})));
    // Of the two messages, one has such a column.
    let csv = bench.printed(&["--fields", "flow", "--format", "csv"], &stream);
    let head = "time,unix_time (s),system_id,component_id,sequence,flow[0] (g/min),flow[1] (g/min)";
    assert_eq!(csv, format!("{head}\n,,1,2,0,,0.1\n"));
    let unknown = bench.frame(100, &[]);
    let less = ["--messages", "NOZZLES", "--fields", "mode"];
    assert_eq!(bench.printed(&less, &[&unknown[..], &stream].concat()).lines().count(), 2);
}

#[test]
fn some_views() {
    let mut bench = Bench::new();
    let stream = stream(&mut bench);
    let printed = |options: &[&str]| bench.printed(options, &stream);
    let (all, lines) = (printed(&[]), |text: &str| text.lines().count());
    assert_eq!(lines(&all), 3 + 1 + 4);
    assert_eq!(lines(&printed(&["--no-view", "nozzles"])), 4);
    assert_eq!(printed(&["--views", "mode"]), printed(&["--no-view", "nozz*"]));
    assert_eq!(lines(&printed(&["--no-view", "*"])), 3);
    assert_eq!(printed(&["--views", "mode,nozzles"]), all);
    let head = |options: &[&str]| {
        let csv = ["--format", "csv", "--message", "NOZZLES"];
        bench.printed(&[&csv, options].concat(), b"").trim_end().split(',').count()
    };
    assert_eq!((head(&[]), head(&["--no-view", "*"])), (5 + 8 + 3 * 12, 5 + 8));
    assert_eq!(head(&["--views", "nozzles", "--fields", "nozzles.id,nozzles.status.open"]), 5 + 3 * 9);
}
