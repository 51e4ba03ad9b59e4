// A ball of polished resin: paint below a clear layer that mirrors lamps, neighbours, cloth, rails and the room.

#import bevy_pbr::{
    forward_io::{FragmentOutput, VertexOutput},
    mesh_functions::get_world_from_local,
    mesh_view_bindings::view,
    pbr_fragment::pbr_input_from_standard_material,
    pbr_functions::{apply_pbr_lighting, main_pass_post_lighting_processing},
}
#ifdef TRACED
#import masse::stage::{cloth_light, lamplight, open_sky, roomlight, seen, stage}
#endif

@fragment
fn fragment(in: VertexOutput, @builtin(front_facing) is_front: bool) -> FragmentOutput {
    var input = pbr_input_from_standard_material(in, is_front);
    var out: FragmentOutput;
#ifdef TRACED
    let world = get_world_from_local(in.instance_index);
    let center = world[3].xyz;
    let radius = length(world[0].xyz);
    // The mesh has corners, the ball has none.
    let normal = normalize(in.world_position.xyz - center);
    let place = center + radius * normal;
    let to_eye = normalize(view.world_position - place);
    let facing = saturate(dot(normal, to_eye));
    let ray = reflect(-to_eye, normal);
    // How far the mirrored ray turns from one pixel to the next.
    let pixel = 2.0 / (view.viewport.w * view.clip_from_view[1][1]);
    let away = distance(view.world_position, place);
    let blur = 0.6 * pixel * (1.0 + 2.0 * away / (radius * max(facing, 0.12))) + 0.004;

    let open = open_sky(place, normal, center);
    let below = 0.5 - 0.5 * normal.y;
    // Right above the point of touch there is little light.
    let lift = 0.35 + 1.05 * smoothstep(0.0, 1.4, place.y / radius);
    let bounced = cloth_light(vec3(center.x + 1.6 * radius * normal.x, 0.0, center.z + 1.6 * radius * normal.z));
    let around = mix(roomlight(normal), bounced * lift, below);
    let direct = lamplight(place, normal, center, in.position.xy, true);
    let fresnel = 0.05 + 0.95 * pow(1.0 - facing, 5.0);
    var light = input.material.base_color.rgb * (1.0 - fresnel) * (direct + around * open);
    light += fresnel * seen(place + 1e-4 * normal, ray, center, blur);
    out.color = vec4(view.exposure * light, 1.0);
#else
    out.color = apply_pbr_lighting(input);
#endif
    out.color = main_pass_post_lighting_processing(input, out.color);
    return out;
}
