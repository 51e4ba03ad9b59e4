use std::collections::BTreeMap;
use std::path::PathBuf;

use super::{quadratic, quartic};

/// The rows of a file of quartics: coefficients constant first, sorted real roots, class.
fn quartics(name: &str) -> Vec<([f64; 5], Vec<f64>, u32)> {
    let folder = std::env::var_os("MASSE_REFERENCE").map_or_else(
        || PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/reference")),
        PathBuf::from,
    );
    let text =
        std::fs::read_to_string(folder.join("quartic").join(name)).expect("the file is there");
    text.lines()
        .skip(1)
        .map(|line| {
            let row: Vec<f64> = line
                .split(',')
                .map(|x| x.parse().expect("a number"))
                .collect();
            let mut roots: Vec<f64> = (0..4)
                .filter(|i| row[6 + 2 * i] == 0.0)
                .map(|i| row[5 + 2 * i])
                .collect();
            roots.sort_by(f64::total_cmp);
            let class = row.get(13).map_or(0, |class| *class as u32);
            ([row[4], row[3], row[2], row[1], row[0]], roots, class)
        })
        .collect()
}

/// Relative errors of every real root, each asked for from half way to the root before it.
fn errors(c: &[f64; 5], roots: &[f64]) -> Vec<f64> {
    let mut errors = Vec::new();
    for (i, &root) in roots.iter().enumerate() {
        let from = if i == 0 {
            root - root.abs() - 1.0
        } else {
            roots[i - 1] + 0.5 * (root - roots[i - 1])
        };
        if i > 0 && (from <= roots[i - 1] || from >= root) {
            continue;
        }
        // The leading coefficient is positive: the first root falls, the next rises, and so on.
        let sign = if i % 2 == 0 { 1.0 } else { -1.0 };
        let found = quartic::first_closing(c.map(|x| sign * x), from, f64::INFINITY)
            .expect("the coefficients are finite")
            .unwrap_or(f64::NAN);
        errors.push((found - root).abs() / root.abs());
    }
    errors
}

#[test]
fn quartic_roots_match_the_reference() {
    // class -> (largest, median) relative error allowed. The peer: standard 3e-12, 5e-16; class 1 1e-5, 1e-12; class 4
    // 2e-4, 3e-5.
    let gates: [(&str, &[(u32, f64, f64)]); 2] = [
        ("standard.csv", &[(0, 4e-16, 0.0)]),
        (
            "hard.csv",
            &[
                (0, 4e-16, 0.0),
                (1, 4e-16, 0.0),
                (2, 4e-16, 0.0),
                (3, 4e-16, 0.0),
                (4, 1e-12, 4e-16),
                (5, 4e-16, 0.0),
            ],
        ),
    ];
    for (file, gates) in gates {
        let mut by_class: BTreeMap<u32, Vec<f64>> = BTreeMap::new();
        for (c, roots, class) in quartics(file) {
            by_class
                .entry(class)
                .or_default()
                .extend(errors(&c, &roots));
        }
        for &(class, most, median) in gates {
            let errors = by_class.get_mut(&class).expect("the class is in the file");
            errors.sort_by(f64::total_cmp);
            let (worst, middle) = (errors[errors.len() - 1], errors[errors.len() / 2]);
            println!(
                "{file} class {class}: {} roots, median {middle:e}, largest {worst:e}",
                errors.len()
            );
            assert!(
                worst <= most && middle <= median,
                "{file} class {class}: median {middle:e}, largest {worst:e}"
            );
        }
    }
}

#[test]
fn a_reference_quartic_without_roots_has_none() {
    for (c, roots, _) in quartics("standard.csv")
        .into_iter()
        .chain(quartics("hard.csv"))
    {
        if roots.is_empty() {
            assert_eq!(
                quartic::first_closing(c, -1e3, f64::INFINITY),
                Ok(None),
                "{c:?}"
            );
        }
    }
}

/// |p + v t + h t²|² − reach² in one dimension across and one along.
fn pair(across: f64, along: f64, speed: f64, half: f64, reach: f64) -> [f64; 5] {
    [
        across * across + along * along - reach * reach,
        2.0 * along * speed,
        speed * speed + 2.0 * along * half,
        2.0 * speed * half,
        half * half,
    ]
}

#[test]
fn a_grazing_pair_is_neither_missed_nor_invented() {
    let reach = 0.05715;
    for exponent in 3..=14 {
        let depth = reach * libm::pow(10.0, -f64::from(exponent));
        for half in [0.0, -0.981, 0.3] {
            let near = pair(reach - depth, -1.0, 2.0, half, reach);
            let far = pair(reach + depth, -1.0, 2.0, half, reach);
            let time = quartic::first_closing(near, 0.0, 10.0)
                .expect("finite")
                .expect("they touch");
            // Where they touch, the way along is −√(reach² − across²).
            let along = -1.0 + time * (2.0 + time * half);
            let wanted = -(depth * (2.0 * reach - depth)).sqrt();
            let rounding = 1e-15 / wanted.abs() + 1e-15;
            assert!(
                (along - wanted).abs() <= 10.0 * rounding,
                "depth {depth:e}: {along:e} {wanted:e}"
            );
            assert_eq!(
                quartic::first_closing(far, 0.0, 10.0),
                Ok(None),
                "depth {depth:e}"
            );
        }
    }
}

