//! The table, built from the geometry the balls meet. It is built anew when that geometry changes.

mod cushions;
mod frame;
mod measures;
mod noses;
mod pockets;
mod shading;
mod surfaces;
mod wear;

pub(super) use measures::{FLOOR, Measures};
pub(super) use surfaces::Dyes;

use bevy::light::{NotShadowCaster, NotShadowReceiver};
use bevy::math::{DVec2, DVec3};
use bevy::prelude::*;

use crate::game::settings::{Settings, TableStyle};
use crate::physics::table::Table;
use crate::sim::playfield::Playfield;
use crate::window::render::plan::{area, circle};
use crate::window::render::solid::Solid;
use crate::window::render::stage::{ClothMaterial, PolishMaterial, Stage};
use crate::window::render::studio::Studio;
use crate::window::render::{Drawing, quality::RenderQuality, twin};
use noses::Noses;
use surfaces::{Cover, Finish, Surfaces};

pub(super) fn plugin(app: &mut App) {
    app.init_resource::<Dyes>().add_systems(
        RunFixedMainLoop,
        build.in_set(Drawing::Table).run_if(
            resource_exists_and_changed::<Playfield>
                .or_else(resource_exists_and_changed::<Settings>)
                .or_else(resource_exists_and_changed::<RenderQuality>),
        ),
    );
}

/// A part of the drawn table.
#[derive(Component)]
struct Furniture;

/// Replaces the drawn table if its geometry is another one.
#[expect(
    clippy::too_many_arguments,
    reason = "stores of assets, and their sources"
)]
fn build(
    mut commands: Commands,
    mut meshes: ResMut<Assets<Mesh>>,
    (mut materials, mut cloths, mut polishes): (
        ResMut<Assets<StandardMaterial>>,
        ResMut<Assets<ClothMaterial>>,
        ResMut<Assets<PolishMaterial>>,
    ),
    mut images: ResMut<Assets<Image>>,
    (stage, studio, mut dyes): (Res<Stage>, Res<Studio>, ResMut<Dyes>),
    mut drawn: Local<Option<(Table, Finish, Surfaces)>>,
    playfield: Res<Playfield>,
    quality: Res<RenderQuality>,
    settings: Res<Settings>,
    old: Query<Entity, With<Furniture>>,
) {
    let table = &playfield.table;
    let finish = Finish {
        quality: *quality,
        cloth: settings.cloth,
        wood: settings.wood,
        style: settings.table,
    };
    let surfaces = match drawn.take() {
        Some((old, as_now, surfaces)) if as_now == finish => {
            if old == *table {
                *drawn = Some((old, as_now, surfaces));
                return;
            }
            surfaces
        }
        _ => {
            *dyes = finish.dyes();
            let gloss = stage.gloss(*quality, &studio);
            Surfaces::new(
                finish,
                gloss,
                &mut images,
                &mut materials,
                &mut cloths,
                &mut polishes,
            )
        }
    };
    for entity in &old {
        commands.entity(entity).despawn();
    }
    for part in parts(table, settings.table) {
        if part.solid.is_empty() {
            continue;
        }
        let mut entity = commands.spawn((
            Furniture,
            Mesh3d(meshes.add(part.solid.mesh())),
            twin::both(),
        ));
        match surfaces.get(part.surface) {
            Cover::Cloth(cloth) => entity.insert(MeshMaterial3d(cloth)),
            Cover::Polished(material) => entity.insert(MeshMaterial3d(material)),
            Cover::Plain(material) => entity.insert(MeshMaterial3d(material)),
        };
        if !part.casts_shadow {
            entity.insert(NotShadowCaster);
        }
    }
    commands.spawn((
        Furniture,
        Mesh3d(meshes.add(shading::below_noses(table))),
        MeshMaterial3d(surfaces.shade()),
        NotShadowCaster,
        NotShadowReceiver,
        twin::both(),
    ));
    *drawn = Some((table.clone(), finish, surfaces));
}

