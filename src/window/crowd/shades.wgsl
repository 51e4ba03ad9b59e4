// The shades that the balls of a crowd cast on the cloth around the point where they touch it.

#import bevy_pbr::mesh_view_bindings::view

@group(#{MATERIAL_BIND_GROUP}) @binding(0) var<uniform> radius: f32;
// As for the spheres.
@group(#{MATERIAL_BIND_GROUP}) @binding(1) var<storage, read> balls: array<vec4<u32>>;

const ABSENT: u32 = 0xffffffffu;
// Where a shade ends, R.
const END: f32 = 2.2;

struct Corner {
    @builtin(position) clip: vec4<f32>,
    // From the point of touch, R.
    @location(0) offset: vec2<f32>,
}

@vertex
fn vertex(@location(0) corner: vec3<f32>) -> Corner {
    let record = balls[u32(corner.z)];
    var out: Corner;
    out.offset = END * corner.xy;
    let touch = vec3(bitcast<f32>(record.x), 0.02 * radius, bitcast<f32>(record.y));
    out.clip = view.clip_from_world * vec4(touch + radius * vec3(out.offset.x, 0.0, -out.offset.y), 1.0);
    if record.z == ABSENT {
        out.clip = vec4(0.0, 0.0, -1.0, 1.0);
    }
    return out;
}

@fragment
fn fragment(in: Corner) -> @location(0) vec4<f32> {
    let square = dot(in.offset, in.offset);
    let fade = 1.0 - square / (END * END);
    if fade <= 0.0 {
        discard;
    }
    // The share of the sky that the sphere hides.
    return vec4(0.0, 0.0, 0.0, 0.75 * fade * pow(1.0 + square, -1.5));
}
