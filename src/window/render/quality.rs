//! How much work a frame may be.

use bevy::prelude::*;
use bevy::render::render_resource::WgpuAdapterInfo;

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
