//! Which colour and which marking a ball has, by its name.

/// How a ball is marked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(in crate::window::render) enum Marking {
    /// One colour, a number in a white circle on two sides.
    Solid(u8),
    /// A broad band of colour on white, a number in a white circle on two sides.
    Stripe(u8),
    /// Six dots, so that the spin shows.
    Dots,
}

/// sRGB colour of a ball, 0 to 1.
pub(in crate::window::render) type Colour = [f32; 3];

/// What white is on a ball.
pub(super) const IVORY: Colour = [0.93, 0.905, 0.83];

/// The standard colours of pool, 1 to 8; 9 to 15 repeat 1 to 7.
const POOL: [Colour; 8] = [
    [0.96, 0.71, 0.03],
    [0.03, 0.14, 0.55],
    [0.80, 0.05, 0.05],
    [0.27, 0.07, 0.40],
    [0.95, 0.36, 0.03],
    [0.01, 0.33, 0.15],
    [0.40, 0.03, 0.06],
    [0.025, 0.025, 0.028],
];

/// Colour and marking of a ball with this name.
pub(in crate::window::render) fn look(name: &str) -> (Colour, Marking) {
    if let Ok(number @ 1..=15) = name.parse::<u8>() {
        let colour = POOL[usize::from((number - 1) % 8)];
        return if number > 8 {
            (POOL[usize::from(number - 9)], Marking::Stripe(number))
        } else {
            (colour, Marking::Solid(number))
        };
    }
    let word = |part: &str| name.to_lowercase().contains(part);
    let colour = if word("cue") || word("white") {
        IVORY
    } else if word("yellow") {
        POOL[0]
    } else if word("red") {
        POOL[2]
    } else if word("black") {
        POOL[7]
    } else if word("green") {
        POOL[5]
    } else if word("brown") {
        [0.33, 0.14, 0.05]
    } else if word("blue") {
        POOL[1]
    } else if word("pink") {
        [0.90, 0.42, 0.50]
    } else {
        hashed(name)
    };
    (colour, Marking::Dots)
}

/// The pattern of a ball with this name, for whoever cannot tell its colour: how many rings around it, how many lines from
/// pole to pole. A solid and the stripe of its colour have the same; the white ends of the stripe tell them apart.
pub(super) fn pattern(name: &str) -> (u32, u32) {
    const BY_NUMBER: [(u32, u32); 8] = [
        (1, 0),
        (2, 0),
        (0, 4),
        (0, 10),
        (1, 4),
        (3, 0),
        (2, 10),
        (0, 0),
    ];
    if let Ok(number @ 1..=15) = name.parse::<u8>() {
        return BY_NUMBER[usize::from((number - 1) % 8)];
    }
    let name = name.to_lowercase();
    [
        ("yellow", (1, 0)),
        ("green", (2, 0)),
        ("brown", (0, 4)),
        ("blue", (0, 10)),
        ("pink", (1, 4)),
    ]
    .into_iter()
    .find(|(word, _)| name.contains(word))
    .map_or((0, 0), |(_, pattern)| pattern)
}

/// One of sixteen hues, by the name. Many balls then share few textures.
fn hashed(name: &str) -> Colour {
    let hash = name.bytes().fold(0x811c_9dc5_u32, |h, b| {
        (h ^ u32::from(b)).wrapping_mul(0x0100_0193)
    });
    let hue = ((hash >> 16) % 16) as f32 / 16.0;
    [0.0, 1.0 / 3.0, 2.0 / 3.0].map(|shift| {
        let wave = libm::cosf(std::f32::consts::TAU * (hue + shift));
        0.08 + 0.68 * (0.5 + 0.5 * wave)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stripe_has_the_colour_of_the_solid_seven_below() {
        for number in 9..=15_u8 {
            let (stripe, marking) = look(&number.to_string());
            let (solid, _) = look(&(number - 8).to_string());
            assert_eq!(stripe, solid);
            assert_eq!(marking, Marking::Stripe(number));
        }
    }

    #[test]
    fn no_two_colours_have_the_same_pattern() {
        for names in [
            ["1", "2", "3", "4", "5", "6", "7", "8"].as_slice(),
            &["red 1", "yellow", "green", "brown", "blue", "pink"],
        ] {
            let mut seen: Vec<(u32, u32)> = names.iter().map(|name| pattern(name)).collect();
            seen.sort_unstable();
            seen.dedup();
            assert_eq!(seen.len(), names.len());
        }
        for number in 9..=15_u8 {
            let solid = (number - 8).to_string();
            assert_eq!(pattern(&number.to_string()), pattern(&solid));
        }
    }

    #[test]
    fn many_names_share_few_colours() {
        let mut seen: Vec<Colour> = (0..1000).map(|i| look(&format!("b{i}")).0).collect();
        seen.sort_by(|a, b| a.partial_cmp(b).expect("colours are finite"));
        seen.dedup();
        assert!(seen.len() <= 16 && seen.len() > 8, "{}", seen.len());
    }
}