/// What a part is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Surface {
    Cloth,
    Wood,
    Rim,
    Metal,
    Pearl,
    Hole,
    Mark,
}

struct Part {
    surface: Surface,
    solid: Solid,
    casts_shadow: bool,
}

impl Part {
    fn new(surface: Surface, grain: DVec3, casts_shadow: bool) -> Self {
        let tile = match surface {
            Surface::Wood => 0.6,
            _ => surfaces::CLOTH_TILE,
        };
        Self {
            surface,
            solid: Solid::new(grain, tile),
            casts_shadow,
        }
    }
}

/// Every part of a table.
fn parts(table: &Table, style: TableStyle) -> Vec<Part> {
    let measures = Measures::of(table);
    let noses = Noses::of(table, &measures);
    let holes: Vec<Vec<DVec2>> = table
        .pockets
        .iter()
        .map(|pocket| circle(pocket.center, pocket.radius, pockets::SIDES))
        .collect();
    let cuts: Vec<Vec<DVec2>> = table
        .pockets
        .iter()
        .map(|pocket| {
            circle(
                pocket.center,
                pocket.radius + 0.7 * measures.rim,
                pockets::SIDES,
            )
        })
        .collect();

    let mut bed = Part::new(Surface::Cloth, DVec3::X, false);
    let corner = measures.inner();
    let outline = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
        .map(|(x, z)| corner * DVec2::new(x, z));
    for part in area(&outline, &holes) {
        bed.solid.lid(part, 0.0);
    }

    // Out of sight: it keeps the light of the lamps from the floor.
    let mut bottom = Part::new(Surface::Hole, DVec3::X, true);
    let under = measures.outer() - (frame::STEP + 0.001) * measures.scale;
    bottom
        .solid
        .lid(outline.map(|p| p * under / corner), measures.apron);

    let mut cushions = Part::new(Surface::Cloth, DVec3::X, true);
    for points in &noses.rails {
        cushions::cushion(&mut cushions.solid, points, &measures);
    }

    let mut long = Part::new(Surface::Wood, DVec3::X, false);
    let mut short = Part::new(Surface::Wood, DVec3::Z, false);
    frame::rails(&mut long.solid, &measures, &cuts, true);
    frame::rails(&mut short.solid, &measures, &cuts, false);
    frame::skirt(&mut long.solid, &measures);

    let mut upright = Part::new(Surface::Wood, DVec3::Y, true);
    frame::legs(&mut upright.solid, &measures, style);
    for line in &noses.walls {
        cushions::wall(&mut upright.solid, line, &measures);
    }
    for arc in &noses.pegs {
        cushions::peg(&mut upright.solid, arc, &measures);
    }

    let mut rims = Part::new(Surface::Rim, DVec3::X, false);
    let mut metal = Part::new(Surface::Metal, DVec3::X, false);
    for pocket in &table.pockets {
        pockets::lip(&mut bed.solid, pocket, &measures);
        pockets::leather(&mut rims.solid, pocket, &measures, style);
        if style != TableStyle::Modern {
            pockets::ring(&mut metal.solid, pocket, &measures);
        }
    }
    match style {
        TableStyle::BarBox => frame::corners(&mut metal.solid, &measures, &cuts),
        TableStyle::Modern => frame::strip(&mut metal.solid, &measures),
        TableStyle::Classic => {}
    }

    let mut pearl = Part::new(Surface::Pearl, DVec3::X, false);
    frame::diamonds(&mut pearl.solid, &measures, &cuts, style);

    let mut marks = Part::new(Surface::Mark, DVec3::X, false);
    for spot in [table.foot_spot(), table.head_spot()] {
        let round = circle(spot, 0.004 * measures.scale, 16);
        for part in area(&round, &[]) {
            marks.solid.lid(part, 4e-4);
        }
    }
    vec![
        bed, bottom, cushions, long, short, upright, rims, metal, pearl, marks,
    ]
}
