// Worsted cloth: threads by texture, wear by a map over the whole bed, a bloom of fibres against the light.

#import bevy_pbr::{
    forward_io::{FragmentOutput, VertexOutput},
    mesh_view_bindings::view,
    pbr_fragment::pbr_input_from_standard_material,
    pbr_functions::{apply_pbr_lighting, main_pass_post_lighting_processing},
}
#import masse::stage::stage
#ifdef TRACED
#import masse::stage::{lamplight, open_sky, roomlight}
#endif

// How light the cloth is, half for as new; how much chalk lies there.
@group(#{MATERIAL_BIND_GROUP}) @binding(103) var wear: texture_2d<f32>;
@group(#{MATERIAL_BIND_GROUP}) @binding(104) var wear_sampler: sampler;

@fragment
fn fragment(in: VertexOutput, @builtin(front_facing) is_front: bool) -> FragmentOutput {
    var input = pbr_input_from_standard_material(in, is_front);
    var out: FragmentOutput;
    let place = in.world_position.xyz;
    let half = stage[0].xy;
    // By how much the normal turns within this pixel, squared.
    let turn = vec2(length(dpdx(in.world_normal)), length(dpdy(in.world_normal)));
    let used = textureSample(wear, wear_sampler, 0.5 + 0.5 * place.xz / half).rg;
    if stage[1].w > 0.5 && place.y < 0.002 {
        let colour = input.material.base_color.rgb * (0.6 + 0.8 * used.r);
        input.material.base_color = vec4(mix(colour, vec3(0.32, 0.42, 0.50), 0.5 * used.g), 1.0);
    }
#ifdef TRACED
    let nowhere = vec3(1e6);
    let to_eye = input.V;
    let facing = saturate(dot(input.N, to_eye));
    let open = open_sky(place, input.world_normal, nowhere);
    let direct = lamplight(place, input.N, nowhere, in.position.xy, true);
    let around = roomlight(input.N) * open * input.diffuse_occlusion;
    var light = input.material.base_color.rgb * (direct + around);
    // Fibres that stand up catch light at their tips.
    // Where a nose turns away within a pixel there are too few of them to be seen.
    let fuzz = pow(1.0 - facing, 3.0) / (1.0 + 30.0 * dot(turn, turn));
    light += 0.16 * fuzz * (0.35 + input.material.base_color.rgb) * (direct * 0.35 + around);
    out.color = vec4(view.exposure * light, 1.0);
#else
    out.color = apply_pbr_lighting(input);
#endif
    out.color = main_pass_post_lighting_processing(input, out.color);
    return out;
}
