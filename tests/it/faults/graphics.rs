//! Nothing to draw on or with: said in one line, never as a panic.

use std::process::{Command, Output};

use crate::cli::{err, folder, masse, output};

/// The program where these variables are set, in a folder of its own.
fn with(name: &str, variables: &[(&str, &str)]) -> (Command, std::path::PathBuf) {
    let folder = folder(name);
    let mut command = masse();
    command
        .current_dir(&folder)
        .env("XDG_CONFIG_HOME", &folder)
        .env("XDG_DATA_HOME", &folder)
        .env("HOME", &folder)
        .envs(variables.iter().copied());
    (command, folder)
}

fn no_panic(output: &Output) {
    let said = err(output);
    for bad in ["panicked", "RUST_BACKTRACE", "Validation Error"] {
        assert!(!said.contains(bad), "{said}");
    }
}

/// A display that is not there.
const NOWHERE: (&str, &str) = ("DISPLAY", ":64999");

/// No driver is found where there is none.
const NO_DRIVER: [(&str, &str); 3] = [
    NOWHERE,
    ("VK_DRIVER_FILES", "/nonexistent.json"),
    ("VK_ICD_FILENAMES", "/nonexistent.json"),
];

#[cfg(all(feature = "window", target_os = "linux"))]
#[test]
fn where_no_window_can_be_opened_it_is_said_why_and_the_break_is_drawn() {
    let weak = [NOWHERE, ("WGPU_SETTINGS_PRIO", "webgl2")];
    let cases: [(&str, &[(&str, &str)], &[&str]); 4] = [
        ("graphics-none", &NO_DRIVER, &["no graphics adapter"]),
        // A machine without any adapter says that.
        (
            "graphics-weak",
            &weak,
            &["storage buffers a shader", "no graphics adapter"],
        ),
        (
            "graphics-nowhere",
            &[NOWHERE],
            &["no display", "no graphics adapter"],
        ),
        (
            "graphics-wayland",
            &[("WAYLAND_DISPLAY", "nowhere")],
            &["no display", "no graphics adapter"],
        ),
    ];
    for (name, variables, says) in cases {
        let (mut command, folder) = with(name, variables);
        let output = output(&mut command);
        no_panic(&output);
        let said = err(&output);
        assert!(says.iter().any(|what| said.contains(what)), "{said}");
        assert!(said.contains("runs without a window"), "{said}");
        assert_eq!(output.status.code(), Some(0), "{said}");
        let told = crate::cli::out(&output);
        assert!(told.contains("every ball is at rest"), "{told}");
        assert!(folder.join("masse-break.svg").is_file());
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_film_that_cannot_be_drawn_ends_with_its_own_code() {
    let weak = [("WGPU_SETTINGS_PRIO", "webgl2")];
    for (name, variables) in [("film-none", &NO_DRIVER[..]), ("film-weak", &weak[..])] {
        let (mut command, folder) = with(name, variables);
        let output = output(command.args(["film", "stun-shot", "--out", "frames", "--to", "0"]));
        no_panic(&output);
        assert_eq!(output.status.code(), Some(5), "{}", err(&output));
        let said = err(&output);
        let lacks = [
            "no graphics adapter",
            "storage buffers a shader",
            "a build without a window",
        ];
        assert!(lacks.iter().any(|what| said.contains(what)), "{said}");
        let frames = std::fs::read_dir(folder.join("frames")).expect("a folder");
        assert_eq!(frames.count(), 0, "no frame that is no picture");
    }
}
