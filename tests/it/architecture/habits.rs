//! Short files, telling names, and the same bits on every platform.

use super::tokens::{Token, tokens, without_tests};
use super::{Finding, Source, assert_none, module_of, sources};

/// Most lines of a file. About 300 is the habit, this is the bound.
const MOST_LINES: usize = 400;

/// Names that say nothing: put a thing where it is used, or name it after what it is.
const EMPTY_NAMES: [&str; 9] = [
    "common",
    "helper",
    "helpers",
    "misc",
    "prelude",
    "types",
    "util",
    "utilities",
    "utils",
];

/// Methods of `f64` that differ from platform to platform, or that fuse what is written apart.
const PLATFORM_METHODS: [&str; 24] = [
    "acos", "acosh", "asin", "asinh", "atan", "atan2", "atanh", "cbrt", "cos", "cosh", "exp",
    "exp2", "exp_m1", "hypot", "ln", "ln_1p", "log10", "log2", "mul_add", "powf", "powi", "sin",
    "sin_cos", "tan",
];

/// Methods of glam that call such methods inside.
const PLATFORM_GLAM: [&str; 10] = [
    "angle_between",
    "angle_to",
    "from_angle",
    "from_axis_angle",
    "from_euler",
    "from_rotation_x",
    "from_rotation_y",
    "from_rotation_z",
    "from_scaled_axis",
    "to_angle",
];

fn too_long(sources: &[Source]) -> Vec<Finding> {
    let long = sources
        .iter()
        .filter(|source| source.text.lines().count() > MOST_LINES);
    long.map(|source| Finding {
        path: source.path.clone(),
        line: source.text.lines().count(),
        what: format!("more than {MOST_LINES} lines: split it by noun"),
    })
    .collect()
}

fn empty_names(sources: &[Source]) -> Vec<Finding> {
    let mut findings = Vec::new();
    for source in sources {
        let find = |line: usize, name: &str| Finding {
            path: source.path.clone(),
            line,
            what: format!("`{name}` says nothing about what is inside"),
        };
        for name in module_of(&source.path) {
            if EMPTY_NAMES.contains(&name.as_str()) {
                findings.push(find(1, &name));
            }
        }
        for pair in tokens(&source.text).windows(3) {
            let opens = pair[0].text == "mod" && pair[2].text == "{";
            if opens && EMPTY_NAMES.contains(&pair[1].text.as_str()) {
                findings.push(find(pair[1].line, &pair[1].text));
            }
        }
    }
    findings
}

fn platform_methods(sources: &[Source]) -> Vec<Finding> {
    let mut findings = Vec::new();
    for source in sources {
        let code = without_tests(&tokens(&source.text));
        for i in 1..code.len() {
            if calls_platform_method(&code, i) {
                findings.push(Finding {
                    path: source.path.clone(),
                    line: code[i].line,
                    what: format!(
                        "`{}` is not the same bits everywhere: use libm",
                        code[i].text
                    ),
                });
            }
        }
    }
    findings
}

/// `.sin(` and `f64::sin`, but not `libm::sin(`, nor a function of our own called `exp`.
fn calls_platform_method(code: &[Token], i: usize) -> bool {
    let text = |i: usize| code.get(i).map_or("", |token| token.text.as_str());
    let name = text(i);
    let method = text(i - 1) == "." && text(i + 1) == "(";
    let of_number = i > 1 && text(i - 1) == "::" && ["f64", "f32"].contains(&text(i - 2));
    let of_glam = i > 1 && text(i - 1) == "::" && text(i - 2) != "libm" && text(i + 1) == "(";
    ((method || of_number) && (PLATFORM_METHODS.contains(&name) || name == "log"))
        || ((method || of_glam) && PLATFORM_GLAM.contains(&name))
}

fn house() -> Vec<Source> {
    ["src", "tests", "benches", "examples"]
        .into_iter()
        .flat_map(sources)
        .collect()
}

#[test]
fn no_file_is_too_long() {
    assert_none(&too_long(&house()));
    let long = Source::new("src/sim/long.rs", &"\n".repeat(MOST_LINES + 1));
    let just = Source::new("src/sim/just.rs", &"\n".repeat(MOST_LINES));
    assert_eq!(too_long(&[long, just]).len(), 1);
}

#[test]
fn no_module_has_an_empty_name() {
    assert_none(&empty_names(&house()));
    for (path, text) in [
        ("src/sim/utils.rs", ""),
        ("src/helpers/mod.rs", ""),
        ("tests/it/common/ball.rs", ""),
        ("src/sim/ball.rs", "pub mod prelude { }"),
    ] {
        assert_eq!(empty_names(&[Source::new(path, text)]).len(), 1, "{path}");
    }
}

#[test]
fn physics_and_sim_leave_transcendentals_to_libm() {
    let sources: Vec<Source> = ["src/physics", "src/sim"]
        .into_iter()
        .flat_map(sources)
        .filter(|source| !module_of(&source.path).contains(&"tests".to_owned()))
        .collect();
    assert!(
        sources.len() > 40,
        "only {} files were found",
        sources.len()
    );
    assert_none(&platform_methods(&sources));
    for text in [
        "let a = x.sin();",
        "let a = (b + c)\n    .powi(2);",
        "values.map(f64::exp)",
        "f64::atan2(1.0, 2.0)",
        "DVec2::from_angle(a)",
        "a.mul_add(b, c)",
    ] {
        assert_eq!(
            platform_methods(&[Source::new("src/sim/x.rs", text)]).len(),
            1,
            "{text}"
        );
    }
    for text in [
        "libm::sin(x); x.sqrt(); // x.sin()",
        "#[cfg(test)]\nmod tests { fn f() { 1.0_f64.sin(); } }",
        "let cos = 1.0; self.exp; libm::log(x)",
    ] {
        assert_eq!(
            platform_methods(&[Source::new("src/sim/x.rs", text)]),
            [],
            "{text}"
        );
    }
}
