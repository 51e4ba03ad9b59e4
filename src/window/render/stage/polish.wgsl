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
    let mirrored = free * (lamps(place, ray, blur) + beyond(ray, blur));
    let direct = lamplight(place, normal, nowhere, in.position.xy, true);
    let around = roomlight(normal) * open_sky(place, normal, nowhere) * input.diffuse_occlusion;
    let light = base * (1.0 - metallic) * (1.0 - fresnel) * (direct + around) + fresnel * mirrored;
    out.color = vec4(view.exposure * light, 1.0);
#else
    input.material.perceptual_roughness = rough;
    input.material.clearcoat_perceptual_roughness = coat_rough;
    out.color = apply_pbr_lighting(input);
#endif
    out.color = main_pass_post_lighting_processing(input, out.color);
    return out;
}
