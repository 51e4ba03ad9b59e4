//! A picture of a record file, by the program.

use crate::cli::{err, folder, masse, out, output};

#[test]
fn a_record_is_drawn_without_running_it_again() {
    let folder = folder("record");
    for (scene, solver) in [("break-nine", "exact"), ("draw-back", "stepped")] {
        let run = output(
            masse()
                .args(["run", scene, "--solver", solver, "--quiet"])
                .args(["--out", "r.jsonl", "--picture", "run.svg"])
                .current_dir(&folder),
        );
        assert_eq!(run.status.code(), Some(0), "{}", err(&run));
        let picture = ["picture", "r.jsonl", "record.svg"];
        let drawn = output(masse().args(picture).current_dir(&folder));
        assert_eq!(drawn.status.code(), Some(0), "{}", err(&drawn));
        assert_eq!((out(&drawn), err(&drawn)), (String::new(), String::new()));
        let text = |name: &str| std::fs::read_to_string(folder.join(name)).expect("a picture");
        assert!(text("run.svg").matches("<polyline").count() >= 2, "{scene}");
        assert_eq!(text("run.svg"), text("record.svg"), "{scene}");
    }
    let cases: &[(&str, &[u8], &str)] = &[
        ("missing", b"", "no-such.jsonl: "),
        ("empty", b"", "bad.jsonl:1:"),
        ("bytes", b"{}\n\xff\xfe", "bad.jsonl: byte 3 is not UTF-8"),
        ("scene file", b"(table: NineFoot)", "bad.jsonl:1:1: "),
        (
            "newer",
            b"{\"format\":\"masse record\",\"version\":9}",
            "bad.jsonl:1: version: 9",
        ),
    ];
    for (what, bytes, part) in cases {
        let file = if *what == "missing" {
            "no-such.jsonl"
        } else {
            "bad.jsonl"
        };
        std::fs::write(folder.join("bad.jsonl"), bytes).expect("cargo's folder can be written");
        let refused = output(
            masse()
                .args(["picture", file, "bad.svg"])
                .current_dir(&folder),
        );
        assert_eq!(refused.status.code(), Some(2), "{what}: {}", err(&refused));
        assert!(
            err(&refused).contains(part),
            "{what} lacks {part}: {}",
            err(&refused)
        );
        assert!(
            !folder.join("bad.svg").exists(),
            "{what}: something was written"
        );
    }
}
