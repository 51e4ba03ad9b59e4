//! How loud the player wants the table.

use serde::{Deserialize, Serialize};

/// What makes a sound.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SoundKind {
    /// Ball on ball.
    Balls,
    /// Ball on rubber, and a ball that lands on the slate.
    Cushions,
    /// Ball into pocket.
    Pockets,
    /// Tip on ball.
    Cue,
    /// Balls that roll over the cloth.
    Rolling,
    /// Buttons of the panels.
    Interface,
}

impl SoundKind {
    /// Every kind, in the order in which they are listed.
    pub const ALL: [Self; 6] = [
        Self::Balls,
        Self::Cushions,
        Self::Pockets,
        Self::Cue,
        Self::Rolling,
        Self::Interface,
    ];
}

/// Loudness of every sound of the game. All levels go from 0, silent, to 1.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Volume {
    /// Over all kinds.
    pub level: f32,
    /// Nothing is heard while this is set; the levels are kept.
    pub muted: bool,
    /// Of [`SoundKind::Balls`].
    pub balls: f32,
    /// Of [`SoundKind::Cushions`].
    pub cushions: f32,
    /// Of [`SoundKind::Pockets`].
    pub pockets: f32,
    /// Of [`SoundKind::Cue`].
    pub cue: f32,
    /// Of [`SoundKind::Rolling`].
    pub rolling: f32,
    /// Of [`SoundKind::Interface`].
    pub interface: f32,
}

impl Volume {
    /// The level of a kind that is in use now, 0 to 1.
    #[must_use]
    pub fn audible(&self, kind: SoundKind) -> f32 {
        if self.muted {
            return 0.0;
        }
        let mut own = *self;
        self.level.clamp(0.0, 1.0) * own.of(kind).clamp(0.0, 1.0)
    }

    /// The level of a kind alone, to change it.
    pub fn of(&mut self, kind: SoundKind) -> &mut f32 {
        match kind {
            SoundKind::Balls => &mut self.balls,
            SoundKind::Cushions => &mut self.cushions,
            SoundKind::Pockets => &mut self.pockets,
            SoundKind::Cue => &mut self.cue,
            SoundKind::Rolling => &mut self.rolling,
            SoundKind::Interface => &mut self.interface,
        }
    }
}

impl Default for Volume {
    fn default() -> Self {
        Self {
            level: 0.8,
            muted: false,
            balls: 1.0,
            cushions: 1.0,
            pockets: 1.0,
            cue: 1.0,
            rolling: 1.0,
            interface: 0.5,
        }
    }
}
