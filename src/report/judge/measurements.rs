//! What others measured, as printed by them or read off their figures. Data only.

/// E1: Mathavan, Jackson & Parkin, Am. J. Phys. 77 (2009): least and greatest deceleration in m/s² of balls that roll and
/// that slide.
pub(super) const MATHAVAN_2009_ROLL: (f64, f64) = (0.124, 0.126);
pub(super) const MATHAVAN_2009_SLIDE: (f64, f64) = (1.75, 2.40);

/// E2: Mathavan, Jackson & Parkin, Am. J. Phys. 77 (2009), table I. Oblique hits by a rolling cue ball, snooker: speed in
/// m/s and cut angle in degrees, then the settled speeds of cue ball and object ball in m/s.
pub(super) const MATHAVAN_2009: [[f64; 4]; 5] = [
    [1.539, 33.83, 0.816, 0.836],
    [1.032, 26.36, 0.520, 0.629],
    [1.364, 40.52, 0.925, 0.700],
    [1.731, 46.50, 1.275, 0.787],
    [0.942, 18.05, 0.365, 0.581],
];

/// E3: Mathavan, Jackson & Parkin, Proc. Inst. Mech. Eng. C 224 (2010), fig. 7a. A snooker ball that rolls square into a cushion:
/// speed before and after in m/s.
pub(super) const MATHAVAN_2010: [(f64, f64); 19] = [
    (0.263, 0.234),
    (0.355, 0.324),
    (0.418, 0.383),
    (0.651, 0.583),
    (0.704, 0.665),
    (0.845, 0.791),
    (1.154, 1.069),
    (1.299, 1.237),
    (1.526, 1.456),
    (1.755, 1.645),
    (1.991, 1.824),
    (2.276, 2.031),
    (2.530, 2.280),
    (2.701, 2.265),
    (2.893, 2.383),
    (2.985, 2.462),
    (3.106, 2.620),
    (3.185, 2.568),
    (3.405, 2.732),
];

/// E4: Sudo & Shibata (2002): restitution of ball and ball, mean angle in degrees at which two balls part, and
/// restitution of a cushion below 1.8 m/s and over all speeds.
pub(super) struct Sudo;

impl Sudo {
    pub(super) const BALLS: f64 = 0.897;
    pub(super) const SEPARATION_DEG: f64 = 85.05;
    pub(super) const CUSHION_SLOW: f64 = 0.856;
    pub(super) const CUSHION: f64 = 0.745;
}

/// E5: Domenech (2023), 99 billiard markers put together by angle: cut angle and throw in degrees, of a ball that rolls
/// with 0.80 m/s.
pub(super) const DOMENECH_2023: [(f64, f64); 7] = [
    (7.7, 1.0),
    (16.8, 1.9),
    (28.0, 2.9),
    (40.0, 4.1),
    (50.0, 4.5),
    (60.0, 5.1),
    (70.0, 5.8),
];

/// Speed in m/s of the cue ball in E5.
pub(super) const DOMENECH_SPEED: f64 = 0.80;

/// E6: Derby & Fuller (1999), film of a square hit by a ball that rolls with 0.98 m/s: settled speeds of cue ball and
/// object ball in m/s.
pub(super) const DERBY_FULLER_1999: [f64; 3] = [0.98, 0.251, 0.583];

/// E7: Alciatore, TP A.15, high-speed video of a frozen pair: angle of the cue to the line of centres and angle at which
/// the cue ball leaves, degrees.
pub(super) const FROZEN_PAIR: [(f64, f64); 7] = [
    (8.0, 13.0),
    (20.0, 34.0),
    (34.0, 50.0),
    (46.0, 61.0),
    (57.0, 70.0),
    (67.0, 78.0),
    (77.0, 87.0),
];

/// E9: Han (2005), eq. 26: restitution of a cushion at a normal speed in m/s.
pub(super) const HAN_2005: [(f64, f64); 5] = [
    (0.5, 0.5075),
    (1.0, 0.603),
    (1.5, 0.6765),
    (2.0, 0.728),
    (2.5, 0.7575),
];

/// E10: 182 tracked shots of three-cushion billiards: normal speed in m/s and the share of it that is left once the ball
/// rolls again. At the higher speeds the tracking, every 0.1 s, sees the ball before it has settled.
pub(super) const THREE_CUSHION_SETTLED: (f64, f64) = (0.4, 0.585);

/// E10, faster rebounds: seen too early to count as settled.
pub(super) const THREE_CUSHION_FAST: [(f64, f64); 2] = [(1.2, 0.76), (2.15, 0.80)];

/// E10: deceleration in m/s² of balls that roll at 0.1 to 0.3, 0.3 to 0.6 and 0.6 to 1.0 m/s.
pub(super) const CAROM_ROLL: [f64; 3] = [0.0418, 0.0431, 0.0480];
