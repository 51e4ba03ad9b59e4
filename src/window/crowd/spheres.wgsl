// A crowd of equal balls: one triangle each, on which the sphere is met by the ray through the pixel.

#import bevy_pbr::{
    mesh_types::MESH_FLAGS_SHADOW_RECEIVER_BIT,
    mesh_view_bindings::view,
    pbr_functions::{apply_pbr_lighting, main_pass_post_lighting_processing},
    pbr_types::pbr_input_new,
}

struct Paint {
    // m
    radius: f32,
    // 0 by speed, 1 by spin, 2 by number
    colouring: u32,
    // Number of the ball that is watched; one that no ball has if none is.
    chosen: u32,
    // Whether the balls turn and so have markings.
    marked: u32,
}

@group(#{MATERIAL_BIND_GROUP}) @binding(0) var<uniform> paint: Paint;
// x and z of the centre as f32; speed and spin as shares of the hottest colour; the turn.
@group(#{MATERIAL_BIND_GROUP}) @binding(1) var<storage, read> balls: array<vec4<u32>>;

// In place of speed and spin: the ball is not on the table.
const ABSENT: u32 = 0xffffffffu;

struct Corner {
    @builtin(position) clip: vec4<f32>,
    // From the centre of the ball to a point of its disc, R.
#ifdef MULTISAMPLED
    @location(0) @interpolate(perspective, sample) offset: vec3<f32>,
#else
    @location(0) offset: vec3<f32>,
#endif
    @location(1) @interpolate(flat) number: u32,
    // Radius of the ball in pixels.
    @location(2) @interpolate(flat) size: f32,
}

struct Pixel {
    @location(0) colour: vec4<f32>,
    @builtin(frag_depth) depth: f32,
}

fn center_of(record: vec4<u32>) -> vec3<f32> {
    return vec3(bitcast<f32>(record.x), paint.radius, bitcast<f32>(record.y));
}

@vertex
fn vertex(@location(0) corner: vec3<f32>) -> Corner {
    var out: Corner;
    out.number = u32(corner.z);
    let record = balls[out.number];
    let center = center_of(record);
    let to_eye = view.world_position - center;
    let distance = length(to_eye);
    if record.z == ABSENT || distance <= 1.001 * paint.radius {
        out.clip = vec4(0.0, 0.0, -1.0, 1.0);
        out.offset = vec3(0.0);
        out.size = 0.0;
        return out;
    }
    // The disc through the centre that faces the eye, as wide as the cone around the sphere is there.
    let outward = to_eye / distance;
    let right = normalize(cross(view.world_from_view[1].xyz, outward));
    let up = cross(outward, right);
    let sine = paint.radius / distance;
    let width = inverseSqrt(max(1.0 - sine * sine, 1e-3));
    out.offset = (right * corner.x + up * corner.y) * width;
    out.clip = view.clip_from_world * vec4(center + paint.radius * out.offset, 1.0);
    out.size = 0.5 * view.viewport.w * view.clip_from_view[1][1] * sine;
    return out;
}

// From cold to hot.
fn heat(share: f32) -> vec3<f32> {
    var stops = array<vec3<f32>, 5>(
        vec3(0.020, 0.030, 0.300),
        vec3(0.010, 0.280, 0.620),
        vec3(0.050, 0.520, 0.130),
        vec3(0.900, 0.560, 0.020),
        vec3(0.820, 0.030, 0.015),
    );
    let at = clamp(share, 0.0, 1.0) * 4.0;
    let first = min(u32(at), 3u);
    return mix(stops[first], stops[first + 1u], at - f32(first));
}

// The colours of pool, 1 to 8.
fn pool(number: u32) -> vec3<f32> {
    var colours = array<vec3<f32>, 8>(
        vec3(0.913, 0.462, 0.002),
        vec3(0.002, 0.018, 0.264),
        vec3(0.604, 0.004, 0.004),
        vec3(0.059, 0.006, 0.133),
        vec3(0.888, 0.107, 0.002),
        vec3(0.001, 0.089, 0.020),
        vec3(0.133, 0.002, 0.005),
        vec3(0.003, 0.003, 0.003),
    );
    return colours[(number - 1u) % 8u];
}

const IVORY = vec3<f32>(0.85, 0.80, 0.65);

// A direction in the ball's own axes, by the three smallest parts of the turn.
fn unturned(packed: u32, direction: vec3<f32>) -> vec3<f32> {
    let most = packed & 3u;
    let small = vec3<u32>(packed >> 2u, packed >> 12u, packed >> 22u) & vec3(1023u);
    let parts = (vec3<f32>(small) - 511.0) / (511.0 * 1.41421356);
    let last = sqrt(max(1.0 - dot(parts, parts), 0.0));
    var turn: vec4<f32>;
    switch most {
        case 0u: { turn = vec4(last, parts.x, parts.y, parts.z); }
        case 1u: { turn = vec4(parts.x, last, parts.y, parts.z); }
        case 2u: { turn = vec4(parts.x, parts.y, last, parts.z); }
        default: { turn = vec4(parts.x, parts.y, parts.z, last); }
    }
    let back = -turn.xyz;
    return direction + 2.0 * cross(back, cross(back, direction) + turn.w * direction);
}

fn colour_of(record: vec4<u32>, number: u32, normal: vec3<f32>, size: f32) -> vec3<f32> {
    let rates = unpack2x16unorm(record.z);
    var striped = false;
    var colour: vec3<f32>;
    switch paint.colouring {
        case 0u: { colour = heat(rates.x); }
        case 1u: { colour = heat(rates.y); }
        default: {
            let name = number % 16u;
            striped = name > 8u;
            colour = pool(select(name, name - 8u, striped));
            if name == 0u { colour = IVORY; }
        }
    }
    // What turns is seen by its markings, once there are pixels enough for them.
    if paint.marked == 1u && size > 4.0 {
        let at = unturned(record.w, normal);
        let soft = 1.0 / size;
        let height = abs(at.y);
        var ivory = smoothstep(-soft, soft, height - 0.94);
        if striped {
            ivory = smoothstep(-soft, soft, height - 0.5);
        } else if paint.colouring != 2u {
            ivory = max(ivory, smoothstep(-soft, soft, 0.12 - height));
        }
        colour = mix(colour, IVORY, ivory * clamp(0.25 * size - 1.0, 0.0, 1.0));
    }
    return colour;
}

@fragment
fn fragment(in: Corner) -> Pixel {
    let record = balls[in.number];
    let center = center_of(record);
    // The foot of the centre on the ray, from the centre, in R: small numbers, however far away the eye is.
    let ray = normalize(center + paint.radius * in.offset - view.world_position);
    let foot = in.offset - ray * dot(in.offset, ray);
    let depth = 1.0 - dot(foot, foot);
    if depth < 0.0 {
        discard;
    }
    let normal = normalize(foot - ray * sqrt(depth));
    let place = vec4(center + paint.radius * normal, 1.0);
    let clip = view.clip_from_world * place;

    var lit = pbr_input_new();
    lit.frag_coord = vec4(in.clip.xy, clip.z / clip.w, clip.w);
    lit.world_position = place;
    lit.world_normal = normal;
    lit.N = normal;
    lit.V = -ray;
    lit.flags = MESH_FLAGS_SHADOW_RECEIVER_BIT;
    var colour = colour_of(record, in.number, normal, in.size);
    if in.number == paint.chosen {
        colour = vec3(0.95);
    }
    lit.material.base_color = vec4(colour, 1.0);
    // Mirrored lamps on balls of a few pixels would only flicker.
    lit.material.perceptual_roughness = mix(0.6, 0.16, clamp(in.size / 12.0, 0.0, 1.0));
    lit.material.reflectance = vec3(0.55);
    // The cloth and the neighbours keep light from the lower half.
    let open = 0.5 + 0.5 * normal.y;
    lit.diffuse_occlusion = vec3(0.45 + 0.55 * open);
    lit.specular_occlusion = 0.3 + 0.7 * open;

    var out: Pixel;
    out.colour = main_pass_post_lighting_processing(lit, apply_pbr_lighting(lit));
    out.depth = clip.z / clip.w;
    return out;
}