#[test]
fn touching_and_closing_is_now() {
    assert_eq!(
        quadratic::first_closing([0.0, -1.0, 1.0], 0.0, 1.0),
        Ok(Some(0.0))
    );
    assert_eq!(
        quadratic::first_closing([0.0, 0.0, -1.0], 0.0, 1.0),
        Ok(Some(0.0))
    );
    assert_eq!(
        quadratic::first_closing([0.0, 0.0, 1.0], 0.0, 1.0),
        Ok(None)
    );
    assert_eq!(quadratic::first_closing([0.0; 3], 0.0, 1.0), Ok(None));
    assert_eq!(
        quartic::first_closing([0.0, 0.0, 0.0, -1.0, 1.0], 0.0, 1.0),
        Ok(Some(0.0))
    );
    assert_eq!(
        quartic::first_closing([-1e-18, -1.0, 1.0, 0.0, 1.0], 0.0, 1.0),
        Ok(Some(0.0))
    );
    assert_eq!(
        quartic::first_closing([0.0, 1.0, 0.0, 0.0, 1.0], 0.0, 9.0),
        Ok(None)
    );
}

#[test]
fn an_overlap_that_turns_round_closes_where_it_turns() {
    assert_eq!(
        quadratic::first_closing([-1.0, 1.0, -1.0], 0.0, 9.0),
        Ok(Some(0.5))
    );
    let time = quartic::first_closing([-1.0, 1.0, -1.0, 0.0, 1e-6], 0.0, 9.0)
        .expect("finite")
        .expect("turns");
    assert!((time - 0.5).abs() < 1e-6);
    // Rises above zero first: the falling root.
    assert_eq!(
        quadratic::first_closing([-2.0, 3.0, -1.0], 0.0, 9.0),
        Ok(Some(2.0))
    );
    let time = quartic::first_closing([-2.0, 3.0, -1.0, 0.0, 1e-9], 0.0, 9.0)
        .expect("finite")
        .expect("falls");
    assert!((time - 2.0).abs() < 1e-7);
}

#[test]
fn numbers_without_meaning_are_an_error() {
    for bad in [f64::NAN, f64::INFINITY] {
        assert!(quartic::first_closing([1.0, bad, 1.0, 1.0, 1.0], 0.0, 1.0).is_err());
        assert!(quadratic::first_closing([1.0, bad, 1.0], 0.0, 1.0).is_err());
    }
    assert!(
        quartic::first_closing([1.0, 1e200, 1e200, 1e200, 1e200], 0.0, 1e300)
            .is_ok_and(|x| x.is_none())
    );
    assert!(quadratic::first_closing([1.0, 1e200, -1.0], 0.0, 1.0).is_err());
}

proptest::proptest! {
    /// Against a fine scan: the first sign change from + to − of any quartic.
    #[test]
    fn no_root_is_jumped_over(
        r in proptest::array::uniform4(-1.0_f64..3.0),
        spread in -0.2_f64..0.2,
        kind in 0..3,
    ) {
        // Factors (t − r₀)(t − r₁) and either two more real roots or a pair of complex ones.
        let (p, q) = if kind == 0 { (r[2] + r[3], r[2] * r[3]) } else { (2.0 * r[2], r[2] * r[2] + spread * spread) };
        let (s, u) = (r[0] + r[1], r[0] * r[1]);
        let sign = if kind == 2 { -1.0 } else { 1.0 };
        let c = [u * q, -(u * p + s * q), u + q + s * p, -(s + p), 1.0].map(|x| sign * x);
        let value = |t: f64| c.iter().rev().fold(0.0, |sum, x| sum * t + x);
        let found = quartic::first_closing(c, 0.0, 2.0).expect("finite");
        let steps = 4000_u32;
        let t = |i: u32| 2.0 * f64::from(i) / f64::from(steps);
        let scan = (0..steps).find(|&i| value(t(i)) > 1e-9 && value(t(i + 1)) < -1e-9).map(t);
        if let Some(scanned) = scan {
            proptest::prop_assert!(found.is_some_and(|x| x <= scanned + 2.0 / f64::from(steps)), "{c:?} {found:?} {scanned}");
        }
        if let Some(time) = found {
            proptest::prop_assert!(value(time) <= 1e-12);
        }
    }
}

#[test]
fn a_guess_beyond_its_stretch_is_not_a_root() {
    // Found by the property above.
    let c = [
        -0.041_958_588_372_853_135,
        0.729_559_205_722_966,
        -2.442_350_160_093_747,
        2.869_224_308_531_267,
        -1.0,
    ];
    let time = quartic::first_closing(c, 0.0, 2.0)
        .expect("finite")
        .expect("it falls");
    assert!((time - 1.644_246_141_748_179).abs() < 1e-12, "{time}");
}
