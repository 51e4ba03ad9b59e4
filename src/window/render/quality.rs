//! How much work a frame may be.

use std::sync::atomic::{AtomicBool, Ordering};

use bevy::prelude::*;
use bevy::render::render_resource::WgpuAdapterInfo;

use crate::game::settings::{Quality, Settings};

/// How much work a frame may be.
#[derive(Resource, Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum RenderQuality {
    /// For a driver that draws with the processor: one shadow, coarser balls, no multisampling, no light beyond white.
    Low,
    /// For a graphics chip that shares its memory: soft shadows and mirrors by rays, light that blooms.
    Medium,
    /// For a graphics card: finer textures, a shadow of cue and rails from every lamp.
    #[default]
    High,
    /// For a strong graphics card: ambient occlusion between all surfaces.
    Ultra,
}

/// Whether the processor draws. There is one adapter in a process.
static DRAWN_BY_PROCESSOR: AtomicBool = AtomicBool::new(false);

impl RenderQuality {
    /// What suits an adapter.
    #[must_use]
    pub fn for_adapter(adapter: &WgpuAdapterInfo) -> Self {
        // The type of this field is not among Bevy's exports, its name is stable.
        let kind = format!("{:?}", adapter.device_type);
        DRAWN_BY_PROCESSOR.store(kind == "Cpu", Ordering::Relaxed);
        match kind.as_str() {
            "Cpu" => Self::Low,
            "IntegratedGpu" => Self::Medium,
            _ => Self::High,
        }
    }

    /// What the player has set, and what suits the adapter if that is left to us.
    fn chosen(quality: Quality, suited: Self) -> Self {
        match quality {
            Quality::Automatic => suited,
            Quality::Low => Self::Low,
            Quality::Medium => Self::Medium,
            Quality::High => Self::High,
            Quality::Ultra => Self::Ultra,
        }
    }

    /// Whether balls and cloth follow rays: mirrored neighbours, round shadows.
    pub(super) fn traces(self) -> bool {
        self > Self::Low
    }

    /// Lamps that cast shadows.
    pub(super) fn shadows(self) -> usize {
        match self {
            Self::Low | Self::Medium => 1,
            Self::High | Self::Ultra => 3,
        }
    }

    /// Texels along one side of a shadow map.
    pub(super) fn shadow_map(self) -> usize {
        match self {
            Self::Low => 1024,
            Self::Medium | Self::High => 2048,
            Self::Ultra => 4096,
        }
    }

    /// Segments around a ball.
    pub(super) fn segments(self) -> u32 {
        match self {
            Self::Low => 32,
            Self::Medium => 48,
            Self::High => 64,
            Self::Ultra => 96,
        }
    }

    /// Samples a texture may take along its slope.
    pub(super) fn anisotropy(self) -> u16 {
        // Where a face is seen edge-on, a software driver would walk over the whole texture for each pixel, for minutes.
        if DRAWN_BY_PROCESSOR.load(Ordering::Relaxed) {
            return 1;
        }
        match self {
            Self::Low => 2,
            Self::Medium => 4,
            Self::High | Self::Ultra => 16,
        }
    }

    /// By how much a texture is finer along each side, as a power of two.
    pub(super) fn finer(self) -> u32 {
        u32::from(self >= Self::High)
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
