//! What shaders know of the table: balls, cloth, rails, lamps and the room, in one small buffer, so that balls mirror
//! what is around them and cast round soft shadows. Used from [`RenderQuality::Medium`] on.

mod materials;

pub(super) use materials::{BallMaterial, ClothMaterial, Gloss, PolishMaterial};

use bevy::asset::{RenderAssetUsages, embedded_asset};
use bevy::light::NotShadowCaster;
use bevy::prelude::*;
use bevy::render::storage::ShaderBuffer;
use bevy::shader::load_shader_library;

use crate::sim::components::{BallIndex, BallName, Radius};
use crate::sim::playfield::Playfield;
use crate::window::render::Drawing;
use crate::window::render::balls::{Globe, Marking, look};
use crate::window::render::quality::RenderQuality;
use crate::window::render::room::Fixture;
use crate::window::render::studio::{self, Studio};
use crate::window::render::table::{Dyes, Measures};

/// Most balls that rays look for; where there are more, shadow maps and painted shades do.
const MOST: usize = 32;

/// Numbers of four before the balls.
const HEAD: usize = 8;

/// The buffer as the shaders see it.
#[derive(Resource)]
pub(super) struct Stage {
    buffer: Handle<ShaderBuffer>,
    sent: Vec<f32>,
    /// Whether the balls of this frame are in it.
    pub(super) traces: bool,
}

impl FromWorld for Stage {
    fn from_world(world: &mut World) -> Self {
        let blank = vec![0.0; 4 * (HEAD + 3 * MOST)];
        let buffer = ShaderBuffer::new(&bytes(&blank), RenderAssetUsages::RENDER_WORLD);
        let buffer = world.resource_mut::<Assets<ShaderBuffer>>().add(buffer);
        Self {
            buffer,
            sent: blank,
            traces: false,
        }
    }
}

impl Stage {
    /// The part of a material that knows the stage.
    pub fn gloss(&self, quality: RenderQuality, studio: &Studio) -> Gloss {
        Gloss {
            stage: self.buffer.clone(),
            room: studio.beyond(),
            traced: quality.traces(),
        }
    }
}

pub(super) fn plugin(app: &mut App) {
    load_shader_library!(app, "stage.wgsl");
    embedded_asset!(app, "ball.wgsl");
    embedded_asset!(app, "cloth.wgsl");
    embedded_asset!(app, "polish.wgsl");
    app.init_asset::<ShaderBuffer>()
        .init_resource::<Stage>()
        .add_plugins((
            MaterialPlugin::<BallMaterial>::default(),
            MaterialPlugin::<ClothMaterial>::default(),
            MaterialPlugin::<PolishMaterial>::default(),
        ))
        .add_systems(RunFixedMainLoop, tell.in_set(Drawing::Stage));
}

/// Tells the shaders what has changed.
#[expect(clippy::too_many_arguments, reason = "everything that can be mirrored")]
fn tell(
    mut commands: Commands,
    mut stage: ResMut<Stage>,
    mut buffers: ResMut<Assets<ShaderBuffer>>,
    playfield: Res<Playfield>,
    quality: Res<RenderQuality>,
    fixture: Res<Fixture>,
    dyes: Res<Dyes>,
    balls: Query<(&BallName, &Radius, &Transform, &Visibility, &Children), With<BallIndex>>,
    globes: Query<(Entity, &Transform, Has<NotShadowCaster>), (With<Globe>, Without<BallIndex>)>,
) {
    let count = balls.iter().len();
    let traces = quality.traces() && (1..=MOST).contains(&count);
    if stage.traces != traces {
        stage.traces = traces;
    }
    let measures = Measures::of(&playfield.table);
    let mut data = Vec::with_capacity(4 * (HEAD + 3 * MOST));
    let mut push = |one: [f32; 4]| data.extend(one);
    let worn = measures.half.max_element() < 3.0 && !playfield.solver.is_crowd();
    let seen = if traces { count } else { 0 };
    push(
        [
            measures.half.x,
            measures.half.y,
            measures.nose,
            measures.top,
        ]
        .map(|x| x as f32),
    );
    push([
        seen as f32,
        measures.depth as f32,
        measures.rail as f32,
        f32::from(worn),
    ]);
    push(dyes.cloth.extend(studio::BRIGHTNESS).to_array());
    push(dyes.wood.extend(0.0).to_array());
    push([
        fixture.half.x,
        fixture.half.y,
        fixture.apart,
        fixture.count as f32,
    ]);
    push(fixture.light.extend(fixture.height).to_array());
    push(
        (studio::BRIGHTNESS * studio::soft(Vec3::Y))
            .extend(f32::from(fixture.is_round))
            .to_array(),
    );
    push(
        (studio::BRIGHTNESS * studio::soft(Vec3::NEG_Y))
            .extend(0.0)
            .to_array(),
    );
    for (name, radius, place, visibility, children) in balls.iter().take(seen) {
        // What has fallen into a pocket is out of the way.
        let shown = *visibility != Visibility::Hidden;
        let center = if shown {
            place.translation
        } else {
            Vec3::NEG_Y * 100.0
        };
        let (colour, marking) = look(&name.0);
        let [r, g, b] = colour.map(|c| Color::srgb(c, c, c).to_linear().red);
        let kind = match marking {
            Marking::Dots => 0.0,
            Marking::Solid(_) => 1.0,
            Marking::Stripe(_) => 2.0,
        };
        let turn = globes
            .iter_many(children)
            .next()
            .map_or(Quat::IDENTITY, |(_, globe, _)| globe.rotation);
        push(center.extend(radius.0 as f32).to_array());
        push([r, g, b, kind]);
        push(turn.to_array());
    }
    data.resize(4 * (HEAD + 3 * MOST), 0.0);
    if stage.sent != data {
        if let Some(mut buffer) = buffers.get_mut(&stage.buffer) {
            buffer.data = Some(bytes(&data));
        }
        stage.sent = data;
    }
    // Balls that shaders know cast their shadows by rays.
    for (globe, _, casts_none) in &globes {
        if traces && !casts_none {
            commands.entity(globe).insert(NotShadowCaster);
        } else if !traces && casts_none {
            commands.entity(globe).remove::<NotShadowCaster>();
        }
    }
}

fn bytes(numbers: &[f32]) -> Vec<u8> {
    numbers.iter().flat_map(|x| x.to_le_bytes()).collect()
}
