//! How much work a frame may be.

use bevy::prelude::*;
use bevy::render::render_resource::WgpuAdapterInfo;

use crate::game::settings::{Quality, Settings};

/// How much work a frame may be.
#[derive(Resource, Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum RenderQuality {
    /// For a driver that draws with the processor: one shadow, coarser balls, no multisampling.
    Low,
    /// For a graphics card.
    #[default]
    High,
}

impl RenderQuality {
    /// What suits an adapter.
    #[must_use]
    pub fn for_adapter(adapter: &WgpuAdapterInfo) -> Self {
        // The type of this field is not among Bevy's exports, its name is stable.
        if format!("{:?}", adapter.device_type) == "Cpu" {
            Self::Low
        } else {
            Self::High
        }
    }

    /// What the player has set, and what suits the adapter if that is left to us.
    fn chosen(quality: Quality, suited: Self) -> Self {
        match quality {
            Quality::Automatic => suited,
            Quality::Low => Self::Low,
            Quality::High => Self::High,
        }
    }

    /// Lamps that cast shadows.
    pub(super) fn shadows(self) -> usize {
        match self {
            Self::Low => 1,
            Self::High => 3,
        }
    }

    /// Texels along one side of a shadow map.
    pub(super) fn shadow_map(self) -> usize {
        match self {
            Self::Low => 1024,
            Self::High => 2048,
        }
    }

    /// Segments around a ball.
    pub(super) fn segments(self) -> u32 {
        match self {
            Self::Low => 32,
            Self::High => 64,
        }
    }

    /// Samples a texture may take along its slope.
    pub(super) fn anisotropy(self) -> u16 {
        match self {
            Self::Low => 2,
            Self::High => 16,
        }
    }
}

/// Follows the settings. The first value is what suits the adapter.
pub(super) fn follow(
    settings: Res<Settings>,
    mut quality: ResMut<RenderQuality>,
    mut suited: Local<Option<RenderQuality>>,
) {
    let suited = *suited.get_or_insert(*quality);
    if settings.is_changed() {
        quality.set_if_neq(RenderQuality::chosen(settings.quality, suited));
    }
}
