// What stands around a point of the table, small enough to follow rays through it: the balls, the cloth, the rails, the
// lamps, and the room beyond as a picture.

#define_import_path masse::stage

#import bevy_pbr::{
    clustered_forward,
    lighting::getDistanceAttenuation,
    mesh_view_bindings as bindings,
    mesh_view_types,
    shadows::fetch_spot_shadow,
}

// half the cloth in x and z, height of the noses, height of the wood
// number of balls, from nose to wood, width of the wood, whether the cloth is worn
// colour of the cloth; brightness of the room's picture
// colour of the wood
// lamps: half length, half width, distance from one to the next, how many
// light of a lamp; its height
// light of the room from above; whether lamps are round
// light of the room from the side
// then for each ball: centre and radius; colour and marking; turn
@group(#{MATERIAL_BIND_GROUP}) @binding(100) var<storage, read> stage: array<vec4<f32>>;
@group(#{MATERIAL_BIND_GROUP}) @binding(101) var room: texture_cube<f32>;
@group(#{MATERIAL_BIND_GROUP}) @binding(102) var room_sampler: sampler;

const HEAD: u32 = 8u;
const IVORY = vec3<f32>(0.85, 0.80, 0.65);
const FAR: f32 = 1e6;
// Sine of half the angle that the row of lamps fills.
const WIDE: f32 = 0.22;

fn balls() -> u32 {
    return u32(stage[1].x);
}

fn ball(i: u32) -> vec4<f32> {
    return stage[HEAD + 3u * i];
}

// The share of a lamp, seen this wide, that a ball hides from a point.
fn hidden(place: vec3<f32>, to_lamp: vec3<f32>, lamp_size: f32, one: vec4<f32>) -> f32 {
    let way = one.xyz - place;
    let distance = length(way);
    let along = dot(way, to_lamp);
    let reach = one.w + 1.1 * lamp_size * along;
    if along < 0.0 || distance <= one.w || distance * distance - along * along > reach * reach {
        return 0.0;
    }
    let size = asin(one.w / distance);
    let angle = acos(clamp(along / distance, -1.0, 1.0));
    let share = min(1.0, (size * size) / (lamp_size * lamp_size));
    return share * (1.0 - smoothstep(abs(size - lamp_size), size + lamp_size, angle));
}

// The share of a cosine-weighted sky over a surface that the balls leave open, `own` is the ball that has the surface.
fn open_sky(place: vec3<f32>, normal: vec3<f32>, own: vec3<f32>) -> f32 {
    var open = 1.0;
    for (var i = 0u; i < balls(); i++) {
        let one = ball(i);
        let way = one.xyz - place;
        let square = dot(way, way);
        if distance(one.xyz, own) < 0.1 * one.w || square > 36.0 * one.w * one.w {
            continue;
        }
        let far = sqrt(square);
        let facing = clamp(0.5 + 0.5 * dot(normal, way) / far, 0.0, 1.0);
        let cosine = max(dot(normal, way) / far, 0.35 * facing * facing);
        open *= 1.0 - 0.85 * cosine * min(1.0, one.w * one.w / square);
    }
    return open;
}

// Lamplight on a surface, with round soft shadows of the balls; `maps` asks for the shadows of cue and rails too.
fn lamplight(place: vec3<f32>, normal: vec3<f32>, own: vec3<f32>, pixel: vec2<f32>, maps: bool) -> vec3<f32> {
    var sum = vec3(0.0);
    let ranges = clustered_forward::unpack_clusterable_object_index_ranges(0u);
    for (var i = ranges.first_spot_light_index_offset; i < ranges.first_reflection_probe_index_offset; i++) {
        let id = clustered_forward::get_clusterable_object_id(i);
        let lamp = &bindings::clustered_lights.data[id];
        let way = (*lamp).position_radius.xyz - place;
        let square = dot(way, way);
        let far = sqrt(square);
        let to_lamp = way / far;
        let lamp_size = min(0.24 / far, 0.7);
        // A wide lamp sinks behind the horizon bit by bit.
        let raw = dot(normal, to_lamp);
        let cosine = select(max(raw, 0.0), (raw + WIDE) * (raw + WIDE) / (4.0 * WIDE), abs(raw) < WIDE);
        if cosine <= 0.0 {
            continue;
        }
        var axis = vec3((*lamp).light_custom_data.x, 0.0, (*lamp).light_custom_data.y);
        axis.y = sqrt(max(0.0, 1.0 - dot(axis, axis)));
        if ((*lamp).flags & mesh_view_types::POINT_LIGHT_FLAGS_SPOT_LIGHT_Y_NEGATIVE) != 0u {
            axis.y = -axis.y;
        }
        let cone = saturate(dot(-axis, to_lamp) * (*lamp).light_custom_data.z + (*lamp).light_custom_data.w);
        var light = cosine * cone * cone * getDistanceAttenuation(square, (*lamp).color_inverse_square_range.w);
        for (var k = 0u; k < balls(); k++) {
            let one = ball(k);
            if distance(one.xyz, own) < 0.1 * one.w {
                continue;
            }
            light *= 1.0 - hidden(place, to_lamp, lamp_size, one);
        }
        if maps && light > 0.0 && ((*lamp).flags & mesh_view_types::POINT_LIGHT_FLAGS_SHADOWS_ENABLED_BIT) != 0u {
            light *= fetch_spot_shadow(id, vec4(place, 1.0), normal, (*lamp).shadow_map_near_z, pixel);
        }
        sum += light * (*lamp).color_inverse_square_range.rgb;
    }
    return sum / 3.14159265;
}

// Light of the room, without the lamps, on a surface.
fn roomlight(normal: vec3<f32>) -> vec3<f32> {
    let up = 0.5 + 0.5 * normal.y;
    return mix(stage[7].rgb, stage[6].rgb, up * up);
}

// The cloth as it is seen from a ball: lit, shaded, without threads.
fn cloth_light(place: vec3<f32>) -> vec3<f32> {
    let up = vec3(0.0, 1.0, 0.0);
    let nowhere = vec3(FAR);
    let light = lamplight(place, up, nowhere, vec2(0.0), false) + roomlight(up);
    return stage[2].rgb * light * open_sky(place, up, nowhere);
}

fn turned_back(turn: vec4<f32>, direction: vec3<f32>) -> vec3<f32> {
    let back = -turn.xyz;
    return direction + 2.0 * cross(back, cross(back, direction) + turn.w * direction);
}

// The paint of a ball where its surface faces this way.
fn paint(i: u32, normal: vec3<f32>) -> vec3<f32> {
    let look = stage[HEAD + 3u * i + 1u];
    let at = turned_back(stage[HEAD + 3u * i + 2u], normal);
    var colour = look.rgb;
    if look.w > 0.5 {
        if look.w > 1.5 {
            colour = mix(colour, IVORY, smoothstep(0.52, 0.56, abs(at.y)));
        }
        colour = mix(colour, IVORY, 1.0 - smoothstep(0.38, 0.42, length(at.yz)));
    }
    return colour;
}

// From 0 to 1 as `x` passes zero, over `width` to both sides.
fn soft(x: f32, width: f32) -> f32 {
    return smoothstep(-width, width, x);
}

// What the lamps show to a ray that goes up.
fn lamps(place: vec3<f32>, ray: vec3<f32>, blur: f32) -> vec3<f32> {
    let height = stage[5].w - place.y;
    if ray.y <= 0.02 {
        return vec3(0.0);
    }
    let reach = height / ray.y;
    let at = place.xz + reach * ray.xz;
    let width = max(blur * reach / ray.y, 0.004);
    let shape = stage[4];
    // The nearest lamp of the row.
    let middle = 0.5 * (shape.w - 1.0);
    let number = clamp(round(at.x / max(shape.z, 0.01) + middle), 0.0, shape.w - 1.0);
    let off = vec2(at.x - (number - middle) * shape.z, at.y);
    var share: f32;
    if stage[6].w > 0.5 {
        share = soft(shape.x - length(off), width);
        // A bright bulb in a white shade.
        share *= 0.55 + 0.9 * exp(-dot(off, off) / (0.2 * shape.x * shape.x));
    } else {
        let edge = shape.xy - abs(off);
        share = soft(edge.x, width) * soft(edge.y, width);
    }
    // What is blurred over a wider area is dimmer.
    share *= (shape.x * shape.y) / ((shape.x + width) * (shape.y + width));
    return share * stage[5].rgb;
}

// What a ray meets that leaves the ball `own`.
fn seen(place: vec3<f32>, ray: vec3<f32>, own: vec3<f32>, blur: f32) -> vec3<f32> {
    var nearest = FAR;
    var met = 0u;
    for (var i = 0u; i < balls(); i++) {
        let one = ball(i);
        if distance(one.xyz, own) < 0.1 * one.w {
            continue;
        }
        let way = one.xyz - place;
        let along = dot(way, ray);
        let depth = one.w * one.w - dot(way, way) + along * along;
        if along > 0.0 && depth > 0.0 && along - sqrt(depth) < nearest {
            nearest = along - sqrt(depth);
            met = i;
        }
    }
    let half = stage[0].xy;
    // Out over the edge of the cloth after this way.
    let walls = (select(-half, half, ray.xz > vec2(0.0)) - place.xz) / ray.xz;
    let edge = max(min(walls.x, walls.y), 0.0);
    if ray.y < -1e-4 {
        let down = -place.y / ray.y;
        if down < nearest && down <= edge {
            return cloth_light(place + down * ray);
        }
    }
    if nearest < edge {
        let at = place + nearest * ray;
        let one = ball(met);
        let normal = (at - one.xyz) / one.w;
        let light = lamplight(at, normal, one.xyz, vec2(0.0), false);
        let up = 0.5 + 0.5 * normal.y;
        let around = mix(0.5 * stage[2].rgb * stage[6].rgb, roomlight(normal), up);
        let mirrored = reflect(ray, normal);
        let shine = 0.05 * lamps(at, mirrored, max(4.0 * blur, 0.02));
        return paint(met, normal) * (light + around) * open_sky(at, normal, one.xyz) + shine;
    }
    let at_edge = place.y + edge * ray.y;
    if at_edge < stage[0].z {
        // The face of the cushion, dark below the nose.
        let inwards = select(vec3(0.0, 0.0, -sign(ray.z)), vec3(-sign(ray.x), 0.0, 0.0), walls.x < walls.y);
        let at = place + edge * ray;
        let light = lamplight(at, normalize(inwards + vec3(0.0, 0.5, 0.0)), vec3(FAR), vec2(0.0), false);
        return stage[2].rgb * (light + 0.5 * stage[7].rgb) * (0.35 + 0.65 * smoothstep(0.0, stage[0].z, at.y));
    }
    if ray.y < -1e-4 {
        // Over the nose onto the top of the rail: cloth, then wood.
        let down = (stage[0].w - place.y) / ray.y;
        let at = abs(place.xz + down * ray.xz) - half;
        let out = max(at.x, at.y);
        if out < stage[1].y + stage[1].z {
            let colour = select(stage[3].rgb, stage[2].rgb, out < stage[1].y);
            let top = place + down * ray;
            return colour * (lamplight(top, vec3(0.0, 1.0, 0.0), vec3(FAR), vec2(0.0), false) + stage[6].rgb);
        }
    }
    return lamps(place, ray, blur) + beyond(ray, blur);
}

// The room as a picture.
fn beyond(ray: vec3<f32>, blur: f32) -> vec3<f32> {
    let level = clamp(log2(max(blur, 1e-4) * 64.0), 0.0, 6.0);
    return stage[2].w * textureSampleLevel(room, room_sampler, vec3(ray.xy, -ray.z), level).rgb;
}
