// Lacquered wood, leather, metal, inlay: they mirror the lamps and the room, and no highlight is narrower than a pixel.

#import bevy_pbr::{
    forward_io::{FragmentOutput, VertexOutput},
    mesh_view_bindings::view,
    pbr_fragment::pbr_input_from_standard_material,
    pbr_functions::{apply_pbr_lighting, main_pass_post_lighting_processing},
}
#ifdef TRACED
#import masse::stage::{beyond, lamplight, lamps, open_sky, roomlight, stage}
#endif

// A roughness as materials have it, widened by the square of a slope.
fn widened(roughness: f32, slope: f32) -> f32 {
    let square = roughness * roughness;
    return sqrt(sqrt(saturate(square * square + slope)));
}

#ifdef TRACED
// The sheen of the lamps in a surface this rough (Walter et al. 2007, with the visibility of Kelemen 2001).
fn sheen(place: vec3<f32>, normal: vec3<f32>, to_eye: vec3<f32>, rough: f32, tint: vec3<f32>) -> vec3<f32> {
    let shape = stage[4];
    let apart = select(0.6 * shape.x, shape.z, stage[6].w > 0.5);
    // A third of all their light; mirrors show them brighter than they are.
    let power = 0.8 * shape.x * shape.y * shape.w * stage[5].rgb;
    // Seen from here a lamp is no point.
    let square = rough * rough + 0.006;
    var sum = 0.0;
    for (var i = -1; i < 2; i++) {
        let way = vec3(f32(i) * apart, stage[5].w, 0.0) - place;
        let to_lamp = normalize(way);
        let middle = normalize(to_lamp + to_eye);
        let facing = saturate(dot(normal, middle));
        let bend = facing * facing * (square - 1.0) + 1.0;
        let meets = max(dot(to_lamp, middle), 0.1);
        let comes = saturate(dot(normal, to_lamp)) * saturate(to_lamp.y) / dot(way, way);
        sum += square * comes / (3.14159265 * bend * bend * 4.0 * meets * meets);
    }
    // The table is between the lamps and what is below it.
    return smoothstep(-0.05, 0.0, place.y) * sum * power * tint;
}
#endif

@fragment
fn fragment(in: VertexOutput, @builtin(front_facing) is_front: bool) -> FragmentOutput {
    var input = pbr_input_from_standard_material(in, is_front);
    var out: FragmentOutput;
    // An edge that turns within a pixel is as rough as it turns (Tokuyoshi and Kaplanyan 2019, equation 3).
    let across = dpdx(in.world_normal);
    let along = dpdy(in.world_normal);
    let slope = min(0.5 * (dot(across, across) + dot(along, along)), 0.18);
    let rough = widened(input.material.perceptual_roughness, slope);
    let coat_rough = widened(input.material.clearcoat_perceptual_roughness, slope);
#ifdef TRACED
    let place = in.world_position.xyz;
    let nowhere = vec3(1e6);
    let normal = input.N;
    let facing = saturate(dot(normal, input.V));
    let base = input.material.base_color.rgb;
    let metallic = input.material.metallic;
    let coat = input.material.clearcoat;
    let reflectance = input.material.reflectance;
    let spread = mix(rough * rough, coat_rough * coat_rough, coat);
    let straight = mix(mix(0.16 * reflectance * reflectance, vec3(0.04), coat), base, metallic);
    let gain = max(vec3(1.0 - spread), straight) - straight;
    let fresnel = straight + gain * pow(1.0 - facing, 5.0);
    let ray = reflect(-input.V, normal);
    let blur = 0.006 + 1.4 * spread;
    // Little of the room is seen from inside a pocket.
    let half = stage[0].xy + stage[1].y + 0.9 * stage[1].z;
    let inside = all(abs(place.xz) < half);
    let free = select(1.0, smoothstep(-0.05, 0.5 * stage[0].w, place.y), inside);
    // Lacquer mirrors the lamps; what lies bare, or below it, shines by them.
    let mirrored = free * (coat * lamps(place, ray, blur) + beyond(ray, blur));
    let below = mix(0.16 * reflectance * reflectance, base, metallic);
    let shine = free * sheen(place, normal, input.V, rough * rough, below);
    let direct = lamplight(place, normal, nowhere, in.position.xy, true);
    let around = roomlight(normal) * open_sky(place, normal, nowhere) * input.diffuse_occlusion;
    let light = base * (1.0 - metallic) * (1.0 - fresnel) * (direct + around) + fresnel * mirrored + shine;
    out.color = vec4(view.exposure * light, 1.0);
#else
    input.material.perceptual_roughness = rough;
    input.material.clearcoat_perceptual_roughness = coat_rough;
    out.color = apply_pbr_lighting(input);
#endif
    out.color = main_pass_post_lighting_processing(input, out.color);
    return out;
}
